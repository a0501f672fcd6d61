/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "artificialViscosity.H"
#include "latticeSymbol.H"
#include "meltSph/particleCloud/cloudSums.H"
#include "meltUnitTests.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const double alpha = 0.3, beta = 2, c = 20;

//- Two particles, the second ahead of the first by one spacing, that approach
//  at the speed
particleCloud pair(const double speed)
{
    particleCloud cloud(lattice{{2, 1, 1}, 0.01});
    particles& f = cloud.fluid;
    const int left = f.x[0] < f.x[1] ? 0 : 1;
    f.u[left] = speed;
    f.rho[left] = 1200;
    f.m[1 - left] *= 1.5;
    f.V = {f.m[0]/f.rho[0], f.m[1]/f.rho[1]};
    addArtificialViscosity(cloud.near, alpha, beta, c, f);
    return cloud;
}


//- Viscosity [m2/s] that the decay of a shear wave of n spacings shows
double waveViscosity(const lattice& points, const int n)
{
    particleCloud cloud(points);
    particles& f = cloud.fluid;
    const double k = waveNumber(points, n);
    cloud.setVelocity
    (
        [&](double x, double, double)
        {
            return vector3{0, std::sin(k*x), 0};
        }
    );
    addArtificialViscosity(cloud.near, alpha, 0, c, f);

    double work = 0, square = 0;
    for (int i = 0; i < cloud.size(); ++i)
    {
        if (cloud.inside(i, cloud.near.kernel().support()))
        {
            work -= f.v[i]*f.ay[i];
            square += f.v[i]*f.v[i];
        }
    }
    return work/(k*k*square);
}

} // End anonymous namespace


TEST(ArtificialViscosity, pairThatApproaches)
{
    const double speed = 0.7, r = 0.01, h = 0.013;
    const particleCloud cloud = pair(speed);
    const particles& f = cloud.fluid;
    const int left = f.rho[0] > 1100 ? 0 : 1;

    const double mu = -h*speed*r/(r*r + 0.01*h*h);
    const double Pi = (-alpha*c*mu + beta*mu*mu)/1100;
    const double gradient =
        r*quinticSpline(h, 2).gradientOverR(r*r);

    EXPECT_LT(f.ax[left], 0);
    EXPECT_NEAR(f.ax[left]/(f.m[1 - left]*Pi*gradient), 1, 1e-12);
    EXPECT_NEAR(f.ax[1 - left]/(-f.m[left]*Pi*gradient), 1, 1e-12);
    EXPECT_EQ(f.ay[0], 0);
}


TEST(ArtificialViscosity, pairThatPartsOrRestsFeelsNothing)
{
    for (const double speed : {-0.7, 0.0})
    {
        const particleCloud cloud = pair(speed);
        EXPECT_EQ(cloud.fluid.ax[0], 0);
        EXPECT_EQ(cloud.fluid.ax[1], 0);
    }
}


TEST(ArtificialViscosity, expansionAndRigidRotationFeelNothing)
{
    particleCloud cloud(lattice{{6, 7, 8}, 0.01, kernelType::wendlandC2, 1.2, 0.2});
    particles& f = cloud.fluid;
    for (const bool rotation : {false, true})
    {
        cloud.setVelocity
        (
            [&](double x, double y, double z)
            {
                return rotation ? vector3{-3*y, 3*x, 0} : vector3{2*x, y, 3*z};
            }
        );
        addArtificialViscosity(cloud.near, alpha, beta, c, f);
        for (int i = 0; i < cloud.size(); ++i)
        {
            ASSERT_NEAR(std::hypot(f.ax[i], f.ay[i], f.az[i]), 0, 1e-11);
        }
    }
}


// Of the neighbours of a shear wave half approach: half the sum over all,
// and nearly alpha h c/(4 (d + 2))
TEST(ArtificialViscosity, effectiveViscosity)
{
    const lattice lattices[] =
    {
        {{60, 20, 1}, 0.01, kernelType::quinticSpline, 2},
        {{60, 14, 14}, 0.01, kernelType::wendlandC2, 2}
    };
    for (const lattice& points : lattices)
    {
        const int n = 40;
        const double h = points.h();
        const double k = waveNumber(points, n);
        const double share = latticeSum
        (
            points,
            [&](double x, double y, double z, double, double F)
            {
                const double r2 = x*x + y*y + z*z;
                return -0.5*h*F*y*y/(r2 + 0.01*h*h)*(1 - std::cos(k*x))/(k*k);
            }
        );
        const double nu = waveViscosity(points, n);
        EXPECT_NEAR(nu/(alpha*c*share), 1, 1e-10);

        const double expected = alpha*h*c/(4*(points.dimensions() + 2));
        RecordProperty
        (
            "effectiveOverNominal" + std::to_string(points.dimensions()),
            std::to_string(nu/expected)
        );
        EXPECT_NEAR(nu/expected, 1, 0.1);
    }
}


TEST(ArtificialViscosity, takesEnergyOut)
{
    for (const unsigned seed : {1u, 2u, 3u})
    {
        const lattice points{{7, 6, 5}, 0.01, kernelType::wendlandC2, 1.4, 0.4};
        particleCloud cloud(points, seed);
        cloud.randomiseDensity(0.2);
        cloud.randomiseVelocity(2);
        particles& f = cloud.fluid;
        addArtificialViscosity(cloud.near, alpha, beta, c, f);

        EXPECT_LT(power(f), 0);
    }
}

// ************************************************************************* //
