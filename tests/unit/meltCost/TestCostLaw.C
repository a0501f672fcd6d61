/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costLaw.H"
#include "meltUnitTests.H"
#include "StringStream.H"

#include <cmath>

using namespace Foam;
using namespace Foam::melt;

namespace
{

const scalarMinMax any(-GREAT, GREAT);

dictionary parse(const std::string& text)
{
    return dictionary(IStringStream(text)());
}

} // End anonymous namespace


TEST(CostLaw, findsTheLawOfPointsOnIt)
{
    const scalarList x({1, 2, 5, 30});
    scalarList y(4);
    forAll(x, i)
    {
        y[i] = 0.3*std::pow(x[i], -1.7);
    }

    const costLaw law(costLaw::fit(x, y, any));
    EXPECT_NEAR(law.exponent(), -1.7, 1e-12);
    EXPECT_NEAR(law(10), 0.3*std::pow(10.0, -1.7), 1e-14);
    EXPECT_NEAR(law.spread(100), 1, 1e-12);
}


TEST(CostLaw, spreadIsThe95PercentPredictionInterval)
{
    // Alternately 10 % above and below: s^2 = 4 log^2(1.1)/(4 - 2)
    const scalarList x({1, 2, 2, 1});
    const scalarList y({1.1, 1.1, 1/1.1, 1/1.1});

    const costLaw law(costLaw::fit(x, y, any));
    EXPECT_NEAR(law.exponent(), 0, 1e-12);
    
    // At the mean of the points, and away from it: v = log^2(2)
    const scalar s2 = 4.303*std::sqrt(2.0)*std::log(1.1);
    const scalar c = std::sqrt(2.0);
    EXPECT_NEAR(law.spread(c), std::exp(s2*std::sqrt(1.25)), 1e-12);
    EXPECT_NEAR(law.spread(4*c), std::exp(s2*std::sqrt(5.25)), 1e-12);
}


TEST(CostLaw, exponentStaysInItsRange)
{
    const costLaw law
    (
        costLaw::fit(scalarList({1, 4}), scalarList({1, 2}), {-GREAT, 0})
    );
    EXPECT_EQ(law.exponent(), 0);
    EXPECT_NEAR(law(100), std::sqrt(2.0), 1e-12);
    EXPECT_GT(law.spread(2), 1.4);
}


// 0.1 % of the quantile of Student's t for as many degrees of freedom
TEST(CostLaw, fewPointsSayLittle)
{
    const std::vector<std::pair<int, double>> quantiles
    ({
        {1, 12.706}, {3, 3.182}, {10, 2.228}, {11, 2.201}, {30, 2.042},
        {120, 1.980}
    });
    for (const auto& [freedom, t] : quantiles)
    {
        // At one x: residuals of 1 % up and down in turn
        scalarList x(freedom + 1, 2.0), y(freedom + 1, 1.01);
        scalar mean = 0;
        forAll(y, i)
        {
            y[i] = i % 2 ? 1.01 : 1/1.01;
            mean += std::log(y[i])/y.size();
        }
        scalar sum = 0;
        for (const scalar value : y)
        {
            sum += sqr(std::log(value) - mean);
        }
        const costLaw law(costLaw::fit(x, y, any));
        EXPECT_EQ(law.freedom(), freedom);
        EXPECT_NEAR
        (
            std::log(law.spread(2))
           /std::sqrt(sum/freedom*(1 + 1.0/y.size())),
            t,
            1e-3*t
        );
    }

    // Two points define a law, and leave nothing to judge it by
    const costLaw two(costLaw::fit(scalarList({1, 2}), scalarList({1, 3}), any));
    EXPECT_EQ(two.freedom(), 0);
    EXPECT_GE(two.spread(1.5), GREAT);
}


TEST(CostLaw, oneResolutionHasNoSlope)
{
    const costLaw law
    (
        costLaw::fit(scalarList({3, 3}), scalarList({1, 4}), any)
    );
    EXPECT_EQ(law.exponent(), 0);
    EXPECT_NEAR(law(7), 2, 1e-12);
}


TEST(CostLaw, isTheSameFromItsDictionary)
{
    const costLaw law(2.5, -1.25, 1.5, 3, 1, 4, 2);
    const costLaw read(law.dict());
    EXPECT_EQ(read(3), law(3));
    EXPECT_EQ(read.spread(9), law.spread(9));
}


TEST(CostLaw, refusesBadInput)
{
    const std::string rest = "points 1; freedom 0; centre 1; variation 0;";
    EXPECT_THROW
    (
        costLaw::fit(scalarList({1, 0}), scalarList({1, 1}), any), Foam::error
    );
    EXPECT_THROW
    (
        costLaw(parse("factor 0; exponent 1; spread 1;" + rest)),
        Foam::IOerror
    );
    EXPECT_THROW
    (
        costLaw(parse("factor 1; exponent 1; spread 0.9;" + rest)),
        Foam::IOerror
    );
    EXPECT_THROW
    (
        costLaw(parse("factor 1; spread 1;" + rest)), Foam::IOerror
    );
    EXPECT_THROW
    (
        costLaw(parse("factor 1; exponent 1; spread 1;")), Foam::IOerror
    );
}


// ************************************************************************* //
