/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeSymbol.H"
#include "meltUnitTests.H"
#include "xsphVelocity.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

} // End anonymous namespace


// Quintic spline, h = 1.2 spacings, waves of 40 spacings, epsilon 1/2:
// 1 - epsilon k^2 <r^2>/(2 d) = 0.995709
TEST(XsphVelocity, gainOfShearWave)
{
    const double epsilon = 0.5;
    const int n = 40;
    const lattice points{{60, 14, 1}, 0.01, kernelType::quinticSpline, 1.2};
    particleCloud cloud(points);
    particles& f = cloud.fluid;
    const double k = waveNumber(points, n);
    cloud.setVelocity
    (
        [&](double x, double, double)
        {
            return vector3{0, std::sin(k*x + 0.1), 0};
        }
    );
    xsphVelocity(cloud.near, epsilon, f);

    const double symbol = smoothingGain(points, k, epsilon);
    const double kh = k*points.h();
    EXPECT_NEAR(symbol, 1 - epsilon*kh*kh*0.966179/4, 5e-5);
    EXPECT_NEAR(symbol, 0.995709, 5e-5);
    RecordProperty("gain", std::to_string(symbol));

    int nInside = 0;
    for (int i = 0; i < cloud.size(); ++i)
    {
        if (cloud.inside(i, cloud.near.kernel().support()))
        {
            ++nInside;
            ASSERT_NEAR(f.v[i] + f.dv[i], symbol*f.v[i], 1e-12);
            ASSERT_EQ(f.du[i], 0);
            ASSERT_EQ(f.dw[i], 0);
        }
    }
    EXPECT_GT(nInside, 100);
}


TEST(XsphVelocity, commonVelocityStays)
{
    particleCloud cloud(lattice{{6, 7, 8}, 0.01, kernelType::wendlandC2, 1.2, 0.3});
    cloud.randomiseDensity(0.2);
    cloud.setVelocity([](double, double, double) { return vector3{1, 2, 3}; });
    xsphVelocity(cloud.near, 1, cloud.fluid);
    for (int i = 0; i < cloud.size(); ++i)
    {
        ASSERT_EQ(cloud.fluid.du[i], 0);
        ASSERT_EQ(cloud.fluid.dv[i], 0);
        ASSERT_EQ(cloud.fluid.dw[i], 0);
    }
}


TEST(XsphVelocity, pairOfUnequalDensities)
{
    particleCloud cloud(lattice{{2, 1, 1}, 0.01});
    particles& f = cloud.fluid;
    f.rho = {900, 1300};
    f.m = {0.09, 0.13};
    f.V = {1e-4, 1e-4};
    f.u = {0.5, -1};
    f.w = {0, 2};
    xsphVelocity(cloud.near, 0.4, f);

    const double W = quinticSpline(0.013, 2).value(1e-4);
    EXPECT_DOUBLE_EQ(f.du[0], 0.4*0.13/1100*(-1.5)*W);
    EXPECT_DOUBLE_EQ(f.du[1], 0.4*0.09/1100*1.5*W);
    EXPECT_DOUBLE_EQ(f.dw[0], 0.4*0.13/1100*2*W);
    EXPECT_EQ(f.u[0], 0.5);
}

// ************************************************************************* //
