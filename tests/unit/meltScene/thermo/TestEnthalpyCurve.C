/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "enthalpyCurve.H"
#include "meltUnitTests.H"

#include <random>

using Foam::melt::enthalpyCurve;

namespace
{

const enthalpyCurve mushy{2000, 2500, 330, 340, 2e5};

const enthalpyCurve isothermal{2000, 2500, 330, 330, 2e5};

const enthalpyCurve withoutMelting{2000, 2000, 330, 330, 0};

} // End anonymous namespace


TEST(EnthalpyCurve, hasTheCapacitiesAndTheLatentHeat)
{
    for (const enthalpyCurve& curve : {mushy, isothermal, withoutMelting})
    {
        EXPECT_DOUBLE_EQ(curve.h(330), 0);
        EXPECT_DOUBLE_EQ(curve.h(310), -20*curve.CpSolid);
        EXPECT_DOUBLE_EQ
        (
            curve.h(360) - curve.h(350), 10*curve.CpLiquid
        );
    }

    // The mushy zone has the mean capacity
    EXPECT_DOUBLE_EQ(mushy.h(340), 10*2250 + 2e5);
    EXPECT_DOUBLE_EQ(isothermal.h(340), 2e5 + 10*2500);
}


TEST(EnthalpyCurve, roundTrip)
{
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> temperature(200, 500);
    std::uniform_real_distribution<double> enthalpy(-3e5, 6e5);

    for (const enthalpyCurve& curve : {mushy, isothermal, withoutMelting})
    {
        for (int i = 0; i < 10000; ++i)
        {
            const double T = temperature(generator);
            ASSERT_NEAR(curve.T(curve.h(T)), T, 1e-11);
        }
    }

    for (int i = 0; i < 10000; ++i)
    {
        const double h = enthalpy(generator);
        ASSERT_NEAR(mushy.h(mushy.T(h)), h, 1e-7);
    }
}


TEST(EnthalpyCurve, temperatureStandsStillWhileItMelts)
{
    for (const double share : {1e-9, 0.25, 0.5, 1 - 1e-9})
    {
        EXPECT_EQ(isothermal.T(share*2e5), 330);
        EXPECT_DOUBLE_EQ(isothermal.liquidFraction(share*2e5), share);
    }

    EXPECT_EQ(isothermal.liquidFraction(0), 0);
    EXPECT_EQ(isothermal.liquidFraction(2e5), 1);
    EXPECT_EQ(withoutMelting.liquidFraction(-1e-9), 0);
    EXPECT_EQ(withoutMelting.liquidFraction(1e-9), 1);
}


TEST(EnthalpyCurve, isMonotoneAndContinuous)
{
    double T = 0, fraction = 0;

    for (double h = -1e5; h < 5e5; h += 10)
    {
        EXPECT_GT(mushy.T(h), T);
        EXPECT_GE(mushy.liquidFraction(h), fraction);
        EXPECT_NEAR
        (
            (mushy.T(h + 1e-3) - mushy.T(h))*mushy.Cp(h), 1e-3, 1e-3*0.95
        );
        T = mushy.T(h);
        fraction = mushy.liquidFraction(h);
    }

    EXPECT_EQ(fraction, 1);
}


// ************************************************************************* //
