/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceSlope.H"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::melt;

namespace
{

using triple = staggeredGrid::triple;

//- Area of the surface of what fills the cells of a grid, 1 m each, that are in
//  a part of it, from their free areas as surfaceHeat takes them
double area
(
    const triple& n,
    const std::function<double(const triple&)>& share,
    const std::function<bool(const triple&)>& counts
)
{
    const staggeredGrid grid(n, {1, 1, 1}, {true, true, true});
    std::vector<double> alpha(grid.nCells());
    for (int i = 0; i < grid.nCells(); ++i)
    {
        alpha[i] = share(grid.position(i));
    }
    double result = 0;
    for (int i = 0; i < grid.nCells(); ++i)
    {
        if (alpha[i] == 0 || !counts(grid.position(i)))
        {
            continue;
        }
        std::vector<vector> free;
        vector sum(Zero);
        for (int side = 0; side < 6; ++side)
        {
            triple there(grid.position(i));
            const int step = side % 2 ? 1 : -1;
            there[side/2] += step;
            const double beyond =
                grid.inside(there) ? alpha[grid.cell(there)] : alpha[i];
            if (alpha[i] > beyond)
            {
                vector f(Zero);
                f[side/2] = step*(alpha[i] - beyond);
                free.push_back(f);
                sum += f;
            }
        }
        const surfaceSlope slope(grid, alpha, i);
        for (const vector& f : free)
        {
            result += magSqr(f)/mag(slope.at(f, sum));
        }
    }
    return result;
}


bool all(const triple&)
{
    return true;
}

} // End anonymous namespace


// Faces, edges and corners of boxes stand for themselves, with sides on those of
// cells, or within cells at the share given
TEST(SurfaceSlope, areaOfBoxesIsExact)
{
    for (const double s : {1.0, 0.5})
    {
        for (const triple& m : {triple{6, 6, 6}, triple{3, 4, 7}})
        {
            const auto share = [&](const triple& c)
            {
                double result = 1;
                for (int a = 0; a < 3; ++a)
                {
                    const int i = c[a] - 2;
                    result *=
                        i < 0 || i >= m[a] ? 0 : i == 0 || i == m[a] - 1 ? s : 1;
                }
                return result;
            };
            double edge[3];
            for (int a = 0; a < 3; ++a)
            {
                edge[a] = m[a] - 2 + 2*s;
            }
            EXPECT_NEAR
            (
                area({11, 11, 11}, share, all),
                2*(edge[0]*edge[1] + edge[1]*edge[2] + edge[2]*edge[0]),
                1e-12
            )
                << m[0] << " cells, share " << s;
        }
    }
    // A sheet of one cell has both its sides
    const auto sheet = [](const triple& c)
    {
        return double(c[0] > 1 && c[0] < 6 && c[1] > 1 && c[1] < 6 && c[2] == 4);
    };
    EXPECT_NEAR(area({8, 8, 8}, sheet, all), 2*16 + 4*4, 1e-12);
}


TEST(SurfaceSlope, areaOfASphere)
{
    for (const double R : {6.3, 12.3})
    {
        const int n = 2*int(R) + 8;
        const auto share = [&](const triple& c)
        {
            const vector r
            (
                c[0] - n/2 + 0.4, c[1] - n/2 + 0.4, c[2] - n/2 + 0.4
            );
            return std::clamp(0.5 - (mag(r) - R), 0.0, 1.0);
        };
        const double measured = area({n, n, n}, share, all);
        const double exact = 4*M_PI*R*R;
        std::cout << "    R = " << R << ": " << measured/exact << '\n';
        EXPECT_NEAR(measured/exact, 1, 0.04);
    }
}


// The steps of a slope stand for its plane
TEST(SurfaceSlope, areaOfASlope)
{
    for (const double slope : {0.25, 0.5, 1.0})
    {
        const auto share = [&](const triple& c)
        {
            // Mean over the cell of what is below the plane
            const int n = 50;
            double sum = 0;
            for (int k = 0; k < n; ++k)
            {
                const double z = 3.3 + slope*(c[0] + (k + 0.5)/n);
                sum += std::clamp(z - c[2], 0.0, 1.0)/n;
            }
            return sum;
        };
        const double measured = area
        (
            {24, 3, 32},
            share,
            [](const triple& c) { return c[0] >= 8 && c[0] < 16; }
        );
        const double exact = 8*3*std::sqrt(1 + slope*slope);
        std::cout << "    slope " << slope << ": " << measured/exact << '\n';
        EXPECT_NEAR(measured/exact, 1, 0.04);
    }
}

// ************************************************************************* //
