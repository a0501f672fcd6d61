/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"
#include "stressDivergence.H"
#include "velocityGradient.H"
#include "wallExtrapolation.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

using tensor6 = std::array<double, 6>;

//- All particles with this stress, over a floor at z = 0
particleCloud floored(const tensor6& S, const bool slip)
{
    particleCloud cloud({{9, 9, 6}, 0.01, kernelType::wendlandC2, 1.3});
    cloud.addWall(2, false);
    cloud.walls.slip.assign(cloud.walls.size(), slip);
    cloud.build();
    for (int c = 0; c < 6; ++c)
    {
        cloud.fluid.S[c].assign(cloud.size(), S[c]);
    }
    return cloud;
}


//- Acceleration of each particle by the wall: that with it less that without
std::array<particles::array, 3> wallForce
(
    const tensor6& S,
    const bool slip,
    const vector3& normal = {0, 0, 1}
)
{
    particleCloud cloud = floored(S, slip);
    particles& f = cloud.fluid;
    cloud.walls.nx.assign(cloud.walls.size(), normal[0]);
    cloud.walls.ny.assign(cloud.walls.size(), normal[1]);
    cloud.walls.nz.assign(cloud.walls.size(), normal[2]);
    addStressDivergence(cloud.near, cloud.walls, f);
    std::array<particles::array, 3> force{f.ax, f.ay, f.az};

    particleCloud free(cloud.points());
    free.fluid.S = f.S;
    addStressDivergence(free.near, free.walls, free.fluid);
    for (int i = 0; i < cloud.size(); ++i)
    {
        force[0][i] -= free.fluid.ax[i];
        force[1][i] -= free.fluid.ay[i];
        force[2][i] -= free.fluid.az[i];
    }
    return force;
}


bool central(const particleCloud& cloud, const int i)
{
    const double support = cloud.near.kernel().support();
    const particles& f = cloud.fluid;
    return
        f.x[i] > support && f.x[i] < 0.09 - support
     && f.y[i] > support && f.y[i] < 0.09 - support;
}

} // End anonymous namespace


// Shear along the wall alone, S = n t + t n, n.t = 0: not the least force on
// any particle, whatever the normal
TEST(StressAtWalls, slipWallTakesNoShear)
{
    const std::pair<vector3, vector3> walls[] =
    {
        {{0, 0, 1}, {3, -5, 0}}, {{1, 0, 0}, {0, 2, 7}}, {{0, 1, 0}, {4, 0, 1}},
        {{2.0/7, -3.0/7, 6.0/7}, {3, -2, -2}}
    };
    for (const auto& [n, t] : walls)
    {
        const tensor6 S
        {
            2*n[0]*t[0], n[0]*t[1] + n[1]*t[0], n[0]*t[2] + n[2]*t[0],
            2*n[1]*t[1], n[1]*t[2] + n[2]*t[1], 2*n[2]*t[2]
        };
        for (const particles::array& force : wallForce(S, true, n))
        {
            for (const double value : force)
            {
                ASSERT_NEAR(value, 0, 1e-12);
            }
        }
    }
}


// Any stress: in the middle no force of a slip wall along it, and across it
// the same as that of a no-slip wall, whose force is along S n = (3, 5, -6)
TEST(StressAtWalls, tractionOfAnyStress)
{
    const tensor6 S{1, -2, 3, -4, 5, -6};
    const auto slip = wallForce(S, true), sticking = wallForce(S, false);
    const particleCloud cloud = floored(S, true);
    int nPulled = 0;
    for (int i = 0; i < cloud.size(); ++i)
    {
        if (central(cloud, i))
        {
            ASSERT_NEAR(slip[0][i], 0, 1e-12);
            ASSERT_NEAR(slip[1][i], 0, 1e-12);
            ASSERT_NEAR(slip[2][i], sticking[2][i], 1e-12);

            const double unit = sticking[2][i]/-6;
            ASSERT_NEAR(sticking[0][i], 3*unit, 1e-12);
            ASSERT_NEAR(sticking[1][i], 5*unit, 1e-12);
            nPulled += unit < -1e-6;
        }
    }
    EXPECT_GT(nPulled, 8);
}


TEST(StressAtWalls, meltThatMovesWithTheWallIsNotDeformed)
{
    for (const bool slip : {false, true})
    {
        particleCloud cloud = floored({}, slip);
        const int n = int(cloud.walls.size());
        cloud.walls.wallU.assign(n, 2);
        cloud.walls.wallV.assign(n, -1);
        cloud.setVelocity
        (
            [&](double, double, double)
            {
                return slip ? vector3{5, 3, 0} : vector3{2, -1, 0};
            }
        );
        particles& f = cloud.fluid;
        wallExtrapolation(cloud.near, f, {0, 0, 0}, cloud.walls);
        velocityGradient(cloud.near, cloud.walls, f, true);
        for (int i = 0; i < cloud.size(); ++i)
        {
            ASSERT_NEAR(f.S[2][i], 0, 1e-9);
            ASSERT_NEAR(f.S[4][i], 0, 1e-9);
            if (central(cloud, i) || !slip)
            {
                ASSERT_NEAR(f.dRho[i], 0, 1e-8);
            }
        }
    }
}


// Shear flow over a wall that it sticks to, and melt that falls upon it
TEST(StressAtWalls, wallShearAndCompression)
{
    particleCloud cloud = floored({}, false);
    particles& f = cloud.fluid;
    cloud.setVelocity
    (
        [](double, double, double z) { return vector3{10*z, 0, 0}; }
    );
    wallExtrapolation(cloud.near, f, {0, 0, 0}, cloud.walls);
    velocityGradient(cloud.near, cloud.walls, f, true);
    double least = 1e9, greatest = 0;
    for (int i = 0; i < cloud.size(); ++i)
    {
        if (central(cloud, i) && f.z[i] < 0.02)
        {
            least = std::min(least, f.S[2][i]);
            greatest = std::max(greatest, f.S[2][i]);
            ASSERT_NEAR(f.dRho[i], 0, 1e-9);
        }
    }
    RecordProperty("leastShear", std::to_string(least/10));
    RecordProperty("greatestShear", std::to_string(greatest/10));
    EXPECT_GT(least, 7);
    EXPECT_LT(greatest, 13);

    cloud.setVelocity([](double, double, double) { return vector3{0, 0, -1}; });
    velocityGradient(cloud.near, cloud.walls, f, true);
    for (int i = 0; i < cloud.size(); ++i)
    {
        ASSERT_GE(f.dRho[i], 0);
        ASSERT_TRUE(f.z[i] > 0.01 || f.dRho[i] > 0);
    }
}

// ************************************************************************* //
