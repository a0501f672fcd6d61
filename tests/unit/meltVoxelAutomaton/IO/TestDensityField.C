/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "densityField.H"
#include "gravityRule.H"
#include "lubricationRule.H"
#include "meltVoxelAutomaton/voxelTestTools.H"

#include <gtest/gtest.h>
#include <omp.h>

using namespace unitTest;

namespace
{

const double dx = 1e-3;

double at
(
    const voxelGrid& grid,
    const densityField& density,
    const int x, const int y, const int z
)
{
    const densityField::values* b =
        density.brick(grid.brickIndex(x >> 3, y >> 3, z >> 3));
    return b ? (*b)[voxelBrick::offset(x, y, z)] : 0;
}


bool same(const voxelGrid& grid, const densityField& a, const densityField& b)
{
    const std::array<int, 3>& nb = grid.nBricks();
    for (int index = 0; index < nb[0]*nb[1]*nb[2]; ++index)
    {
        if
        (
            bool(a.brick(index)) != bool(b.brick(index))
         || (a.brick(index) && *a.brick(index) != *b.brick(index))
        )
        {
            return false;
        }
    }
    return true;
}

} // End anonymous namespace


// 1/4 1/2 1/4 across a face in the open; on rock as if melt went on below
TEST(DensityField, facesOfABlock)
{
    voxelGrid grid({24, 24, 24}, dx, wax(dx));
    for (int i = 0; i < 24*24*24; ++i)
    {
        const int x = i/576, y = i/24 % 24, z = i % 24;
        if (z < 7)
        {
            grid.fillRock(x, y, z, 1);
        }
        else if (x >= 6 && x < 18 && y >= 6 && y < 18 && z < 15)
        {
            grid.fill(x, y, z, 1, 350);
        }
    }
    grid.refresh();
    densityField density;
    EXPECT_GT(density.update(grid), 0);
    EXPECT_EQ(at(grid, density, 12, 12, 11), 1);
    EXPECT_EQ(at(grid, density, 17, 12, 11), 0.75);
    EXPECT_EQ(at(grid, density, 18, 12, 11), 0.25);
    EXPECT_EQ(at(grid, density, 19, 12, 11), 0);
    EXPECT_EQ(at(grid, density, 12, 12, 14), 0.75);
    EXPECT_EQ(at(grid, density, 12, 12, 7), 1);
    EXPECT_EQ(at(grid, density, 12, 12, 6), 1);
    EXPECT_EQ(at(grid, density, 12, 12, 5), 0);
    EXPECT_EQ(at(grid, density, 17, 17, 11), 0.5625);
}


TEST(DensityField, onlyWhatHasChangedIsFilteredAgain)
{
    voxelGrid grid({80, 80, 40}, dx, wax(dx));
    for (int x = 0; x < 80; ++x)
    {
        for (int y = 0; y < 80; ++y)
        {
            grid.fill(x, y, 0, 1, 280);
        }
    }
    grid.refresh();
    densityField density;
    EXPECT_GE(density.update(grid), 100);
    EXPECT_EQ(density.update(grid), 0);
    grid.fill(44, 44, 20, 0.3, 350);
    grid.refresh();
    EXPECT_EQ(density.update(grid), 27);
}


TEST(DensityField, followsWhateverHappens)
{
    voxelGrid grid({37, 30, 50}, dx, wax(dx), {false, true, false, false, true});
    fillRandomly(grid, 3);
    const filmViscosity film
    (
        [](double, double) { return 10.0; }, false, 250, 400, 1, 1e5, 0
    );
    lubricationRule lubrication(film, 9810, 10, 10);
    gravityRule gravity(film, 9.81, 0.004);
    densityField density;
    for (int step = 0; step < 300; ++step)
    {
        const double dt = std::min
        (
            lubrication.prepare(grid), gravity.maxDeltaT(grid)
        );
        lubrication.spread(grid, dt);
        gravity.fall(grid, dt);
        if (step % 10 == 0)
        {
            density.update(grid);
        }
    }
    density.update(grid);
    for (const int index : grid.list())
    {
        grid.own(index).unfiltered = true;
    }
    densityField anew;
    const int nThreads = omp_get_max_threads();
    omp_set_num_threads(3);
    anew.update(grid);
    omp_set_num_threads(nThreads);
    EXPECT_TRUE(same(grid, density, anew));
}

// ************************************************************************* //
