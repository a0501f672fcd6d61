/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"
#include "wallContact.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

//- A disordered cloud over a floor at z = 0 and with a wall at the upper end
//  of x
particleCloud room(const unsigned seed)
{
    particleCloud cloud
    (
        lattice{{9, 8, 7}, 0.01, kernelType::wendlandC2, 1.2, 0.3}, seed
    );
    cloud.addWall(2, false);
    cloud.addWall(0, true);
    cloud.build();
    return cloud;
}


double kineticEnergy(const particles& f, const int i, const vector3& wall)
{
    return
        std::pow(f.u[i] - wall[0], 2) + std::pow(f.v[i] - wall[1], 2)
      + std::pow(f.w[i] - wall[2], 2);
}

} // End anonymous namespace


TEST(WallContact, particleBehindTheFloorReturns)
{
    particleCloud cloud = room(1);
    particles& f = cloud.fluid;
    const int i = 40;
    f.x[i] = 0.031;
    f.y[i] = 0.042;
    f.z[i] = -0.003;
    f.u[i] = 1;
    f.v[i] = -2;
    f.w[i] = -5;
    EXPECT_EQ(keepInFrontOfWalls(cloud.near, cloud.walls, f), 1);

    EXPECT_NEAR(f.x[i], 0.031, 1e-15);
    EXPECT_NEAR(f.y[i], 0.042, 1e-15);
    EXPECT_NEAR(f.z[i], 0.003, 1e-15);
    EXPECT_EQ(f.u[i], 1);
    EXPECT_EQ(f.v[i], -2);
    EXPECT_EQ(f.w[i], 0);
    EXPECT_EQ(keepInFrontOfWalls(cloud.near, cloud.walls, f), 0);
}


// In an edge, however near it is to one of the walls
TEST(WallContact, particleInAnEdgeReturns)
{
    for (const double behindX : {-1e-7, 1e-9, 1e-7, 0.002})
    {
        particleCloud cloud = room(1);
        particles& f = cloud.fluid;
        const int id = f.id[40];
        f.x[40] = 0.09 + behindX;
        f.y[40] = 0.042;
        f.z[40] = -2e-8;
        f.u[40] = 1;
        f.w[40] = -5;
        cloud.build();
        const int i = int(std::find(f.id.begin(), f.id.end(), id) - f.id.begin());
        EXPECT_EQ(keepInFrontOfWalls(cloud.near, cloud.walls, f), 1);

        EXPECT_NEAR(f.x[i], 0.09 - std::abs(behindX), 1e-15);
        EXPECT_NEAR(f.z[i], 2e-8, 1e-15);
        EXPECT_EQ(f.u[i], behindX > 0 ? 0 : 1);
        EXPECT_EQ(f.w[i], 0);
    }
}


// It keeps the velocity that leads out of the wall
TEST(WallContact, velocityRelativeToAMovingWall)
{
    for (const double w : {-1.0, 0.5, 2.0})
    {
        particleCloud cloud = room(1);
        particles& f = cloud.fluid;
        cloud.walls.wallW.assign(cloud.walls.size(), 0.75);
        const int i = 40;
        f.x[i] = 0.03;
        f.z[i] = -0.001;
        f.w[i] = w;
        EXPECT_EQ(keepInFrontOfWalls(cloud.near, cloud.walls, f), 1);
        EXPECT_NEAR(f.w[i], std::max(w, 0.75), 1e-15);
    }
}


TEST(WallContact, whoIsInFrontIsLeftAlone)
{
    particleCloud cloud = room(2);
    cloud.randomiseVelocity(1);
    const particles before = cloud.fluid;
    EXPECT_EQ(keepInFrontOfWalls(cloud.near, cloud.walls, cloud.fluid), 0);
    EXPECT_EQ(before.z, cloud.fluid.z);
    EXPECT_EQ(before.x, cloud.fluid.x);
    EXPECT_EQ(before.w, cloud.fluid.w);

    particleCloud free(lattice{{4, 4, 4}, 0.01, kernelType::wendlandC2, 1.2});
    free.fluid.z[3] = -1;
    EXPECT_EQ(keepInFrontOfWalls(free.near, free.walls, free.fluid), 0);
    EXPECT_EQ(free.fluid.z[3], -1);
}


// Particles shaken by up to half a spacing: all that were put back are in
// front of the wall, and none is faster than before
TEST(WallContact, noEnergyIsGained)
{
    for (const unsigned seed : {1u, 2u, 3u})
    {
        particleCloud cloud = room(seed);
        particles& f = cloud.fluid;
        const int n = int(cloud.walls.size());
        const vector3 wall{0.3, -0.2, 0.1};
        cloud.walls.wallU.assign(n, wall[0]);
        cloud.walls.wallV.assign(n, wall[1]);
        cloud.walls.wallW.assign(n, wall[2]);
        cloud.randomiseVelocity(1);
        int nBehind = 0;
        for (int i = 0; i < cloud.size(); ++i)
        {
            f.x[i] += cloud.random(-0.005, 0.005);
            f.z[i] += cloud.random(-0.005, 0.005);
            nBehind += f.z[i] < 0 || f.x[i] > 0.09;
        }
        const particles before = f;
        const int count = keepInFrontOfWalls(cloud.near, cloud.walls, f);
        EXPECT_GT(count, 5);
        EXPECT_EQ(count, nBehind);

        for (int i = 0; i < cloud.size(); ++i)
        {
            ASSERT_GE(f.z[i], 0);
            ASSERT_LE(f.x[i], 0.09);
            ASSERT_LE
            (
                kineticEnergy(f, i, wall),
                kineticEnergy(before, i, wall) + 1e-15
            );
        }
    }
}

// ************************************************************************* //
