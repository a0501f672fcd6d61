/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltExtent.H"
#include "meltVoxelAutomaton/voxelTestTools.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace unitTest;

namespace
{

const double solid = 280, liquid = 350;

} // End anonymous namespace


// The share of a square on the near side of the line, by many points
TEST(MeltExtent, lineThatCutsAPartOfASquare)
{
    const int n = 400;
    for (const double angle : {0.0, 0.2, 0.5, M_PI/4})
    {
        const double a = std::cos(angle), b = std::sin(angle);
        for (const double part : {0.01, 0.1, 0.3, 0.5, 0.6, 0.95})
        {
            const double line = meltExtent::lineAt(part, a, b);
            int nBehind = 0;
            for (int i = 0; i < n*n; ++i)
            {
                const double x = (i/n + 0.5)/n - 0.5, y = (i % n + 0.5)/n - 0.5;
                nBehind += a*x + b*y < line;
            }
            EXPECT_NEAR(double(nBehind)/(n*n), part, 2.0/n) << angle;
        }
        EXPECT_NEAR(meltExtent::lineAt(1, a, b), 0.5*(a + b), 1e-15);
        EXPECT_NEAR(meltExtent::lineAt(0, a, b), -0.5*(a + b), 1e-15);
    }
}


// A box with sides within voxels, away from the floor
TEST(MeltExtent, solidBoxIsExact)
{
    const double low[3] = {3.3, 4.6, 2.5}, high[3] = {8.2, 9, 6.75};
    voxelGrid grid({12, 12, 12}, 1, wax(1));
    for (int i = 0; i < 12*12*12; ++i)
    {
        const int v[3] = {i/144, i/12 % 12, i % 12};
        double share = 1;
        for (int k = 0; k < 3; ++k)
        {
            share *= std::max
            (
                std::min(high[k], v[k] + 1.0) - std::max(low[k], double(v[k])),
                0.0
            );
        }
        if (share > 0)
        {
            grid.fill(v[0], v[1], v[2], share, solid);
        }
    }
    grid.refresh();
    const meltExtent extent(grid, {0, 6}, 0.001);
    for (int k = 0; k < 3; ++k)
    {
        EXPECT_NEAR(extent.low[k], low[k], 1e-6);
        EXPECT_NEAR(extent.high[k], high[k], 1e-6);
    }
}


// Huppert's profile: the front wherever it is within its voxel, to a quarter of it
TEST(MeltExtent, frontOfASheet)
{
    // Of h = (1 - (x/front)^2)^(1/3), by many points
    const auto column = [](const double front, const int x)
    {
        const int n = 10000;
        double sum = 0;
        for (int i = 0; i < n; ++i)
        {
            const double s = (x + (i + 0.5)/n)/front;
            sum += s < 1 ? std::cbrt(1 - s*s) : 0;
        }
        return sum/n;
    };
    for (double front = 20; front < 21; front += 0.05)
    {
        voxelGrid grid({24, 2, 2}, 1, wax(1));
        for (int x = 0; x < 24; ++x)
        {
            const double share = column(front, x);
            if (share > 0)
            {
                grid.fill(x, 0, 0, share, liquid);
                grid.fill(x, 1, 0, share, liquid);
            }
        }
        grid.refresh();
        const meltExtent extent(grid, {0, 1}, 0.001);
        EXPECT_NEAR(extent.high[0], front, 0.25);
        EXPECT_NEAR(extent.radius, front, 0.25);
        EXPECT_EQ(extent.low[0], 0);
        EXPECT_NEAR(extent.high[2], column(front, 0), 1e-6);
    }
}


// A round sheet: as far along the axes as diagonally
TEST(MeltExtent, frontIsRound)
{
    for (double R = 8; R < 9; R += 0.1)
    {
        voxelGrid grid({24, 24, 2}, 1, wax(1));
        const int m = 20;
        for (int i = 0; i < 24*24; ++i)
        {
            double share = 0;
            for (int j = 0; j < m*m; ++j)
            {
                const double x = i/24 + (j/m + 0.5)/m - 12;
                const double y = i % 24 + (j % m + 0.5)/m - 12;
                share += std::hypot(x, y) < R;
            }
            if (share > 0)
            {
                grid.fill(i/24, i % 24, 0, 0.5*share/(m*m), solid);
            }
        }
        grid.refresh();
        const meltExtent extent(grid, {12, 12}, 0.001);
        EXPECT_NEAR(extent.radius, R, 0.2);
    }
}


TEST(MeltExtent, seesNothingInAnEmptyGrid)
{
    voxelGrid grid({4, 4, 4}, 1, wax(1));
    grid.fill(1, 1, 1, 5e-4, liquid);
    grid.refresh();
    const meltExtent extent(grid, {0, 0}, 0.001);
    EXPECT_GT(extent.low[2], extent.high[2]);
    EXPECT_EQ(extent.radius, 0);
}

// ************************************************************************* //
