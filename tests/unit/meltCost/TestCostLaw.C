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

dictionary parse(const char* text)
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
    EXPECT_NEAR(law.spread(), 1, 1e-12);
}


TEST(CostLaw, spreadIsTwoStandardDeviations)
{
    // Alternately 10 % above and below: s^2 = 4 log^2(1.1)/(4 - 2)
    const scalarList x({1, 2, 2, 1});
    const scalarList y({1.1, 1.1, 1/1.1, 1/1.1});

    const costLaw law(costLaw::fit(x, y, any));
    EXPECT_NEAR(law.exponent(), 0, 1e-12);
    EXPECT_NEAR(law.spread(), std::exp(2*std::sqrt(2.0)*std::log(1.1)), 1e-12);
}


TEST(CostLaw, exponentStaysInItsRange)
{
    const costLaw law
    (
        costLaw::fit(scalarList({1, 4}), scalarList({1, 2}), {-GREAT, 0})
    );
    EXPECT_EQ(law.exponent(), 0);
    EXPECT_NEAR(law(100), std::sqrt(2.0), 1e-12);
    EXPECT_GT(law.spread(), 1.4);
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
    const costLaw law(2.5, -1.25, 1.5);
    const costLaw read(law.dict());
    EXPECT_EQ(read(3), law(3));
    EXPECT_EQ(read.spread(), law.spread());
}


TEST(CostLaw, refusesBadInput)
{
    EXPECT_THROW
    (
        costLaw::fit(scalarList({1, 0}), scalarList({1, 1}), any), Foam::error
    );
    EXPECT_THROW
    (
        costLaw(parse("factor 0; exponent 1; spread 1;")), Foam::IOerror
    );
    EXPECT_THROW
    (
        costLaw(parse("factor 1; exponent 1; spread 0.9;")), Foam::IOerror
    );
    EXPECT_THROW(costLaw(parse("factor 1; spread 1;")), Foam::IOerror);
}


// ************************************************************************* //
