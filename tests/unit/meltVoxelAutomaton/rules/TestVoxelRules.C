/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gravityRule.H"
#include "looseSolids.H"
#include "lubricationRule.H"
#include "meltVoxelAutomaton/voxelTestTools.H"
#include "publishedRule.H"
#include "voxelConduction.H"

#include <gtest/gtest.h>
#include <omp.h>

using namespace unitTest;

namespace
{

const double dx = 1e-3;

double viscosity(const double, const double T)
{
    return 50*std::exp(0.05*(350 - T));
}


//- All rules on a random scene with an open side; checks what must hold after
//  each step and returns the fingerprint of the end
std::uint64_t run(const unsigned seed, const bool published, const int nSteps)
{
    voxelGrid grid
    (
        {37, 30, 50}, dx, wax(dx), {false, true, false, false, seed % 2 == 0}
    );
    fillRandomly(grid, seed);
    const filmViscosity film(viscosity, false, 250, 400, 1, 1e5, 0);
    lubricationRule lubrication(film, 9810, 10, 10);
    gravityRule gravity(film, 9.81, 0.004);
    looseSolids loose(9.81);
    voxelConduction conduction(18);
    publishedRule rule({0.7, 0.15, 0.2, 0.1, 0.6, 0.95, 0.9, 0.8, true, seed});

    const std::int64_t mass = grid.totalMass();
    const std::int64_t energy = grid.totalEnergy();
    for (int step = 0; step < nSteps; ++step)
    {
        const double dt = std::min
        ({
            lubrication.prepare(grid),
            gravity.maxDeltaT(grid),
            conduction.maxDeltaT(grid)
        });
        if (published)
        {
            rule.spread(grid);
            rule.fall(grid);
        }
        else
        {
            lubrication.spread(grid, dt);
            gravity.fall(grid, dt);
        }
        loose.fall(grid, dt);
        conduction.conduct(grid, dt);

        const std::int64_t lostMass =
            lubrication.lostMass() + gravity.lostMass() + rule.lostMass();
        const std::int64_t lostEnergy =
            lubrication.lostEnergy() + gravity.lostEnergy()
          + rule.lostEnergy();
        EXPECT_EQ(grid.totalMass() + lostMass, mass) << "step " << step;
        EXPECT_EQ(grid.totalEnergy() + lostEnergy, energy) << "step " << step;
        EXPECT_TRUE(withinCapacity(grid)) << "step " << step;
        if (::testing::Test::HasFailure())
        {
            break;
        }
    }
    return fingerprint(grid);
}

} // End anonymous namespace


TEST(VoxelRules, keepMassAndEnthalpyToTheLastUnit)
{
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
        run(seed, false, 150);
        run(seed, true, 150);
    }
}


TEST(VoxelRules, resultIsTheSameForAnyNumberOfThreads)
{
    const int nThreads = omp_get_max_threads();
    omp_set_num_threads(1);
    const std::uint64_t one = run(5, false, 60);
    omp_set_num_threads(3);
    const std::uint64_t three = run(5, false, 60);
    omp_set_num_threads(nThreads);
    EXPECT_EQ(one, three);
}

// ************************************************************************* //
