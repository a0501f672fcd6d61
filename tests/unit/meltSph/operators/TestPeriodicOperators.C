/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatConduction.H"
#include "latticeSymbol.H"
#include "meltSph/particleCloud/cloudSums.H"
#include "meltUnitTests.H"
#include "pressureForce.H"
#include "stressDivergence.H"
#include "velocityGradient.H"
#include "wallExtrapolation.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

lattice allPeriodic(const std::array<int, 3>& n)
{
    lattice points{n, 0.01};
    points.kernel = smoothingKernel::kernelType::wendlandC2;
    points.periodic = {true, true, n[2] > 1};
    return points;
}


particleCloud disordered(const unsigned seed)
{
    lattice points(allPeriodic({10, 9, 11}));
    points.jitter = 0.4;
    particleCloud cloud(points, seed);
    cloud.randomiseDensity(0.1);
    cloud.randomiseVelocity(1);
    cloud.randomise(cloud.fluid.p, -100, 500);
    for (particles::array& s : cloud.fluid.S)
    {
        cloud.randomise(s, -50, 50);
    }
    return cloud;
}

} // End anonymous namespace


// The closed forms of an unbounded lattice, at every particle
TEST(PeriodicOperators, wavesAreThoseOfTheUnboundedLattice)
{
    for (const auto& n : {std::array<int, 3>{16, 9, 9}, {24, 10, 1}})
    {
        particleCloud cloud(allPeriodic(n));
        particles& f = cloud.fluid;
        const double k = waveNumber(cloud.points(), n[0]);
        const double kappa = 0.3;
        for (int i = 0; i < f.size(); ++i)
        {
            f.v[i] = f.p[i] = f.T[i] = std::sin(k*f.x[i]);
        }
        f.ax.assign(f.size(), 0);
        addPressureForce(cloud.near, cloud.walls, f);
        velocityGradient(cloud.near, cloud.walls, f, true);
        heatConduction
        (
            cloud.near, cloud.walls, kappa, cloud.points().spacing, f
        );

        const double gradient = k*gradientGain(cloud.points(), k);
        const double laplacian = k*k*laplacianGain(cloud.points(), k);
        for (int i = 0; i < f.size(); ++i)
        {
            const double c = std::cos(k*f.x[i]), s = std::sin(k*f.x[i]);
            ASSERT_NEAR(f.S[1][i], gradient*c, 1e-12*k);
            ASSERT_NEAR(f.ax[i], -gradient*c/f.rho[i], 1e-12*k/f.rho[i]);
            ASSERT_NEAR(f.dH[i], -kappa*laplacian*s/f.rho[i], 1e-12*k*k);
        }
    }
}


TEST(PeriodicOperators, forcesCancelToRoundOff)
{
    for (const unsigned seed : {1, 2, 3})
    {
        for (const auto& add : {addPressureForce, addStressDivergence})
        {
            particleCloud cloud(disordered(seed));
            particles& f = cloud.fluid;
            add(cloud.near, cloud.walls, f);

            const double all = massSumMag(f, f.ax, f.ay, f.az);
            EXPECT_GT(all, 0);
            for (const double sum : massSum(f, f.ax, f.ay, f.az))
            {
                EXPECT_NEAR(sum, 0, 1e-13*all);
            }
        }
    }
}


// Where the box begins makes no difference
TEST(PeriodicOperators, translationChangesNothing)
{
    particleCloud here(disordered(5));
    particleCloud there(here);
    for (int i = 0; i < there.size(); ++i)
    {
        there.fluid.x[i] += 0.0374;
        there.fluid.y[i] -= 0.2311;
        there.fluid.z[i] += 0.1;
    }
    there.build();

    std::vector<int> at(here.size());
    for (int i = 0; i < there.size(); ++i)
    {
        at[there.fluid.id[i]] = i;
    }
    for (particleCloud* cloud : {&here, &there})
    {
        addPressureForce(cloud->near, cloud->walls, cloud->fluid);
        addStressDivergence(cloud->near, cloud->walls, cloud->fluid);
    }
    const particles& a = here.fluid;
    const particles& b = there.fluid;
    for (int i = 0; i < here.size(); ++i)
    {
        const int j = at[a.id[i]];
        ASSERT_NEAR(a.ax[i], b.ax[j], 1e-10*(1 + std::abs(a.ax[i])));
        ASSERT_NEAR(a.ay[i], b.ay[j], 1e-10*(1 + std::abs(a.ay[i])));
        ASSERT_NEAR(a.az[i], b.az[j], 1e-10*(1 + std::abs(a.az[i])));
    }
}


// Between walls that end where the periods do, every column is alike
TEST(PeriodicOperators, wallsGoOnAcrossThePeriod)
{
    lattice points{{9, 12, 10}, 0.01};
    points.kernel = smoothingKernel::kernelType::wendlandC2;
    points.periodic = {true, false, true};
    particleCloud cloud(points);
    cloud.addWall(1, false);
    cloud.addWall(1, true);
    cloud.build();

    particles& f = cloud.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        f.u[i] = f.y[i]*(0.12 - f.y[i]);
        f.p[i] = 100*f.y[i];
    }
    wallExtrapolation(cloud.near, f, {0, -9.81, 0}, cloud.walls);
    velocityGradient(cloud.near, cloud.walls, f, true);
    f.ay.assign(f.size(), 0);
    addPressureForce(cloud.near, cloud.walls, f);

    std::vector<int> first(12, -1);
    for (int i = 0; i < f.size(); ++i)
    {
        int& j = first[int(f.y[i]/0.01)];
        j = j < 0 ? i : j;
        ASSERT_NEAR(f.S[1][i], f.S[1][j], 1e-13);
        ASSERT_NEAR(f.ay[i], f.ay[j], 1e-10);
        ASSERT_NEAR(f.ax[i], 0, 1e-12);
    }
}

// ************************************************************************* //
