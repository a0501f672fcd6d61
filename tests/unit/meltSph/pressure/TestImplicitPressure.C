/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "densityLump.H"
#include "implicitPressure.H"
#include "meltSph/timeStep/schemeCase.H"
#include "meltUnitTests.H"

#include <gtest/gtest.h>

namespace Foam
{
namespace melt
{
namespace unitTest
{
namespace
{

const std::string implicitMelt
(
    "scheme semiImplicit; implicit { tolerance 1e-9; }"
    " viscosity { type unitTestSpring; omega 0; damping 0; }"
    " pressure { type implicitPressure; "
);

} // End anonymous namespace


TEST(ImplicitPressure, freeFallIsThatOfTheScheme)
{
    schemeCase scheme(densityLump(8), implicitMelt + "speedOfSound 10; }");
    scheme.system.g = {0, -10, 0};
    particles& f = scheme.system.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        f.rho[i] = scheme.system.thermo.rho();
    }
    const double y = f.y[scheme.indexOf(17)];
    scheme.run(0.1, 10);
    EXPECT_NEAR(f.y[scheme.indexOf(17)], y - 0.055, 1e-11);
    EXPECT_NEAR(f.v[scheme.indexOf(17)], -1, 1e-10);
}


// Sound crosses up to a hundred spacings in a step: its energy does not grow
TEST(ImplicitPressure, longStepsAreStable)
{
    for (const scalar deltaT : {1e-4, 1e-3, 1e-2})
    {
        schemeCase scheme(densityLump(9), implicitMelt + "speedOfSound 100; }");
        particles& f = scheme.system.fluid;
        const double rho0 = scheme.system.thermo.rho();
        const auto energy = [&]()
        {
            return blockSum
            (
                f.size(),
                [&](const int i)
                {
                    return 0.5*f.m[i]
                       *(
                            f.u[i]*f.u[i] + f.v[i]*f.v[i] + f.w[i]*f.w[i]
                          + sqr(100*(f.rho[i]/rho0 - 1))
                        );
                }
            );
        };
        const double start = energy();
        for (label step = 0; step < 5; ++step)
        {
            scheme.run(deltaT, 1);
            ASSERT_LT(energy(), start) << deltaT << ' ' << step;
        }
    }
}


// Melt that fills its domain does not feel the background: on a lattice it rests.
// A free lump is blown up
TEST(ImplicitPressure, backgroundPressure)
{
    for (const bool fills : {true, false})
    {
        lattice points{{6, 6, 6}, 0.01};
        points.kernel = smoothingKernel::kernelType::wendlandC2;
        points.periodic = {fills, fills, fills};
        schemeCase scheme
        (
            particleCloud(points),
            implicitMelt + "speedOfSound 10; background 200; }"
        );
        scheme.run(1e-3, 1);
        const particles& f = scheme.system.fluid;
        for (int i = 0; i < f.size(); ++i)
        {
            EXPECT_NEAR(f.p[i], 200 + 100*(f.rho[i] - 1000), 1e-6);
        }
        const double fastest =
            *std::max_element(f.u.begin(), f.u.end());
        EXPECT_EQ(fastest < 1e-9, fills) << fastest;
        EXPECT_EQ(fastest > 1e-3, !fills) << fastest;
    }
}


// Where melt presses, and its viscosity does not damp
TEST(ImplicitPressure, pressureLimitsTheStep)
{
    schemeCase scheme(densityLump(9), implicitMelt + "speedOfSound 20; }");
    sphSystem& s = scheme.system;
    particles& f = s.fluid;
    const double rho0 = s.thermo.rho(), h = s.near.kernel().h();
    std::fill(f.rho.begin(), f.rho.end(), 0.999*rho0);
    std::fill(f.ax.begin(), f.ax.end(), 0);
    f.ay = f.az = f.dRho = f.u = f.v = f.w = f.ax;
    EXPECT_NE(scheme.scheme->limits().ruling(), "pressure");

    f.rho[5] = 1.01*rho0;
    f.eta.assign(f.size(), 1e-6);
    const double p = 400*0.01*rho0;
    EXPECT_EQ(scheme.scheme->limits().ruling(), "pressure");
    EXPECT_NEAR
    (
        scheme.scheme->limits().deltaT(), 0.6*h/std::sqrt(p/f.rho[5]), 1e-12
    );
    f.eta.assign(f.size(), 1e3);
    EXPECT_NEAR(scheme.scheme->limits().deltaT(), 0.6*1e3/(2*p), 1e-12);
}


TEST(ImplicitPressure, speedOfSoundFollowsFromTheDensityError)
{
    // From the top of the cloud to the lowest wall particle
    particleCloud cloud
    (
        lattice{{4, 6, 4}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.2}
    );
    schemeCase scheme(cloud, implicitMelt + "speedOfSound 1; }");
    sphSystem& s = scheme.system;
    s.g = {0, -10, 0};
    s.soundSpeed = 0;

    implicitPressure term
    (
        dictionary(IStringStream("densityError 0.02;")()), s
    );
    term.allocate();
    EXPECT_NEAR(s.soundSpeed, std::sqrt(2*10*0.05/0.02), 1e-9);

    // Once for the run
    s.fluid.y[0] += 1;
    const double c = s.soundSpeed;
    term.allocate();
    EXPECT_EQ(s.soundSpeed, c);
}


TEST(ImplicitPressure, badInputIsRejected)
{
    schemeCase scheme(densityLump(1), implicitMelt + "speedOfSound 1; }");
    sphSystem& s = scheme.system;

    for
    (
        const char* text :
        {
            "speedOfSound 0;", "speedOfSound nan;", "densityError 0;",
            "densityError -1;"
        }
    )
    {
        EXPECT_THROW
        (
            implicitPressure(dictionary(IStringStream(text)()), s),
            Foam::IOerror
        ) << text;
    }

    // Without gravity and motion
    s.g = {0, 0, 0};
    s.soundSpeed = 0;
    for (int i = 0; i < s.fluid.size(); ++i)
    {
        s.fluid.u[i] = s.fluid.v[i] = s.fluid.w[i] = 0;
    }
    implicitPressure term(dictionary::null, s);
    EXPECT_THROW(term.allocate(), Foam::IOerror);
}

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
