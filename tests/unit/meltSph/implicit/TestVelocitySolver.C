/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocitySolver.H"
#include "meltSph/particleCloud/cloudVectors.H"
#include "meltSph/viscosity/viscousCase.H"
#include "solidBody.H"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace Foam
{
namespace melt
{
namespace unitTest
{
namespace
{

class VelocitySolver
:
    public testing::TestWithParam<std::string>
{};

INSTANTIATE_TEST_SUITE_P
(
    Both, VelocitySolver, testing::Values("adjoint", "central")
);

} // End anonymous namespace


TEST_P(VelocitySolver, implicitStepKeepsMomentumAndTakesOutMoreEnergyTheLongerItIs)
{
    particleCloud cloud(lump(7));
    cloud.randomiseVelocity(1);

    double before = std::numeric_limits<double>::max();
    for (const scalar deltaT : {1e-7, 1e-5, 1e-3})
    {
        viscousCase test(cloud, GetParam());
        sphSystem& s = test.scheme.system;
        particles& f = s.fluid;
        velocitySolver solver
        (
            dictionary(IStringStream("tolerance 1e-9; maxIterations 3000;")())
        );
        solver.add(*test.viscous);

        const auto momentum = [&]()
        {
            return blockSum(f.size(), [&](int i) { return f.m[i]*f.u[i]; });
        };
        const double p0 = momentum();
        solver.guess().assign(f.u, f.v, f.w);
        ASSERT_TRUE(solver.solve(s, deltaT));
        EXPECT_NEAR(momentum(), p0, 1e-8*f.m[0]*f.size());

        const double energy = blockSum
        (
            f.size(),
            [&](int i)
            {
                return f.m[i]
                   *(f.u[i]*f.u[i] + f.v[i]*f.v[i] + f.w[i]*f.w[i]);
            }
        );
        EXPECT_LT(energy, before);
        before = energy;
    }
}


TEST_P(VelocitySolver, looseToleranceDoesNotShakeStiffMelt)
{
    particleCloud cloud(lump(8));
    std::fill(cloud.fluid.eta.begin(), cloud.fluid.eta.end(), 1e4);
    cloud.randomiseVelocity(1);
    viscousCase test(cloud, GetParam());
    sphSystem& s = test.scheme.system;
    particles& f = s.fluid;
    velocitySolver solver(dictionary(IStringStream("tolerance 1e-3;")()));
    solver.add(*test.viscous);

    // In a second it comes to move as a rigid body of the same momenta
    solidBody lump;
    lump.members.resize(f.size());
    std::iota(lump.members.begin(), lump.members.end(), 0);
    lump.setGeometry(f);
    lump.setMotion(f, f.u, f.v, f.w);
    const vector U(lump.U), L(lump.L);
    vectorArray strain(f.size());
    lump.setVelocities(f, strain.x, strain.y, strain.z);

    solver.guess().assign(f.u, f.v, f.w);
    ASSERT_TRUE(solver.solve(s, 1));

    lump.setMotion(f, f.u, f.v, f.w);
    EXPECT_LT(mag(lump.U - U), 1e-14);
    EXPECT_LT(mag(lump.L - L), 1e-10*lump.mass*0.01);
    vectorArray v;
    v.assign(f.u, f.v, f.w);
    strain.add(-1, v);
    // Each particle's share of the residual, over its mass, would be 1e-3
    EXPECT_LT(norm(strain), 1e-4*std::sqrt(f.size()));
}


TEST_P(VelocitySolver, solvesSmallChangesOfFastMeltToItsTolerance)
{
    // The tolerance is that of changes, far below the round-off that a solver of
    // a coarser one takes of the speed, 1e-12
    particleCloud cloud = lump(17);
    const vectorArray start(randomVelocity(cloud));
    const scalar speed = 1, change = 1e-3, tolerance = 1e-13;

    const auto solve = [&](const scalar frame)
    {
        viscousCase test(cloud, GetParam());
        sphSystem& s = test.scheme.system;
        particles& f = s.fluid;
        for (int i = 0; i < f.size(); ++i)
        {
            f.u[i] = frame + change*start.x[i];
            f.v[i] = change*start.y[i];
            f.w[i] = change*start.z[i];
        }
        velocitySolver solver
        (
            dictionary
            (
                IStringStream
                (
                    "tolerance " + name(tolerance) + "; maxIterations 3000;"
                )()
            )
        );
        solver.add(*test.viscous);
        solver.guess().assign(f.u, f.v, f.w);
        EXPECT_TRUE(solver.solve(s, 1e-3));
        vectorArray v;
        v.assign(f.u, f.v, f.w);
        for (double& u : v.x)
        {
            u -= frame;
        }
        return v;
    };

    vectorArray difference(solve(speed));
    difference.add(-1, solve(0));
    EXPECT_LT(norm(difference)/std::sqrt(difference.size()), 3e-14);
}

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
