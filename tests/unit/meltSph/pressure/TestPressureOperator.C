/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeMoment.H"
#include "pressureCase.H"
#include "pressureForce.H"

#include <gtest/gtest.h>

namespace Foam
{
namespace melt
{
namespace unitTest
{

TEST(PressureOperator, isSymmetricAndTakesEnergyAlsoAtAWall)
{
    particleCloud cloud(densityLump(3));
    cloud.addWall(1, false);
    cloud.build();

    for (const bool tension : {true, false})
    {
        pressureCase test(cloud, 1e-3, tension);
        const vectorArray a(randomVelocity(cloud));
        const vectorArray b(randomVelocity(cloud));
        const vectorArray fa(test.force(a));
        const vectorArray fb(test.force(b));
        EXPECT_NEAR(dot(a, fb), dot(b, fa), 1e-12*norm(a)*norm(fb));
        EXPECT_LT(dot(a, fa), 0);
    }
}


TEST(PressureOperator, workIsPressureTimesDivergence)
{
    particleCloud cloud(densityLump(4));
    cloud.addWall(1, false);
    cloud.build();
    pressureCase test(cloud, 1e-3);
    particles& f = test.scheme.system.fluid;

    // What comes nearer to walls under tension is compressed without a force
    vectorArray v(randomVelocity(cloud));
    for (double& across : v.y)
    {
        across = std::abs(across);
    }
    f.u = v.x;
    f.v = v.y;
    f.w = v.z;
    std::vector<double> divergence(f.size());
    test.pressure.divergence(divergence);

    // v.f = sum V p div/s with p = p0 - dt rho c^2 div; walls do not see
    // negative pressure, for which their part of both sides is left out
    double work = 0, scale = 0;
    const double rho0 = test.scheme.system.thermo.rho();
    for (int i = 0; i < f.size(); ++i)
    {
        const double p =
            400*(f.rho[i] - rho0) - 1e-3*f.rho[i]*400*divergence[i];
        work += f.V[i]*p*divergence[i]/test.support(i);
        scale += f.V[i]*std::abs(p*divergence[i]);
    }
    EXPECT_NEAR(dot(v, test.force(v, 1)), work, 1e-12*scale);
}


// In terms of the mean w = (1 - theta) u + theta u' the pressure is still that
// of u', at the end of the step
TEST(PressureOperator, weightedVelocitiesGiveThePressureOfTheEnd)
{
    particleCloud cloud(densityLump(4));
    cloud.addWall(1, false);
    cloud.build();
    const double deltaT = 1e-3, theta = 0.6;
    const vectorArray before(randomVelocity(cloud)), end(randomVelocity(cloud));
    vectorArray mean(end);
    mean.multiply(std::vector<double>(end.size(), theta));
    mean.add(1 - theta, before);

    pressureCase whole(cloud, deltaT);
    const vectorArray force(whole.force(end, 1));

    pressureCase weighted(cloud, deltaT);
    particles& f = weighted.scheme.system.fluid;
    f.u = before.x;
    f.v = before.y;
    f.w = before.z;
    weighted.pressure.divergence(f.dRho);
    for (int i = 0; i < f.size(); ++i)
    {
        f.dRho[i] *= -f.rho[i];
    }
    weighted.scheme.system.implicitness = theta;
    weighted.pressure.update(theta*deltaT);
    vectorArray difference(weighted.force(mean, 1));
    difference.add(-1, force);
    EXPECT_LT(norm(difference), 1e-12*norm(force));
}


// A lattice, strained anyhow without change of volume: at faces, edges and
// corners, and within; in the layer between to 2 % of the strain
TEST(PressureOperator, strainThatKeepsTheVolumeHasNoDivergence)
{
    pressureCase test
    (
        particleCloud
        (
            lattice{{7, 8, 6}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.2}
        ),
        1e-3
    );
    particles& f = test.scheme.system.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        const double x = f.x[i], y = f.y[i], z = f.z[i];
        f.u[i] = 1 + 2*x + y + 0.3*z;
        f.v[i] = 1 + 0.2*x - 5*y;
        f.w[i] = 0.7*x + 3*z;
    }
    std::vector<double> divergence(f.size());
    test.pressure.divergence(divergence);
    const auto depth = [](const double x, const int n)
    {
        return std::min(x, n*0.01 - x)/0.01;
    };
    for (int i = 0; i < f.size(); ++i)
    {
        const double layer = std::min
        (
            {depth(f.x[i], 7), depth(f.y[i], 8), depth(f.z[i], 6)}
        );
        const bool between = layer > 1 && layer < 2;
        EXPECT_NEAR(divergence[i], 0, between ? 0.02*std::sqrt(39) : 1e-11)
            << layer;
    }
}


TEST(PressureOperator, keepsBothMomenta)
{
    particleCloud cloud(densityLump(5));
    pressureCase test(cloud, 1e-3);
    const particles& f = test.scheme.system.fluid;
    const int n = f.size();

    const vectorArray force(test.force(randomVelocity(cloud), 1));
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
}


// In a step of no length the pressure is that of the state; where the gradient
// is not corrected, the force is the explicit one over that of a lattice
TEST(PressureOperator, withoutAStepIsTheExplicitForce)
{
    particleCloud cloud(densityLump(6));
    pressureCase test(cloud, 0, true, 1);
    particles& f = test.scheme.system.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        f.p[i] = 400*(f.rho[i] - test.scheme.system.thermo.rho());
        f.ax[i] = f.ay[i] = f.az[i] = 0;
        f.m[i] = f.rho[i]*f.V[i];
    }
    addPressureForce(test.scheme.system.near, cloud.walls, f);

    const vectorArray force(test.force(randomVelocity(cloud), 1));
    const double scale = norm(force);
    const double m = latticeMoment
    (
        test.scheme.system.near.kernel(), test.scheme.system.spacing
    );
    for (int i = 0; i < f.size(); ++i)
    {
        EXPECT_NEAR(m*force.x[i], f.m[i]*f.ax[i], 1e-12*scale);
        EXPECT_NEAR(m*force.y[i], f.m[i]*f.ay[i], 1e-12*scale);
        EXPECT_NEAR(m*force.z[i], f.m[i]*f.az[i], 1e-12*scale);
    }
}


// The diagonal blocks are those of the operator itself
TEST(PressureOperator, diagonalIsThatOfTheOperator)
{
    particleCloud cloud(densityLump(7));
    cloud.addWall(1, false);
    cloud.build();
    pressureCase test(cloud, 1e-3);
    const int n = cloud.size();

    implicitOperator::blocks blocks;
    for (std::vector<float>& component : blocks)
    {
        component.assign(n, 0);
    }
    test.pressure.addDiagonal(blocks);

    for (const int i : {0, n/3, n/2, n - 1})
    {
        vectorArray v(n);
        v.x[i] = 1;
        const vectorArray f(test.force(v));
        // Of single precision
        EXPECT_NEAR(-f.x[i]/blocks[0][i], 1, 1e-7);
        EXPECT_NEAR(-f.y[i], blocks[1][i], 1e-7*blocks[0][i]);
        EXPECT_NEAR(-f.z[i], blocks[2][i], 1e-7*blocks[0][i]);
    }
}


// Symplectic Euler: n steps fall by g dt^2 n(n + 1)/2

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
