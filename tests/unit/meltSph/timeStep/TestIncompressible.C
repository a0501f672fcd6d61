/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "schemeCase.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

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
    return cloud;
}


std::string numerics(const std::string& advective = "0.4")
{
    return
        "scheme incompressible;"
        " pressure { type implicitPressure; speedOfSound 10; }"
        " viscosity { type implicitViscosity; operator adjoint;"
        " centralShare 0.1; maxCondition 100; }"
        " implicit { tolerance 1e-9; maxIterations 4000; }"
        " timeStep { force 1; advective " + advective + "; density "
      + advective + "; }";
}


double energy(const particles& f)
{
    double sum = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        sum += 0.5*f.m[i]
           *(f.u[i]*f.u[i] + f.v[i]*f.v[i] + f.w[i]*f.w[i]);
    }
    return sum;
}

} // End anonymous namespace


// Speed and way are exact whatever the step
TEST(Incompressible, fallsFreely)
{
    schemeCase scheme(lump(1), numerics("100"));
    scheme.system.g = {0, -9.81, 0};
    const particles start = scheme.system.fluid;
    scheme.run(0.02, 3);
    const particles& f = scheme.system.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        const int now = scheme.indexOf(start.id[i]);
        ASSERT_NEAR(f.v[now], -9.81*0.02, 1e-8);
        ASSERT_NEAR(f.y[now] - start.y[i], -0.5*9.81*sqr(0.02), 1e-10);
        ASSERT_NEAR(f.x[now], start.x[i], 1e-9);
    }
}


TEST(Incompressible, keepsMomentumAndGainsNoEnergyAtAnyStep)
{
    for (const scalar deltaT : {1e-4, 1e-2, 0.1})
    {
        particleCloud cloud(lump(2));
        cloud.randomiseVelocity(0.3);
        schemeCase scheme(cloud, numerics("1e6"));
        const particles& f = scheme.system.fluid;
        const auto momentum = [&]()
        {
            return blockSum(f.size(), [&](int i) { return f.m[i]*f.u[i]; });
        };
        const double p0 = momentum();

        const double start = energy(f);
        scheme.run(2*deltaT, 2);
        EXPECT_LE(energy(f), start) << deltaT;
        EXPECT_NEAR(momentum(), p0, 1e-8*f.m[0]*f.size());
    }
}


// The energy of a lump that strains and turns after a time: its error falls with
// the step, and with the weight beyond one half
TEST(Incompressible, isOfFirstOrderWithASmallError)
{
    const auto spread =
        [](const scalar time, const label n, const std::string& implicitness)
    {
        particleCloud cloud(lump(3));
        cloud.setVelocity
        (
            [](double x, double y, double z)
            {
                return vector3{y - 0.03, 2*(x - 0.04), 0.5*(z - 0.03)};
            }
        );
        schemeCase scheme
        (
            cloud, numerics("1e6") + " implicitness " + implicitness + ";"
        );
        scheme.run(time, n);
        return energy(scheme.system.fluid);
    };

    // (1/8 - 1/128)/(1/32 - 1/128) = 5 if the error is one of first order
    const double finest = spread(4e-4, 128, "1");
    const double coarse = std::abs(spread(4e-4, 8, "1") - finest);
    const double fine = std::abs(spread(4e-4, 32, "1") - finest);
    EXPECT_GT(coarse/fine, 3.5);
    EXPECT_LT(coarse/fine, 8);

    // Longer than sound takes: viscosity
    const double limit = spread(0.05, 64, "0.5");
    const double error = std::abs(spread(0.05, 8, "1") - limit);
    EXPECT_LT(std::abs(spread(0.05, 8, "0.6") - limit), 0.3*error);
}


// A solid that lies on the floor holds the liquid on it up in each step, not only
// after it: without, the liquid sinks into it by g dt a step
TEST(Incompressible, liquidRestsOnASolid)
{
    particleCloud cloud
    (
        lattice{{5, 8, 5}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.2}
    );
    for (const bool upper : {false, true})
    {
        cloud.addWall(0, upper);
        cloud.addWall(2, upper);
    }
    cloud.addWall(1, false);
    cloud.build();

    schemeCase scheme
    (
        cloud, numerics() + " solids { type rigid; friction 0; }",
        "rigidSolids on;"
    );
    sphSystem& s = scheme.system;
    s.near = cloud.near;
    s.walls = cloud.walls;
    s.g = {0, -9.81, 0};
    particles& f = s.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        f.h[i] = f.y[i] < 0.03 ? -1e3 : 1e3;
    }
    const auto height = [&](const bool solid)
    {
        double sum = 0;
        int n = 0;
        for (int i = 0; i < f.size(); ++i)
        {
            if (f.h[i] < 0 ? solid : !solid)
            {
                sum += f.y[i];
                ++n;
            }
        }
        return sum/n;
    };
    const double liquid = height(false);
    const double deltaT = 1e-3;
    const label n = 100;
    scheme.run(n*deltaT, n);
    EXPECT_NEAR(height(true), 0.015, 1e-12);
    EXPECT_NEAR(height(false), liquid, 0.25*9.81*deltaT*n*deltaT);
}


// Forces without torque at the positions they are taken at, and the velocities
// they give move the particles
TEST(Incompressible, keepsAngularMomentumOfASpinningLump)
{
    particleCloud cloud(lump(5));
    cloud.setVelocity
    (
        [](double x, double y, double)
        {
            return vector3{-20*(y - 0.035), 20*(x - 0.04), 0};
        }
    );
    schemeCase scheme(cloud, numerics());
    const particles& f = scheme.system.fluid;
    const auto angularMomentum = [&]()
    {
        return blockSum
        (
            f.size(),
            [&](int i) { return f.m[i]*(f.x[i]*f.v[i] - f.y[i]*f.u[i]); }
        );
    };
    const double start = angularMomentum();
    // A tenth of a turn
    scheme.run(0.0314, 8);
    EXPECT_NEAR(angularMomentum()/start, 1, 1e-8);
}


// Viscosity has a lump turn as a rigid body, however long its step: what straight
// ways swell it by is taken back, as if nothing were damped
TEST(Incompressible, turnsWithoutViscousLoss)
{
    const double omega = 2;
    const auto loss = [&](const std::string& implicitness)
    {
        particleCloud cloud
        (
            lattice
            {
                {6, 5, 4}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3
            }
        );
        cloud.setVelocity
        (
            [&](double x, double y, double)
            {
                return vector3{-omega*(y - 0.025), omega*(x - 0.03), 0};
            }
        );
        schemeCase scheme
        (
            cloud,
            numerics() + " implicit { tolerance 1e-6; } implicitness "
          + implicitness + ";"
        );
        const particles& f = scheme.system.fluid;
        const double before = energy(f);
        // By 0.1 rad a step
        scheme.run(1/omega, 10);
        return 1 - energy(f)/before;
    };

    const double undamped = loss("0.5");
    const double viscous = loss("1") - undamped;
    RecordProperty("undamped", std::to_string(undamped));
    RecordProperty("1", std::to_string(viscous));
    for (const std::string implicitness : {"0.6", "0.75"})
    {
        const double more = loss(implicitness) - undamped;
        RecordProperty(implicitness, std::to_string(more));
        EXPECT_LT(std::abs(more), 0.05*viscous) << implicitness;
    }
    EXPECT_GT(viscous, 0.02);
}


// Twice as far as the limit allows: done again in halves
TEST(Incompressible, tooLongAStepIsDoneAgain)
{
    particleCloud cloud(lump(4));
    cloud.setVelocity
    (
        [](double, double, double) { return vector3{1, 0, 0}; }
    );
    schemeCase scheme(cloud, numerics());
    const double x0 = scheme.system.fluid.x[0];
    const int id = scheme.system.fluid.id[0];
    scheme.run(0.04, 1);
    EXPECT_NEAR
    (
        scheme.system.fluid.x[scheme.indexOf(id)] - x0, 0.04, 1e-9
    );

    OStringStream log;
    scheme.scheme->report(log);
    EXPECT_NE(log.str().find("done again in halves: 7"), std::string::npos)
        << log.str();
}


// What comes together within a step is compressed before pressure resists: the
// limit of the density, which is in proportion to the Mach number, is one for
// that too
TEST(Incompressible, gainsNoEnergyWhereMeltMeets)
{
    const double U = 10, c = U/std::sqrt(0.001);
    const auto gain = [&](const std::string& density)
    {
        particleCloud cloud
        (
            lattice{{8, 5, 5}, 0.002, smoothingKernel::kernelType::wendlandC2, 1.2}
        );
        particles& melt = cloud.fluid;
        const double middle = 3.5*0.002;
        for (int i = 0; i < melt.size(); ++i)
        {
            const double side = melt.x[i] < middle ? -1 : 1;
            melt.x[i] += 0.0014*side;
            melt.u[i] = -U*side;
        }
        cloud.build();
        schemeCase scheme
        (
            cloud,
            "scheme incompressible;"
            " pressure { type implicitPressure; densityError 0.001; }"
            " viscosity { type implicitViscosity; operator central; }"
            " implicit { tolerance 1e-9; maxIterations 4000; }"
            " timeStep { force 1e6; pressure 1e6; " + density + " }"
        );
        const particles& f = scheme.system.fluid;
        const double before = energy(f);
        double most = 0;
        scheme.scheme->start();
        for (int step = 0; step < 5; ++step)
        {
            scheme.scheme->advance(8e-5);
            double elastic = 0;
            for (int i = 0; i < f.size(); ++i)
            {
                const double r = f.rho[i]/1000;
                elastic += f.m[i]*c*c*(std::log(r) + 1/r - 1);
            }
            most = std::max(most, (energy(f) + elastic)/before - 1);
        }
        return most;
    };
    const double without = gain("density 1e6;"), with = gain("");
    RecordProperty("without", std::to_string(without));
    RecordProperty("with", std::to_string(with));
    EXPECT_GT(without, 0.01);
    EXPECT_LT(with, 1e-3);
}


TEST(Incompressible, takesNoExplicitPressure)
{
    EXPECT_THROW
    (
        schemeCase(lump(5), "scheme incompressible;" + pressureAndViscosity()),
        Foam::IOerror
    );
}


TEST(Incompressible, badCoupling)
{
    for
    (
        const std::string entry :
        {"maxSolves 0;", "etaTolerance 0;", "etaRelaxation 2;"}
    )
    {
        EXPECT_THROW
        (
            schemeCase
            (
                lump(6),
                numerics() + " viscosity { maxSolves 2; " + entry + " }"
            ),
            Foam::IOerror
        ) << entry;
    }
}

// ************************************************************************* //
