/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicViscosity.H"
#include "meltSph/particleCloud/cloudVectors.H"
#include "meltSph/timeStep/schemeCase.H"
#include "solidBody.H"
#include "velocitySolver.H"
#include "viscousOperator.H"

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

//- A disordered lump, its viscosities spread over four decades
particleCloud lump(const unsigned seed)
{
    particleCloud cloud
    (
        lattice
        {
            {7, 8, 6}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3, 0.2
        },
        seed
    );
    for (double& eta : cloud.fluid.eta)
    {
        eta = std::pow(10.0, cloud.random(-1, 3));
    }
    return cloud;
}


//- An operator over a cloud
struct operatorCase
{
    schemeCase scheme;
    dictionary dict;
    autoPtr<viscousOperator> viscous;

    operatorCase
    (
        const particleCloud& cloud,
        const std::string& type,
        const scalar centralShare = 0.1
    )
    :
        scheme(cloud, springAndDamper(1, 0)),
        dict
        (
            IStringStream
            (
                "type implicitViscosity; operator " + type
              + "; centralShare " + std::to_string(centralShare)
              + "; maxCondition 100;"
            )()
        ),
        viscous(viscousOperator::New(dict, scheme.system))
    {
        scheme.system.near = cloud.near;
        scheme.system.walls = cloud.walls;
        scheme.system.fluid = cloud.fluid;
        viscous->update(1);
    }

    vectorArray force(const vectorArray& v, const double wallFactor = 0)
    {
        vectorArray f(v.size());
        viscous->addForce(v, wallFactor, f);
        return f;
    }
};


class ViscousOperator
:
    public testing::TestWithParam<std::string>
{};

INSTANTIATE_TEST_SUITE_P
(
    Both, ViscousOperator, testing::Values("adjoint", "central")
);

} // End anonymous namespace


TEST_P(ViscousOperator, isSymmetricAndDissipativeAlsoAtAWall)
{
    particleCloud cloud(lump(3));
    cloud.addWall(1, false);
    cloud.build();
    operatorCase test(cloud, GetParam());

    for (int repeat = 0; repeat < 5; ++repeat)
    {
        const vectorArray a(randomVelocity(cloud));
        const vectorArray b(randomVelocity(cloud));
        const vectorArray fa(test.force(a));
        const vectorArray fb(test.force(b));
        EXPECT_NEAR(dot(a, fb), dot(b, fa), 1e-12*norm(a)*norm(fb));
        EXPECT_LT(dot(a, fa), 0);
    }
}


TEST_P(ViscousOperator, keepsBothMomentaAndLetsALumpTurn)
{
    particleCloud cloud(lump(4));
    operatorCase test(cloud, GetParam());
    const particles& f = test.scheme.system.fluid;
    const int n = f.size();

    const vectorArray v(randomVelocity(cloud));
    const vectorArray force(test.force(v));
    const double scale = norm(force);
    const auto sum = [&](auto&& value) { return blockSum(n, value); };
    EXPECT_NEAR(sum([&](int i) { return force.x[i]; }), 0, 1e-11*scale);
    EXPECT_NEAR(sum([&](int i) { return force.y[i]; }), 0, 1e-11*scale);
    EXPECT_NEAR
    (
        sum
        (
            [&](int i) { return f.x[i]*force.y[i] - f.y[i]*force.x[i]; }
        ),
        0,
        1e-12*scale
    );

    vectorArray rotation(n);
    for (int i = 0; i < n; ++i)
    {
        rotation.x[i] = -f.y[i];
        rotation.y[i] = f.x[i];
    }
    EXPECT_LT
    (
        norm(test.force(rotation))/norm(rotation),
        1e-12*scale/norm(v)
    );
}


TEST_P(ViscousOperator, standsSingleParticlesAndSheets)
{
    for (const std::array<int, 3>& n : {std::array<int, 3>{1, 1, 2}, {5, 5, 2}})
    {
        particleCloud cloud
        (
            lattice{n, 0.01, smoothingKernel::kernelType::wendlandC2, 1.2}
        );
        // One layer in three dimensions
        for (double& z : cloud.fluid.z)
        {
            z *= 100;
        }
        cloud.build();
        std::fill(cloud.fluid.eta.begin(), cloud.fluid.eta.end(), 100);

        operatorCase test(cloud, GetParam());
        const vectorArray v(randomVelocity(cloud));
        EXPECT_TRUE(std::isfinite(norm(test.force(v))));
    }
}


TEST(AdjointViscosity, dissipatesWhatShearingCostsUpToTheFreeSurface)
{
    particleCloud cloud(lump(5));
    operatorCase test(cloud, "adjoint", 0);
    const particles& f = test.scheme.system.fluid;

    // Simple shear at 2 1/s: the power is eta times the shear rate squared
    // times the volume, exactly, since the gradient of a linear field is
    std::vector<double> eta;
    harmonicViscosity(test.scheme.system, eta);
    vectorArray v(f.size());
    double power = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        v.x[i] = 2*f.y[i];
        power += eta[i]*4*f.V[i];
    }
    EXPECT_NEAR(-dot(v, test.force(v)), power, 1e-10*power);
}


// Blocks of the preconditioner: the force on a particle that moves alone
TEST_P(ViscousOperator, diagonalBlocksAreThoseOfTheOperator)
{
    for (const bool wall : {false, true})
    {
        particleCloud cloud(lump(6));
        if (wall)
        {
            cloud.addWall(1, false);
            cloud.build();
        }
        operatorCase test(cloud, GetParam());
        implicitOperator::blocks blocks;
        for (std::vector<float>& component : blocks)
        {
            component.assign(cloud.size(), 0);
        }
        test.viscous->addDiagonal(blocks);

        for (int i = 0; i < cloud.size(); i += 17)
        {
            vectorArray v(cloud.size());
            v.x[i] = 1;
            const vectorArray f(test.force(v));
            // Of single precision, two shares
            EXPECT_NEAR(-f.x[i], blocks[0][i], 2e-7*blocks[0][i]) << i;
            EXPECT_NEAR(-f.y[i], blocks[1][i], 2e-7*blocks[0][i]) << i;
            EXPECT_NEAR(-f.z[i], blocks[2][i], 2e-7*blocks[0][i]) << i;
        }
    }
}


// Two halves of different viscosities: harmonic between them, their own apart;
// solids keep theirs and count for nothing
TEST(HarmonicViscosity, isTheMeanOfFluiditiesWithinTheKernel)
{
    particleCloud cloud
    (
        lattice
        {
            {16, 5, 5}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.2
        }
    );
    const double thin = 1, stiff = 1e6, middle = 0.08;
    for (int i = 0; i < cloud.size(); ++i)
    {
        cloud.fluid.eta[i] = cloud.fluid.x[i] < middle ? thin : stiff;
    }
    schemeCase scheme(cloud, springAndDamper(1, 0));
    scheme.system.near = cloud.near;
    scheme.system.walls = cloud.walls;
    scheme.system.fluid = cloud.fluid;

    std::vector<double> mean;
    harmonicViscosity(scheme.system, mean);
    const double reach = cloud.near.kernel().support();
    for (int i = 0; i < cloud.size(); ++i)
    {
        const double distance = cloud.fluid.x[i] - middle;
        if (std::abs(distance) > reach)
        {
            EXPECT_NEAR(mean[i]/cloud.fluid.eta[i], 1, 1e-12);
        }
        else if (distance > 0 && distance < 0.01)
        {
            // As much as a third of thin neighbours: between thin and 6 thin
            EXPECT_GT(mean[i], thin);
            EXPECT_LT(mean[i], 6*thin);
        }
    }

    // The thin half solid
    scheme.system.solid.assign(cloud.size(), 0);
    for (int i = 0; i < cloud.size(); ++i)
    {
        scheme.system.solid[i] = cloud.fluid.x[i] < middle;
    }
    harmonicViscosity(scheme.system, mean);
    for (int i = 0; i < cloud.size(); ++i)
    {
        EXPECT_NEAR(mean[i]/cloud.fluid.eta[i], 1, 1e-12);
    }
}


TEST(AdjointViscosity, movingWallPullsAndAWallThatMovesAlongDoesNot)
{
    particleCloud cloud(lump(6));
    cloud.addWall(1, false);
    cloud.build();
    for (double& u : cloud.walls.wallU)
    {
        u = 0.5;
    }
    for (const std::string type : {"adjoint", "central"})
    {
        operatorCase test(cloud, type);
        vectorArray v(cloud.size());
        const vectorArray pull(test.force(v, 1));
        EXPECT_GT(blockSum(v.size(), [&](int i) { return pull.x[i]; }), 0);

        std::fill(v.x.begin(), v.x.end(), 0.5);
        EXPECT_LT(norm(test.force(v, 1)), 1e-11*norm(pull));
    }
}


TEST_P(ViscousOperator, implicitStepKeepsMomentumAndTakesOutMoreEnergyTheLongerItIs)
{
    particleCloud cloud(lump(7));
    cloud.randomiseVelocity(1);

    double before = std::numeric_limits<double>::max();
    for (const scalar deltaT : {1e-7, 1e-5, 1e-3})
    {
        operatorCase test(cloud, GetParam());
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


TEST_P(ViscousOperator, looseToleranceDoesNotShakeStiffMelt)
{
    particleCloud cloud(lump(8));
    std::fill(cloud.fluid.eta.begin(), cloud.fluid.eta.end(), 1e4);
    cloud.randomiseVelocity(1);
    operatorCase test(cloud, GetParam());
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


TEST_P(ViscousOperator, solvesSmallChangesOfFastMeltToItsTolerance)
{
    // The tolerance is that of changes, far below the round-off that a solver of
    // a coarser one takes of the speed, 1e-12
    particleCloud cloud = lump(17);
    const vectorArray start(randomVelocity(cloud));
    const scalar speed = 1, change = 1e-3, tolerance = 1e-13;

    const auto solve = [&](const scalar frame)
    {
        operatorCase test(cloud, GetParam());
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
