/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gravityRule.H"
#include "looseSolids.H"
#include "meltVoxelAutomaton/voxelTestTools.H"
#include "publishedRule.H"

#include <gtest/gtest.h>

using namespace unitTest;

namespace
{
    const double dx = 1e-3, g = 9.81;
}


TEST(LooseSolids, fallFreelyAndLand)
{
    voxelGrid grid({20, 20, 120}, dx, wax(dx));
    for (int x = 8; x < 12; ++x)
    {
        for (int y = 8; y < 12; ++y)
        {
            for (int z = 100; z < 104; ++z)
            {
                grid.fill(x, y, z, 1, 280);
            }
        }
    }
    // Stands on the floor: stays
    grid.fill(2, 2, 0, 1, 280);
    grid.refresh();

    looseSolids loose(g);
    const double dt = 1e-3;
    int step = 0;
    const auto lowest = [&]()
    {
        int z = 0;
        while (grid.phase(9, 9, z) == EMPTY)
        {
            ++z;
        }
        return z;
    };
    for (; step < 100; ++step)
    {
        loose.fall(grid, dt);
    }
    const double way = 0.5*g*std::pow(step*dt, 2)/dx;
    EXPECT_NEAR(100 - lowest(), way, 1);

    for (; step < 300; ++step)
    {
        loose.fall(grid, dt);
    }
    EXPECT_EQ(lowest(), 0);
    EXPECT_TRUE(loose.inFlight().empty());
    EXPECT_EQ(grid.phase(2, 2, 0), SOLID);
    EXPECT_EQ(grid.totalMass(), 65*std::int64_t(voxelMaterial::full));
}


TEST(LooseSolids, meltInTheWayGoesUp)
{
    voxelGrid grid({3, 3, 10}, dx, wax(dx));
    grid.fill(1, 1, 0, 0.3, 350);
    grid.fill(1, 1, 1, 1, 280);
    grid.refresh();
    const std::int64_t mass = grid.totalMass(), energy = grid.totalEnergy();
    looseSolids loose(g);
    for (int step = 0; step < 50; ++step)
    {
        loose.fall(grid, 1e-3);
    }
    EXPECT_EQ(grid.phase(1, 1, 0), SOLID);
    EXPECT_EQ(grid.phase(1, 1, 1), LIQUID);
    EXPECT_EQ(grid.totalMass(), mass);
    EXPECT_EQ(grid.totalEnergy(), energy);
}


TEST(GravityRule, fallsAVoxelAStepAndFillsFromBelow)
{
    const filmViscosity film
    (
        [](double, double) { return 1.0; }, false, 250, 400, 1, 1e5, 0
    );
    voxelGrid grid({3, 3, 20}, dx, wax(dx));
    for (const int z : {5, 6, 9})
    {
        grid.fill(1, 1, z, 0.7, 350);
    }
    grid.refresh();
    gravityRule gravity(film, g, 0.004);
    const double dt = gravity.maxDeltaT(grid);

    gravity.fall(grid, dt);
    EXPECT_EQ(grid.phase(1, 1, 8), LIQUID);
    EXPECT_EQ(grid.phase(1, 1, 9), EMPTY);
    for (int step = 0; step < 20; ++step)
    {
        gravity.fall(grid, dt);
    }
    const auto share = [&](const int z)
    {
        return double(grid.mass(1, 1, z))/voxelMaterial::full;
    };
    EXPECT_NEAR(share(0), 1, 1e-8);
    EXPECT_NEAR(share(1), 1, 1e-8);
    EXPECT_NEAR(share(2), 0.1, 1e-8);
}


// A film on a wall falls with g delta^2/(3 nu)
TEST(GravityRule, filmOnAWall)
{
    const double eta = 10, filling = 0.5;
    const filmViscosity film
    (
        [=](double, double) { return eta; }, false, 250, 400, 1, 1e5, 0
    );
    voxelGrid grid({3, 3, 20}, dx, wax(dx));
    for (int z = 0; z < 20; ++z)
    {
        grid.fillRock(0, 1, z, 1);
    }
    grid.fill(1, 1, 10, filling, 350);
    grid.refresh();
    gravityRule gravity(film, g, 0.004);
    const double dt = 1e-2;
    gravity.fall(grid, dt);
    const double portion =
        1000*g*std::pow(filling*dx, 2)/(3*eta)*dt/dx;
    EXPECT_NEAR
    (
        double(grid.mass(1, 1, 9))/voxelMaterial::full,
        portion*filling,
        1e-7
    );
}


TEST(PublishedRule, spreadsLikeDiffusionUntilTheThreshold)
{
    publishedCoeffs c{0.8, 0.1, 0.2, 0.1, 0.6, 1, 1, 1, false, 0};
    voxelGrid grid({101, 101, 4}, dx, wax(dx));
    grid.fill(50, 50, 0, 1, 350);
    grid.refresh();
    publishedRule rule(c);
    const auto variance = [&]()
    {
        double sum = 0, weighted = 0;
        for (int x = 0; x < 101; ++x)
        {
            for (int y = 0; y < 101; ++y)
            {
                const double m = grid.mass(x, y, 0);
                sum += m;
                weighted += m*((x - 50)*(x - 50) + (y - 50)*(y - 50));
            }
        }
        return weighted/sum;
    };
    // Each step, 4 shares go one voxel: <r^2> = 4 share steps as long as
    // Energy is enough
    rule.spread(grid);
    const double first = variance();
    EXPECT_NEAR(first, 4*c.share, 1e-6);
    EXPECT_EQ(grid.mass(51, 50, 0), grid.mass(50, 49, 0));

    for (int step = 0; step < 400; ++step)
    {
        rule.spread(grid);
        rule.fall(grid);
    }
    const double late = variance();
    rule.spread(grid);
    EXPECT_EQ(variance(), late) << "it has not stopped at the threshold";
}

// ************************************************************************* //
