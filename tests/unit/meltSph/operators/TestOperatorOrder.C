/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatConduction.H"
#include "latticeSymbol.H"
#include "meltUnitTests.H"
#include "pressureForce.H"
#include "velocityGradient.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

const double k = 2*M_PI;

//- What an operator makes of a wave sin(k x) in velocity v, pressure p and
//  temperature T, and what it should
using operatorOnWave = std::function<void(particleCloud&)>;
using result = std::function<double(const particles&, int)>;


//- Greatest error of the operator, n spacings to the wave, over the amplitude
//  of the right answer
double waveError
(
    const int n,
    const operatorOnWave& apply,
    const result& found,
    const result& exact
)
{
    particleCloud cloud
    (
        lattice
        {
            {n + 14, 13, 1}, 1.0/n,
            smoothingKernel::kernelType::quinticSpline, 1.5
        }
    );
    particles& f = cloud.fluid;
    for (int i = 0; i < cloud.size(); ++i)
    {
        f.v[i] = f.p[i] = f.T[i] = std::sin(k*f.x[i]);
    }
    apply(cloud);

    double error = 0, amplitude = 0;
    for (int i = 0; i < cloud.size(); ++i)
    {
        if (cloud.inside(i, cloud.near.kernel().support()))
        {
            error = std::max(error, std::abs(found(f, i) - exact(f, i)));
            amplitude = std::max(amplitude, std::abs(exact(f, i)));
        }
    }
    return error/amplitude;
}


void expectSecondOrder
(
    const operatorOnWave& apply,
    const result& found,
    const result& exact
)
{
    std::vector<double> errors;
    for (const int n : {24, 48})
    {
        errors.push_back(waveError(n, apply, found, exact));
    }
    testing::Test::RecordProperty("order", std::to_string(orderOf(errors)));
    EXPECT_NEAR(orderOf(errors), 2, 0.1);
    EXPECT_LT(errors.back(), 0.011);
}

} // End anonymous namespace


TEST(OperatorOrder, velocityGradient)
{
    expectSecondOrder
    (
        [](particleCloud& cloud)
        {
            velocityGradient(cloud.near, cloud.walls, cloud.fluid, true);
        },
        [](const particles& f, int i) { return f.S[1][i]; },
        [](const particles& f, int i) { return k*std::cos(k*f.x[i]); }
    );
}


TEST(OperatorOrder, pressureForce)
{
    expectSecondOrder
    (
        [](particleCloud& cloud)
        {
            addPressureForce(cloud.near, cloud.walls, cloud.fluid);
        },
        [](const particles& f, int i) { return f.ax[i]; },
        [](const particles& f, int i)
        {
            return -k*std::cos(k*f.x[i])/f.rho[i];
        }
    );
}


TEST(OperatorOrder, heatConduction)
{
    const double kappa = 0.3;
    expectSecondOrder
    (
        [&](particleCloud& cloud)
        {
            heatConduction
            (
                cloud.near, cloud.walls, kappa, cloud.points().spacing,
                cloud.fluid
            );
        },
        [](const particles& f, int i) { return f.dH[i]; },
        [&](const particles& f, int i)
        {
            return -kappa*k*k*std::sin(k*f.x[i])/f.rho[i];
        }
    );
}

// ************************************************************************* //
