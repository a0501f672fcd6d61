/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "temperatureLaw.H"
#include "checkedEntry.H"
#include "meltUnitTests.H"

#include <random>
#include <vector>

using namespace Foam;
using namespace Foam::melt;

namespace
{

autoPtr<temperatureLaw> law
(
    const std::string& text,
    const scalarMinMax& accepted = checkedEntry::notNegative()
)
{
    const dictionary dict(IStringStream("J " + text)());
    return temperatureLaw::New("J", dict, accepted);
}


const char* linear =
    "{ type jumpNumberLinear; TMin 300; TMax 350; atTMin 1000; atTMax 10; }";

const char* logarithmic =
    "{ type jumpNumberLogarithmic; TMin 300; TMax 350; atTMin 1e8; atTMax 0; }";

const char* Arrhenius =
    "{ type Arrhenius; reference 5; TReference 400; Ta 4000; TFloor 300; }";

const char* table =
    "{ type table; TMin 300; TMax 400; nPoints 101;"
    "  values table ((300 50) (350 100) (400 1)); }";

} // End anonymous namespace


TEST(TemperatureLaw, numberIsConstant)
{
    const auto constant = law("42;");

    EXPECT_EQ(constant->value(0.), 42);
    EXPECT_EQ(constant->value(1e4), 42);
}


TEST(TemperatureLaw, linearHasItsEndsAndIsClipped)
{
    const auto J = law(linear);

    EXPECT_EQ(J->value(300.), 1000);
    EXPECT_EQ(J->value(350.), 10);
    EXPECT_EQ(J->value(0.), 1000);
    EXPECT_EQ(J->value(1e6), 10);
    EXPECT_DOUBLE_EQ(J->value(325.), 505);
}


TEST(TemperatureLaw, logarithmicFallsByTheSameFactorWithEachKelvin)
{
    const auto J = law(logarithmic);
    const scalar factor = std::pow(1e8 + 1, -1/50.);

    EXPECT_NEAR(J->value(200.)/1e8, 1, 1e-14);
    EXPECT_EQ(J->value(350.), 0);
    EXPECT_EQ(J->value(400.), 0);

    for (scalar T = 300; T < 350; T += 1)
    {
        EXPECT_NEAR((J->value(T + 1) + 1)/(J->value(T) + 1), factor, 1e-13);
    }
}


TEST(TemperatureLaw, ArrheniusIsItsClosedForm)
{
    const auto eta = law(Arrhenius);

    EXPECT_DOUBLE_EQ(eta->value(400.), 5);
    for (const scalar T : {300., 333., 456., 2000.})
    {
        const scalar exact = 5*std::exp(4000*(1/T - 1/400.));
        EXPECT_NEAR(eta->value(T)/exact, 1, 1e-13) << T;
    }

    EXPECT_EQ(eta->value(0.), eta->value(300.));
}


TEST(TemperatureLaw, tableInterpolatesAndKnowsItsInnerMaximum)
{
    const auto eta = law(table);

    EXPECT_DOUBLE_EQ(eta->value(300.), 50);
    EXPECT_NEAR(eta->value(325.5), 75.5, 1e-12);
    EXPECT_NEAR(eta->value(350.), 100, 1e-12);
    EXPECT_DOUBLE_EQ(eta->value(1e9), 1);
    EXPECT_DOUBLE_EQ(eta->value(-1.), 50);

    EXPECT_NEAR(eta->range(300, 400).max(), 100, 1e-12);
    EXPECT_DOUBLE_EQ(eta->range(300, 400).min(), 1);
    EXPECT_NEAR(eta->range(310, 320).max(), 70, 1e-12);
}


TEST(TemperatureLaw, isMonotoneAndWithinItsRange)
{
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> random(250, 450);

    for (const char* text : {linear, logarithmic, Arrhenius})
    {
        const auto J = law(text);

        for (int i = 0; i < 1000; ++i)
        {
            const double a = random(generator);
            const double b = random(generator);

            EXPECT_GE(J->value(min(a, b)), J->value(max(a, b)))
                << text << ' ' << a << ' ' << b;

            const scalarMinMax range(J->range(min(a, b), max(a, b)));
            const scalar middle = J->value(0.5*(a + b));
            EXPECT_TRUE(middle >= range.min() && middle <= range.max());
        }
    }
}


TEST(TemperatureLaw, arraysGiveWhatSingleValuesGive)
{
    std::vector<double> T, values;
    for (int i = 0; i < 1001; ++i)
    {
        T.push_back(250 + 0.2*i);
    }
    values.resize(T.size());

    for (const char* text : {"3;", linear, logarithmic, Arrhenius, table})
    {
        const auto J = law(text);
        J->value(T.size(), T.data(), values.data());

        for (size_t i = 0; i < T.size(); ++i)
        {
            // Vector and scalar functions differ in the last digits
            const double one = J->value(T[i]);
            EXPECT_NEAR(values[i], one, 1e-14*(1 + mag(one))) << text << T[i];
        }
    }
}


TEST(TemperatureLaw, NaNStaysNaN)
{
    for (const char* text : {linear, logarithmic, Arrhenius, table})
    {
        EXPECT_TRUE(std::isnan(law(text)->value(std::nan("")))) << text;
    }
}


TEST(TemperatureLaw, badInputIsRejected)
{
    for
    (
        const char* text
      : {
            "-1;",
            "nan;",
            "{}",
            "{ type nothing; }",
            "{ type jumpNumberLinear; }",
            "{ type jumpNumberLinear; TMin 2; TMax 1; atTMin 2; atTMax 1; }",
            "{ type jumpNumberLinear; TMin 1; TMax 1; atTMin 2; atTMax 1; }",
            "{ type jumpNumberLinear; TMin 1; TMax 2; atTMin -2; atTMax 1; }",
            "{ type jumpNumberLinear; TMin 1; TMax nan; atTMin 2; atTMax 1; }",
            "{ type jumpNumberLogarithmic;"
            "  TMin 1; TMax 2; atTMin 2; atTMax -0.5; }",
            "{ type jumpNumberLogarithmic;"
            "  TMin 1; TMax 0; atTMin 2; atTMax 1; }",
            "{ type Arrhenius; reference -5; TReference 4; Ta 4; TFloor 3; }",
            "{ type Arrhenius; reference 5; TReference 0; Ta 4; TFloor 3; }",
            "{ type Arrhenius; reference 5; TReference 400; Ta 1e9; TFloor 1; }",
            "{ type table; TMin 3; TMax 4; values table ((3 1) (4 -1)); }",
            "{ type table; TMin 4; TMax 3; values table ((3 1) (4 1)); }",
            "{ type table; TMin 3; TMax 4; nPoints 1; values constant 1; }"
        }
    )
    {
        EXPECT_THROW(law(text), IOerror) << text;
    }
}


// ************************************************************************* //
