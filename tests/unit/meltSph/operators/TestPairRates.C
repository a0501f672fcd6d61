/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "artificialViscosity.H"
#include "heatConduction.H"
#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"
#include "pairRates.H"
#include "pressureForce.H"
#include "stressDivergence.H"
#include "xsphVelocity.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const double alphaC = 12, beta = 2, epsilon = 0.4, kappa = 0.3;

//- Everything at random, over a floor that slips and beside a wall that heats
particleCloud room(const bool uniformKappa)
{
    particleCloud cloud({{8, 7, 6}, 0.01, kernelType::quinticSpline, 1.1, 0.3});
    cloud.addWall(2, false);
    cloud.addWall(0, true);
    cloud.build();
    cloud.randomiseDensity(0.1);
    cloud.randomiseVelocity(1);
    particles& f = cloud.fluid;
    cloud.randomise(f.p, 0, 500);
    cloud.randomise(f.T, 300, 400);
    for (particles::array& s : f.S)
    {
        cloud.randomise(s, -50, 50);
    }
    if (!uniformKappa)
    {
        f.kappa.resize(cloud.size());
        cloud.randomise(f.kappa, 0.1, 10);
    }

    wallState& walls = cloud.walls;
    cloud.randomise(walls.p, 0, 500);
    cloud.randomise(walls.T, 300, 400);
    for (std::size_t i = 0; i < walls.size(); ++i)
    {
        walls.slip[i] = walls.nz[i] == 1;
        walls.heatTransfer[i] = walls.nz[i] == 1 ? 0 : 50;
    }
    return cloud;
}


//- Law n is on if bit n of the choice is
pairRates choose(const int choice)
{
    pairRates rates;
    rates.pressure = choice & 1;
    rates.stress = choice & 2;
    rates.artificialViscosity = choice & 4;
    rates.xsph = choice & 8;
    rates.conduction = choice & 16;
    rates.alphaC = alphaC;
    rates.beta = beta;
    rates.epsilon = epsilon;
    rates.kappa = kappa;
    rates.spacing = 0.01;
    return rates;
}


//- The same by one operator after the other
double oneByOne(const pairRates& rates, particleCloud& cloud)
{
    particles& f = cloud.fluid;
    if (rates.pressure)
    {
        addPressureForce(cloud.near, cloud.walls, f);
    }
    if (rates.stress)
    {
        addStressDivergence(cloud.near, cloud.walls, f);
    }
    if (rates.artificialViscosity)
    {
        addArtificialViscosity(cloud.near, alphaC, beta, 1, f);
    }
    if (rates.xsph)
    {
        xsphVelocity(cloud.near, epsilon, f);
    }
    return rates.conduction
      ? heatConduction(cloud.near, cloud.walls, kappa, 0.01, f)
      : 0;
}


void expectEqual(const particles::array& a, const particles::array& b)
{
    double scale = 0;
    for (const double value : b)
    {
        scale = std::max(scale, std::abs(value));
    }
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        ASSERT_NEAR(a[i], b[i], 1e-13*scale);
    }
}

} // End anonymous namespace


// Every choice of laws in one pass does what the operators do in turn
TEST(PairRates, onePassEqualsOneOperatorAfterTheOther)
{
    for (const bool uniform : {true, false})
    {
        const particleCloud start = room(uniform);
        for (int choice = 0; choice < 32; ++choice)
        {
            const pairRates rates = choose(choice);
            particleCloud together = start, apart = start;
            const double heat =
                rates.add(together.near, together.walls, together.fluid);
            const double expected = oneByOne(rates, apart);

            SCOPED_TRACE("choice " + std::to_string(choice));
            EXPECT_NEAR(heat, expected, 1e-12*std::abs(expected));
            EXPECT_EQ(heat != 0, rates.conduction);
            const particles &a = together.fluid, &b = apart.fluid;
            expectEqual(a.ax, b.ax);
            expectEqual(a.ay, b.ay);
            expectEqual(a.az, b.az);
            expectEqual(a.du, b.du);
            expectEqual(a.dv, b.dv);
            expectEqual(a.dw, b.dw);
            expectEqual(a.dH, b.dH);
        }
    }
}

// ************************************************************************* //
