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

using kernelType = smoothingKernel::kernelType;

//- One particle at x = 1 m that moves at 0.5 m/s
particleCloud oneParticle()
{
    particleCloud cloud(lattice{{1, 1, 1}, 0.01, kernelType::wendlandC2, 1.2});
    cloud.fluid.x[0] = 1;
    cloud.fluid.y[0] = 0;
    cloud.fluid.u[0] = 0.5;
    return cloud;
}


//- Error of position and velocity of a damped oscillator after 2 s
std::pair<double, double> oscillatorError(const label n, const double damping)
{
    const double omega = 3, t = 2;
    schemeCase scheme(oneParticle(), springAndDamper(omega, damping));
    scheme.run(t, n);

    const double d = 0.5*damping;
    const double w = std::sqrt(omega*omega - d*d);
    const double a = 1, b = (0.5 + d*a)/w;
    const double x =
        std::exp(-d*t)*(a*std::cos(w*t) + b*std::sin(w*t));
    const double u =
        std::exp(-d*t)
       *((b*w - d*a)*std::cos(w*t) - (a*w + d*b)*std::sin(w*t));
    return
    {
        std::abs(scheme.system.fluid.x[0] - x),
        std::abs(scheme.system.fluid.u[0] - u)
    };
}


//- A free lump that swings, shears and conducts heat
particleCloud swinging(const unsigned seed = 1)
{
    particleCloud cloud
    (
        lattice{{6, 5, 4}, 0.01, kernelType::wendlandC2, 1.3, 0.1}, seed
    );
    particles& f = cloud.fluid;
    cloud.setVelocity
    (
        [](double x, double y, double z)
        {
            return vector3
            {
                0.1*std::sin(40*y), 0.1*std::cos(60*x), 0.1*std::sin(50*z)
            };
        }
    );
    for (int i = 0; i < cloud.size(); ++i)
    {
        f.T[i] = 300 + 5*std::sin(100*f.x[i]);
    }
    return cloud;
}

} // End anonymous namespace


TEST(LeapFrog, secondOrderForOscillator)
{
    for (const double damping : {0.0, 0.8})
    {
        const auto coarse = oscillatorError(100, damping);
        const auto fine = oscillatorError(200, damping);
        const double x = std::log2(coarse.first/fine.first);
        const double u = std::log2(coarse.second/fine.second);
        RecordProperty("x" + std::to_string(damping), std::to_string(x));
        RecordProperty("u" + std::to_string(damping), std::to_string(u));
        EXPECT_NEAR(x, 2, 0.1);
        EXPECT_NEAR(u, 2, 0.1);
        EXPECT_LT(fine.first, 1e-3);
    }
}


TEST(LeapFrog, exactForConstantAcceleration)
{
    schemeCase scheme(oneParticle(), springAndDamper(0, 0));
    scheme.system.g = {1, 0, -9.81};
    scheme.scheme->start();
    double t = 0;
    for (const double dt : {0.01, 0.003, 0.05, 0.02})
    {
        scheme.scheme->advance(dt);
        t += dt;
    }
    const particles& f = scheme.system.fluid;
    EXPECT_NEAR(f.x[0], 1 + 0.5*t + 0.5*t*t, 1e-14);
    EXPECT_NEAR(f.z[0], -0.5*9.81*t*t, 1e-14);
    EXPECT_NEAR(f.w[0], -9.81*t, 1e-14);
}


TEST(LeapFrog, oscillatorIsReversibleAndKeepsItsEnergy)
{
    const double omega = 3, dt = 0.02;
    schemeCase scheme(oneParticle(), springAndDamper(omega, 0));
    particles& f = scheme.system.fluid;
    const auto energy = [&]()
    {
        return 0.5*(f.u[0]*f.u[0] + omega*omega*f.x[0]*f.x[0]);
    };
    const double before = energy();
    scheme.scheme->start();
    for (int step = 0; step < 500; ++step)
    {
        scheme.scheme->advance(dt);
        ASSERT_NEAR(energy()/before, 1, std::pow(omega*dt, 2)/4);
    }
    for (int step = 0; step < 500; ++step)
    {
        scheme.scheme->advance(-dt);
    }
    EXPECT_NEAR(f.x[0], 1, 1e-9);
    EXPECT_NEAR(f.u[0], 0.5, 1e-9);
}


// Pressure, viscosity and conduction together, against itself at half the step
TEST(LeapFrog, secondOrderForMelt)
{
    std::vector<particles> results;
    for (const label n : {40, 80, 160})
    {
        schemeCase scheme
        (
            swinging(), pressureAndViscosity(), "heatConduction on;"
        );
        scheme.run(4e-3, n);
        particles f = scheme.system.fluid;
        std::vector<int> order;
        for (int id = 0; id < f.size(); ++id)
        {
            order.push_back(scheme.indexOf(id));
        }
        f.permute(order);
        results.push_back(f);
    }

    const auto order = [&](particles::array particles::* a)
    {
        std::vector<double> errors;
        for (const int k : {0, 1})
        {
            double square = 0;
            for (int i = 0; i < results[0].size(); ++i)
            {
                const double error =
                    (results[k].*a)[i] - (results[k + 1].*a)[i];
                square += error*error;
            }
            EXPECT_GT(square, 0);
            errors.push_back(std::sqrt(square));
        }
        return std::log2(errors[0]/errors[1]);
    };
    const std::pair<const char*, particles::array particles::*> arrays[] =
    {
        {"x", &particles::x}, {"u", &particles::u},
        {"rho", &particles::rho}, {"h", &particles::h}
    };
    for (const auto& [name, a] : arrays)
    {
        RecordProperty(name, std::to_string(order(a)));
        EXPECT_NEAR(order(a), 2, 0.15) << name;
    }
}

// ************************************************************************* //
