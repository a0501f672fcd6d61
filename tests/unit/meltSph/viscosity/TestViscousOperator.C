/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicViscosity.H"
#include "meltSph/particleCloud/cloudVectors.H"
#include "meltSph/viscosity/viscousCase.H"

#include <gtest/gtest.h>

namespace Foam
{
namespace melt
{
namespace unitTest
{
namespace
{

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
    viscousCase test(cloud, GetParam());

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
    viscousCase test(cloud, GetParam());
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

        viscousCase test(cloud, GetParam());
        const vectorArray v(randomVelocity(cloud));
        EXPECT_TRUE(std::isfinite(norm(test.force(v))));
    }
}


TEST(AdjointViscosity, dissipatesWhatShearingCostsUpToTheFreeSurface)
{
    particleCloud cloud(lump(5));
    viscousCase test(cloud, "adjoint", 0);
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
        viscousCase test(cloud, GetParam());
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
        viscousCase test(cloud, type);
        vectorArray v(cloud.size());
        const vectorArray pull(test.force(v, 1));
        EXPECT_GT(blockSum(v.size(), [&](int i) { return pull.x[i]; }), 0);

        std::fill(v.x.begin(), v.x.end(), 0.5);
        EXPECT_LT(norm(test.force(v, 1)), 1e-11*norm(pull));
    }
}

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
