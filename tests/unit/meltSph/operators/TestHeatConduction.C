/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatConduction.H"
#include "latticeSymbol.H"
#include "meltUnitTests.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const double kappa = 0.4;

double conduct(particleCloud& cloud)
{
    return heatConduction
    (
        cloud.near, cloud.walls, kappa, cloud.points().spacing, cloud.fluid
    );
}


//- Heat flow over the exact one of a wave of n spacings, both weighted by the
//  wave: over whole waves in the interior
double weakGain(const lattice& points, const int n, const unsigned seed)
{
    particleCloud cloud(points, seed);
    particles& f = cloud.fluid;
    const double k = waveNumber(points, n);
    for (int i = 0; i < cloud.size(); ++i)
    {
        f.T[i] = 300 + std::sin(k*f.x[i]);
    }
    conduct(cloud);

    double flow = 0, exact = 0;
    for (int i = 0; i < cloud.size(); ++i)
    {
        if (cloud.inside(i, cloud.near.kernel().support()))
        {
            flow -= f.m[i]*(f.T[i] - 300)*f.dH[i];
            exact += f.V[i]*kappa*k*k*(f.T[i] - 300)*(f.T[i] - 300);
        }
    }
    return flow/exact;
}

} // End anonymous namespace


TEST(HeatConduction, waveOnLatticeIsSymbol)
{
    const lattice lattices[] =
    {
        {{34, 11, 1}, 0.01, kernelType::quinticSpline, 1.3},
        {{28, 7, 7}, 0.02, kernelType::wendlandC2, 1.4}
    };
    for (const lattice& points : lattices)
    {
        const double symbol = laplacianGain(points, waveNumber(points, 20));
        EXPECT_NEAR(weakGain(points, 20, 1)/symbol, 1, 1e-10);
    }
}


// Quintic spline, h of one spacing
TEST(HeatConduction, gainOnLatticeTendsToOne)
{
    double before = 0;
    for (const int n : {20, 40, 80})
    {
        const double gain = weakGain
        (
            {{n + 10, 9, 1}, 1.0/n, kernelType::quinticSpline, 1}, n, 1
        );
        RecordProperty("gain" + std::to_string(n), std::to_string(gain));
        EXPECT_GT(gain, before);
        EXPECT_NEAR(gain, 1, 5.0/(n*n) + 2e-3);
        before = gain;
    }
}


// The gain and not the pointwise error, which does not fall on disordered
// particles
TEST(HeatConduction, gainOnDisorderedLattice)
{
    for (const unsigned seed : {1u, 2u, 3u})
    {
        const double gain = weakGain
        (
            {{90, 40, 1}, 0.01, kernelType::quinticSpline, 1.2, 0.2}, 40, seed
        );
        RecordProperty("gain" + std::to_string(seed), std::to_string(gain));
        EXPECT_NEAR(gain, 1, 0.03);
    }
}


TEST(HeatConduction, insulatedBodyKeepsItsHeat)
{
    for (const bool uniform : {true, false})
    {
        for (const unsigned seed : {1u, 2u, 3u})
        {
            particleCloud cloud
            (
                lattice{{9, 8, 7}, 0.01, kernelType::wendlandC2, 1.3, 0.4},
                seed
            );
            particles& f = cloud.fluid;
            cloud.randomiseDensity(0.3);
            cloud.randomise(f.T, 300, 400);
            if (!uniform)
            {
                f.kappa.resize(f.size());
                for (double& value : f.kappa)
                {
                    value = std::pow(10, cloud.random(-2, 2));
                }
            }
            EXPECT_EQ(conduct(cloud), 0);

            double sum = 0, all = 0;
            for (int i = 0; i < cloud.size(); ++i)
            {
                sum += f.m[i]*f.dH[i];
                all += std::abs(f.m[i]*f.dH[i]);
            }
            EXPECT_GT(all, 0);
            EXPECT_NEAR(sum, 0, 1e-13*all);
        }
    }
}


TEST(HeatConduction, pairOfDifferentConductivities)
{
    particleCloud cloud(lattice{{2, 1, 1}, 0.01});
    particles& f = cloud.fluid;
    f.T = {300, 310};
    f.rho = {1000, 800};
    f.V = {1e-4, 2e-4};
    f.m = {0.1, 0.16};
    f.kappa = {1, 3};
    conduct(cloud);

    // 4 k1 k2/(k1 + k2) = 3
    const double F = quinticSpline(0.013, 2).gradientOverR(1e-4);
    EXPECT_DOUBLE_EQ(f.dH[0], 2e-4*3*(300 - 310)*F/1000);
    EXPECT_DOUBLE_EQ(f.dH[1], 1e-4*3*(310 - 300)*F/800);
    EXPECT_GT(f.dH[0], 0);
}

// ************************************************************************* //
