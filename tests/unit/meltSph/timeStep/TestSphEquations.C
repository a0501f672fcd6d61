/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeMoment.H"
#include "meltSph/particleCloud/cloudSums.H"
#include "meltUnitTests.H"
#include "schemeCase.H"

#include <cmath>
#include <omp.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

const std::string allEffects
(
    "heatConduction on; artificialViscosity on; XSPH on;"
);

//- A disordered lump of random velocity and temperature
particleCloud lump(const unsigned seed)
{
    particleCloud cloud
    (
        lattice
        {
            {8, 7, 6}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3, 0.2
        },
        seed
    );
    cloud.randomiseVelocity(0.3);
    cloud.randomise(cloud.fluid.T, 300, 325);
    return cloud;
}


//- The limit that rules, and its value [s]
void expectLimit
(
    const particleCloud& cloud,
    const std::string& sphSolution,
    const std::string& effects,
    const std::array<double, 3>& g,
    const word& name,
    const scalar deltaT
)
{
    schemeCase scheme(cloud, sphSolution, effects);
    scheme.system.g = g;
    scheme.scheme->start();
    const timeStepControl& limits = scheme.scheme->limits();
    EXPECT_EQ(limits.ruling(), name);
    EXPECT_NEAR(limits.deltaT()/deltaT, 1, 1e-12) << name;
}

} // End anonymous namespace


// Momentum, heat and the way of the centre of mass over many steps, lists
// built anew on the way
TEST(SphEquations, freeLumpConserves)
{
    for (const unsigned seed : {1u, 2u})
    {
        schemeCase scheme(lump(seed), pressureAndViscosity(), allEffects);
        particles& f = scheme.system.fluid;
        const auto momentum = massSum(f, f.u, f.v, f.w);
        const auto centre = massSum(f, f.x, f.y, f.z);
        const double scale = massSumMag(f, f.u, f.v, f.w);
        const auto heat = massSum(f, f.h, f.h, f.h)[0];
        const double heatScale = massSumMag(f, f.h, f.rho, f.rho);
        const auto nBuilds = scheme.system.near.nBuilds();

        const double t = 0.02;
        scheme.run(t, 100);
        EXPECT_GT(scheme.system.near.nBuilds(), nBuilds);
        const auto momentumNow = massSum(f, f.u, f.v, f.w);
        const auto centreNow = massSum(f, f.x, f.y, f.z);
        for (int a = 0; a < 3; ++a)
        {
            EXPECT_NEAR(momentumNow[a], momentum[a], 1e-12*scale);
            EXPECT_NEAR
            (
                centreNow[a], centre[a] + t*momentum[a], 1e-12*scale
            );
        }
        EXPECT_NEAR(massSum(f, f.h, f.h, f.h)[0], heat, 1e-12*heatScale);
        EXPECT_EQ(scheme.system.heatFromWalls, 0);
    }
}


TEST(SphEquations, sameBytesWithOneAndTwoThreads)
{
    const int before = omp_get_max_threads();
    std::vector<particles> results;
    for (const int threads : {1, 2, 1})
    {
        omp_set_num_threads(threads);
        schemeCase scheme(lump(3), pressureAndViscosity(), allEffects);
        scheme.run(4e-3, 20);
        results.push_back(scheme.system.fluid);
    }
    omp_set_num_threads(before);
    for (const particles& f : results)
    {
        EXPECT_EQ(f.id, results[0].id);
        EXPECT_EQ(f.x, results[0].x);
        EXPECT_EQ(f.w, results[0].w);
        EXPECT_EQ(f.rho, results[0].rho);
        EXPECT_EQ(f.h, results[0].h);
    }
}


// Each limit of the time step against its formula
TEST(SphEquations, limitsOfTheTimeStep)
{
    const particleCloud still
    (
        lattice{{4, 4, 4}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.2}
    );
    const double h = 0.012;
    particleCloud moving = still;
    moving.fluid.v[5] = -90;

    const std::string rest = springAndDamper(0, 0);
    const std::string slowSound
    (
        "pressure { type linearEquationOfState; speedOfSound 0.1; }"
        " viscosity { type explicitStress; }"
    );
    const std::string heat(" heat { type explicitConduction; }");

    expectLimit(still, rest, "", {0, 0, 0}, "maxDeltaT", GREAT);
    expectLimit
    (
        still, rest, "", {0, 0, -16}, "force", 0.25*std::sqrt(h/16)
    );
    expectLimit
    (
        still, slowSound, "", {0, 0, 0}, "viscous", 0.125*h*h*1000/10
    );
    expectLimit
    (
        still, rest + heat, "heatConduction on;", {0, 0, 0}, "thermal",
        0.1*h*h*1000*2000/0.2*latticeMoment(still.near.kernel(), 0.01)
    );
    expectLimit
    (
        moving, pressureAndViscosity(), "", {0, 0, 0}, "acoustic",
        0.25*h/(10 + 90)
    );
}


// A run that has diverged is stopped, whoever sees it first
TEST(SphEquations, notANumberIsAnError)
{
    for
    (
        const std::string& terms :
        {pressureAndViscosity(), springAndDamper(1, 1)}
    )
    {
        for (const int which : {0, 100, 335})
        {
            schemeCase scheme(lump(1), terms);
            scheme.system.fluid.u[which] = std::nan("");
            scheme.scheme->start();
            EXPECT_THROW(scheme.scheme->limits(), Foam::error) << which;
        }
    }
}

// ************************************************************************* //
