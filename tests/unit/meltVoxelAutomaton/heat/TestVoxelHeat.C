/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltVoxelAutomaton/voxelTestTools.H"
#include "voxelConduction.H"
#include "voxelRays.H"

#include <gtest/gtest.h>

using namespace unitTest;

namespace
{

const double dx = 1e-2;

//- A full cube of solid of one conductivity at T(x, y, z)
template<class Temperature>
voxelGrid* cube(const int n, const Temperature& T)
{
    voxelMaterial material(wax(dx));
    material.kappaLiquid = material.kappaSolid;
    auto* grid = new voxelGrid({n, n, n}, dx, material);
    for (int x = 0; x < n; ++x)
    {
        for (int y = 0; y < n; ++y)
        {
            for (int z = 0; z < n; ++z)
            {
                grid->fill(x, y, z, 1, T(x, y, z));
            }
        }
    }
    grid->refresh();
    return grid;
}

} // End anonymous namespace


// The symbol of the rule for a wave of temperature, with gamma by which the
// paper's rule has the material's diffusivity
TEST(VoxelConduction, symbolOfTheRule)
{
    // What a unit of enthalpy is, times the neighbours
    const double roundOff = 2e-9;
    const int n = 24;
    for (const int neighbours : {6, 18, 26})
    {
        const double k[3] = {0.3, 0.45, 0.7};
        const double amplitude = 10;
        const std::unique_ptr<voxelGrid> grid
        (
            cube
            (
                n,
                [&](const int x, const int y, const int z)
                {
                    return
                        280 + amplitude*std::cos(k[0]*x + k[1]*y + k[2]*z);
                }
            )
        );
        voxelConduction conduction(neighbours);
        const double dt = 0.5*conduction.maxDeltaT(*grid);
        const double alpha = 0.2/(1000*1000);
        const double f = neighbours == 6 ? 1 : neighbours == 18 ? 3 : 13.0/3;
        const int farthest = neighbours == 6 ? 1 : neighbours == 18 ? 2 : 3;
        double gain = 1;
        for (int i = 0; i < 27; ++i)
        {
            const int a = i/9 - 1, b = i/3 % 3 - 1, c = i % 3 - 1;
            const int l2 = a*a + b*b + c*c;
            if (l2 > 0 && l2 <= farthest)
            {
                gain +=
                    alpha*dt/(dx*dx)/(f*l2)
                   *(std::cos(k[0]*a + k[1]*b + k[2]*c) - 1);
            }
        }
        const int m = n/2;
        const double before = grid->T(m, m, m) - 280;
        conduction.conduct(*grid, dt);
        EXPECT_NEAR((grid->T(m, m, m) - 280)/before, gain, roundOff)
            << neighbours << " neighbours";
    }
}


// A wave of temperature along rods and sheets with adiabatic sides decays as in
// one dimension, also where diagonal neighbours are missing
TEST(VoxelConduction, sidesAreAMirror)
{
    const int n = 16;
    const double k = M_PI/n, alpha = 0.2/(1000*1000);
    voxelMaterial material(wax(dx));
    material.kappaLiquid = material.kappaSolid;
    for (const int neighbours : {6, 18, 26})
    {
        for (const int width : {1, 2, 3})
        {
            for (const int height : {1, 4})
            {
                voxelGrid grid({n, 5, 6}, dx, material);
                for (int i = 0; i < n*width*height; ++i)
                {
                    const int x = i/(width*height), y = i/height % width;
                    grid.fill
                    (
                        x, y + 1, i % height, 1, 280 + 10*std::cos(k*(x + 0.5))
                    );
                }
                grid.refresh();
                voxelConduction conduction(neighbours);
                const double dt = conduction.maxDeltaT(grid);
                const double before = grid.T(3, 1, 0) - 280;
                conduction.conduct(grid, dt);
                EXPECT_NEAR
                (
                    (grid.T(3, 1, 0) - 280)/before,
                    1 + 2*alpha*dt/(dx*dx)*(std::cos(k) - 1),
                    2e-9
                )
                    << neighbours << " neighbours, " << width << " x " << height;
            }
        }
    }
}


TEST(VoxelConduction, keepsEnthalpyAndBounds)
{
    for (const int neighbours : {6, 18, 26})
    {
        voxelGrid grid({20, 20, 20}, dx, wax(dx));
        fillRandomly(grid, 11);
        double low = 1e9, high = 0;
        const auto bounds = [&]()
        {
            double a = 1e9, b = 0;
            for (int i = 0; i < 8000; ++i)
            {
                if (grid.mass(i/400, i/20 % 20, i % 20) > 0)
                {
                    const double T = grid.T(i/400, i/20 % 20, i % 20);
                    a = std::min(a, T);
                    b = std::max(b, T);
                }
            }
            return std::make_pair(a, b);
        };
        std::tie(low, high) = bounds();
        const std::int64_t energy = grid.totalEnergy();
        voxelConduction conduction(neighbours);
        for (int step = 0; step < 200; ++step)
        {
            conduction.conduct(grid, conduction.maxDeltaT(grid));
            EXPECT_EQ(grid.totalEnergy(), energy);
            const std::pair<double, double> now = bounds();
            EXPECT_GE(now.first, low - 1e-6);
            EXPECT_LE(now.second, high + 1e-6);
        }
    }
    EXPECT_THROW(voxelConduction(7), std::invalid_argument);
}


TEST(VoxelRays, blockedByWhatIsBetween)
{
    voxelGrid grid({20, 20, 20}, dx, wax(dx));
    grid.fill(10, 10, 10, 0.2, 280);
    grid.fillRock(4, 4, 4, 1);
    grid.refresh();
    EXPECT_TRUE(voxelRays::blocked(grid, {2.5, 10.5, 10.5}, {30, 10.5, 10.5}));
    EXPECT_TRUE(voxelRays::blocked(grid, {0.5, 0.5, 0.5}, {8, 8, 8}));
    EXPECT_FALSE(voxelRays::blocked(grid, {2.5, 10.5, 10.5}, {9.9, 10.5, 10.5}));
    EXPECT_FALSE(voxelRays::blocked(grid, {2.5, 11.5, 10.5}, {30, 11.5, 10.5}));
    EXPECT_FALSE(voxelRays::blocked(grid, {-5, 30, 3}, {-6, 40, 30}));
    EXPECT_FALSE(voxelRays::blocked(grid, {11, 10.5, 10.5}, {15, 10.5, 10.5}));
}

// ************************************************************************* //
