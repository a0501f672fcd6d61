/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"
#include "wallExtrapolation.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const vector3 g{1.5, -2, -9.81};

//- A disordered cloud over a floor and beside a wall
particleCloud room(const unsigned seed = 1)
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


//- Does any fluid particle lie within the support of wall particle i
bool sees(const particleCloud& cloud, const int i)
{
    const particles& f = cloud.fluid;
    const wallState& walls = cloud.walls;
    for (int j = 0; j < f.size(); ++j)
    {
        const double r = std::hypot
        (
            f.x[j] - walls.x[i], f.y[j] - walls.y[i], f.z[j] - walls.z[i]
        );
        if (r < 0.99*cloud.near.kernel().support())
        {
            return true;
        }
    }
    return false;
}

} // End anonymous namespace


TEST(WallExtrapolation, linearPressureIsExact)
{
    particleCloud cloud = room();
    particles& f = cloud.fluid;
    wallState& walls = cloud.walls;
    const auto pressure = [&](double x, double y, double z)
    {
        return 900 + 1000*(g[0]*x + g[1]*y + g[2]*z);
    };
    for (int i = 0; i < cloud.size(); ++i)
    {
        f.p[i] = pressure(f.x[i], f.y[i], f.z[i]);
    }
    wallExtrapolation(cloud.near, f, g, walls);

    int nSeen = 0;
    for (int i = 0; i < int(walls.size()); ++i)
    {
        if (sees(cloud, i))
        {
            ++nSeen;
            const double p = pressure(walls.x[i], walls.y[i], walls.z[i]);
            ASSERT_NEAR(walls.p[i], p, 1e-9);
        }
    }
    EXPECT_GT(nSeen, 200);
}


TEST(WallExtrapolation, wallsDoNotPull)
{
    particleCloud cloud = room();
    cloud.fluid.p.assign(cloud.size(), -500);
    wallExtrapolation(cloud.near, cloud.fluid, {0, 0, 0}, cloud.walls);
    for (const double p : cloud.walls.p)
    {
        ASSERT_EQ(p, 0);
    }
}


TEST(WallExtrapolation, velocityOfUniformFlow)
{
    for (const bool slip : {false, true})
    {
        particleCloud cloud = room();
        wallState& walls = cloud.walls;
        const int n = int(walls.size());
        cloud.setVelocity
        (
            [](double, double, double) { return vector3{3, -1, 2}; }
        );
        walls.wallU.assign(n, 0.5);
        walls.wallV.assign(n, 0.25);
        walls.wallW.assign(n, -1);
        walls.slip.assign(n, slip);
        wallExtrapolation(cloud.near, cloud.fluid, g, walls);

        for (int i = 0; i < n; ++i)
        {
            if (!sees(cloud, i))
            {
                continue;
            }
            // No slip: 2 U_wall - U. Slip: as that along the normal, else U
            const bool floor = walls.nz[i] == 1;
            ASSERT_NEAR(walls.u[i], slip && floor ? 3 : -2, 1e-12);
            ASSERT_NEAR(walls.v[i], slip ? -1 : 1.5, 1e-12);
            ASSERT_NEAR(walls.w[i], slip && !floor ? 2 : -4, 1e-12);
        }
    }
}


// A wall that slopes: the velocity along it stays, that across turns round
TEST(WallExtrapolation, slipMirrorsAtAnyNormal)
{
    for (const unsigned seed : {1u, 2u})
    {
        particleCloud cloud = room(seed);
        wallState& walls = cloud.walls;
        const int n = int(walls.size());
        const vector3 normal{2.0/7, -3.0/7, 6.0/7};
        walls.nx.assign(n, normal[0]);
        walls.ny.assign(n, normal[1]);
        walls.nz.assign(n, normal[2]);
        cloud.randomiseVelocity(3);

        walls.slip.assign(n, 0);
        wallExtrapolation(cloud.near, cloud.fluid, g, walls);
        const wallState sticking = walls;
        walls.slip.assign(n, 1);
        wallExtrapolation(cloud.near, cloud.fluid, g, walls);

        for (int i = 0; i < n; ++i)
        {
            // Of the mean velocity <v> a wall at rest shows -<v> if it sticks
            const vector3 v{-sticking.u[i], -sticking.v[i], -sticking.w[i]};
            const double across =
                v[0]*normal[0] + v[1]*normal[1] + v[2]*normal[2];
            ASSERT_NEAR(walls.u[i], v[0] - 2*across*normal[0], 1e-12);
            ASSERT_NEAR(walls.v[i], v[1] - 2*across*normal[1], 1e-12);
            ASSERT_NEAR(walls.w[i], v[2] - 2*across*normal[2], 1e-12);
        }
    }
}


// Nobody within the support but somebody within the skin
TEST(WallExtrapolation, lonelyWallShowsItself)
{
    particleCloud cloud(lattice{{1, 1, 2}, 0.01, kernelType::wendlandC2, 1.2});
    cloud.addWall(2, false);
    wallState& walls = cloud.walls;
    const double support = cloud.near.kernel().support();
    for (int i = 0; i < 2; ++i)
    {
        cloud.fluid.x[i] = walls.x[0];
        cloud.fluid.y[i] = walls.y[0];
        cloud.fluid.z[i] = walls.z[0] + 1.05*support + 0.1*i;
        cloud.fluid.p[i] = 100;
    }
    const int n = int(walls.size());
    walls.p.assign(n, 7);
    walls.wallU.assign(n, 4);
    const double x = walls.x[0], y = walls.y[0], z = walls.z[0];
    cloud.build();
    wallExtrapolation(cloud.near, cloud.fluid, g, walls);

    for (int i = 0; i < n; ++i)
    {
        if (walls.x[i] == x && walls.y[i] == y && walls.z[i] == z)
        {
            EXPECT_EQ(walls.p[i], 0);
            EXPECT_EQ(walls.u[i], 4);
        }
    }
}

// ************************************************************************* //
