/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatConduction.H"
#include "implicitConduction.H"
#include "IStringStream.H"
#include "latticeMoment.H"
#include "meltUnitTests.H"
#include "meltSph/particleCloud/particleCloud.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const double solidus = 320;

//- Conduction alone, in a material with latent heat
struct conductor
{
    meltThermo thermo;

    autoPtr<rheologyModel> rheology;

    sphSystem system;

    implicitConduction term;

    static dictionary dict(const std::string& entries)
    {
        return dictionary(IStringStream(entries)());
    }

    conductor
    (
        const particleCloud& cloud,
        const std::string& material,
        const std::string& entries = ""
    )
    :
        thermo
        (
            dict
            (
                "rho 1000; Cp 2000; CpLiquid 2600; kappa 0.4; solidus 320;"
                " TMin 250; TMax 450; " + material
            )
        ),
        rheology(rheologyModel::New(dict("type Newtonian; eta 1;"))),
        system
        {
            thermo, rheology(), {0, 0, 0}, cloud.points().spacing,
            cloud.near, cloud.fluid, cloud.walls
        },
        term(dict(entries), system)
    {
        particles& f = system.fluid;
        f.kappa.clear();
        term.allocate();
        for (int i = 0; i < f.size(); ++i)
        {
            f.h[i] = thermo.enthalpy().h(f.T[i]);
        }
    }

    double heat() const
    {
        const particles& f = system.fluid;
        return blockSum
        (
            f.size(), [&](const int i) { return f.m[i]*f.h[i]; }
        );
    }
};

const std::string isothermal("latentHeat 2e5;");
const std::string mushy("liquidus 325; latentHeat 2e5; kappaLiquid 0.1;");


//- A disordered box with walls of fixed temperature and of heat transfer
particleCloud heated(const unsigned seed)
{
    particleCloud cloud
    (
        lattice{{8, 7, 6}, 0.01, kernelType::wendlandC2, 1.3, 0.3}, seed
    );
    cloud.addWall(0, false);
    cloud.addWall(1, true);
    for (std::size_t i = 0; i < cloud.walls.size(); ++i)
    {
        const bool fixed = cloud.walls.nx[i] > 0;
        cloud.walls.T[i] = fixed ? 400 : 280;
        cloud.walls.heatTransfer[i] =
            fixed ? std::numeric_limits<double>::infinity() : 50;
    }
    cloud.build();
    cloud.randomise(cloud.fluid.T, 290, 350);
    return cloud;
}

} // End anonymous namespace


// To round-off, however coarse the solution and whatever the phase
TEST(ImplicitConduction, heatIsConserved)
{
    for (const std::string& material : {isothermal, mushy})
    {
        for (const std::string tolerance : {"0.5", "1e-9"})
        {
            conductor c(heated(1), material, "tolerance " + tolerance + ";");
            const double before = c.heat();
            for (const double deltaT : {1.0, 100.0, 1e4})
            {
                c.term.advanceHeat(deltaT);
            }
            const double taken = c.system.heatReceived;
            EXPECT_GT(std::abs(taken), 1);
            EXPECT_NEAR(c.heat() - before, taken, 1e-12*std::abs(c.heat()));
        }
    }
}


// However long the step, nothing is hotter or colder than what heats it
TEST(ImplicitConduction, temperaturesStayWithinBounds)
{
    for (const std::string& material : {isothermal, mushy})
    {
        for (const double deltaT : {1.0, 1e2, 1e4, 1e6, 1e9})
        {
            conductor c(heated(2), material);
            for (int step = 0; step < 3; ++step)
            {
                c.term.advanceHeat(deltaT);
                for (const double T : c.system.fluid.T)
                {
                    ASSERT_GE(T, 280 - 1e-6);
                    ASSERT_LE(T, 400 + 1e-6);
                }
            }
        }
    }
}


// Many small explicit steps and many small implicit ones
TEST(ImplicitConduction, agreesWithExplicitConduction)
{
    for (const std::string& material : {isothermal, mushy})
    {
        const double time = 20;
        std::vector<double> errors;
        conductor reference(heated(3), material);
        particles& f = reference.system.fluid;
        f.dH.resize(f.size());
        conductionScale scale(reference.system.near.kernel(), 0.01);
        const int nExplicit = 400;
        for (int step = 0; step < nExplicit; ++step)
        {
            if (!f.kappa.empty())
            {
                setConductivity(reference.thermo, f);
            }
            scale.update
            (
                reference.system.near, reference.system.walls, 0.4, f
            );
            heatConduction
            (
                reference.system.near, reference.system.walls, 0.4, 0.01, f
            );
            for (int i = 0; i < f.size(); ++i)
            {
                f.h[i] += time/nExplicit*f.dH[i];
                f.T[i] = reference.thermo.enthalpy().T(f.h[i]);
            }
        }

        for (const int n : {20, 40})
        {
            conductor c(heated(3), material);
            for (int step = 0; step < n; ++step)
            {
                c.term.advanceHeat(time/n);
            }
            double worst = 0;
            for (int i = 0; i < f.size(); ++i)
            {
                worst = std::max(worst, std::abs(c.system.fluid.h[i] - f.h[i]));
            }
            errors.push_back(worst/2e5);
        }
        EXPECT_LT(errors[1], 0.02);
        EXPECT_LT(errors[1], 0.65*errors[0]);
    }
}


// Melting and freezing again and again leaves nothing behind
TEST(ImplicitConduction, cyclesAcrossTheMeltingPoint)
{
    conductor c(heated(4), isothermal);
    wallState& walls = c.system.walls;
    const particles& f = c.system.fluid;
    const auto hold = [&](const double T)
    {
        walls.T.assign(walls.size(), T);
        for (int step = 0; step < 8; ++step)
        {
            c.term.advanceHeat(1e7);
        }
    };

    hold(300);
    const double cold = c.heat();
    const double latent = 2e5*f.m[0]*f.size();
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        hold(350);
        EXPECT_GT(c.heat() - cold, latent);
        c.system.heatReceived = 0;
        const double hot = c.heat();
        hold(300);
        EXPECT_NEAR(c.heat() - hot, c.system.heatReceived, 1e-9*latent);
        ASSERT_NEAR(c.heat(), cold, 1e-9*latent) << cycle;
    }
}


// No more iterations than allowed: halves, which end as the exact step
TEST(ImplicitConduction, stepThatDoesNotConvergeIsHalved)
{
    conductor c(heated(5), isothermal, "maxIterations 12;");
    const double before = c.heat();
    c.term.advanceHeat(200);
    std::ostringstream text;
    OSstream os(text, "report");
    c.term.report(os);
    EXPECT_NE(text.str().find("halves"), std::string::npos);
    EXPECT_NEAR
    (
        c.heat() - before, c.system.heatReceived,
        1e-12*std::abs(c.heat())
    );
}


TEST(ImplicitConduction, badEntries)
{
    for
    (
        const std::string entries :
        {"tolerance 0;", "tolerance -1;", "maxIterations 0;",
         "maxPhaseIterations 0;", "tolerance word;"}
    )
    {
        EXPECT_THROW(conductor(heated(1), isothermal, entries), Foam::IOerror)
            << entries;
    }
}


// What conduction is divided by
TEST(LatticeMoment, ofTheKernels)
{
    EXPECT_NEAR
    (
        latticeMoment(smoothingKernel(kernelType::quinticSpline, 1.3, 3), 1),
        1, 0.002
    );
    const double wendland =
        latticeMoment(smoothingKernel(kernelType::wendlandC2, 1.3, 3), 1);
    EXPECT_GT(wendland, 0.95);
    EXPECT_LT(wendland, 0.99);
    EXPECT_NEAR
    (
        latticeMoment(smoothingKernel(kernelType::wendlandC2, 8, 3), 1),
        1, 1e-4
    );
    EXPECT_NEAR
    (
        latticeMoment(smoothingKernel(kernelType::wendlandC2, 0.13, 2), 0.1),
        latticeMoment(smoothingKernel(kernelType::wendlandC2, 1.3, 2, 7), 1),
        1e-12
    );
}

// ************************************************************************* //
