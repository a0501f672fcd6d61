/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianTimeStep.H"
#include "IStringStream.H"
#include "meltUnitTests.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

const scalar dx = 0.01, g = 10;


eulerianTimeStep limits
(
    const std::string& dict = "",
    const scalar gravity = g,
    const scalar capillaryTime = GREAT
)
{
    return eulerianTimeStep
    (
        dictionary(IStringStream(dict)()), dx, gravity, capillaryTime
    );
}


//- The limit that rules
word ruling
(
    const eulerianTimeStep& l,
    const scalar last,
    const scalar Courant,
    const scalar a
)
{
    word limit;
    l.longest(last, {Courant, a}, limit);
    return limit;
}


scalar longest
(
    const eulerianTimeStep& l,
    const scalar last,
    const scalar Courant,
    const scalar a
)
{
    word limit;
    return l.longest(last, {Courant, a}, limit);
}

} // End anonymous namespace


TEST(EulerianTimeStep, eachLimitInTurn)
{
    const eulerianTimeStep l(limits());
    EXPECT_DOUBLE_EQ(longest(l, 0, 0, 0), std::sqrt(0.4*dx/g));
    EXPECT_EQ(ruling(l, 0, 0, 0), "start");
    EXPECT_DOUBLE_EQ(longest(l, 1e-3, 0, 0), 2e-3);
    EXPECT_EQ(ruling(l, 1e-3, 0, 0), "growth");
    EXPECT_DOUBLE_EQ(longest(l, 1, 100, 0), 4e-3);
    EXPECT_EQ(ruling(l, 1, 100, 0), "Courant");
    EXPECT_DOUBLE_EQ(longest(l, 1, 0, g), 0.05*std::sqrt(dx/g));
    EXPECT_EQ(ruling(l, 1, 0, g), "force");

    const eulerianTimeStep tension(limits("", g, 1e-3));
    EXPECT_DOUBLE_EQ(longest(tension, 1, 0, 0), 5e-4);
    EXPECT_EQ(ruling(tension, 1, 0, 0), "capillary");

    const eulerianTimeStep other
    (
        limits("Courant 0.2; growth 3; force 0.1; capillary 0.8;", g, 1)
    );
    EXPECT_DOUBLE_EQ(longest(other, 1, 100, 0), 2e-3);
    EXPECT_DOUBLE_EQ(longest(other, 1e-3, 0, 0), 3e-3);
    EXPECT_DOUBLE_EQ(longest(other, 1, 0, g), 0.1*std::sqrt(dx/g));
    EXPECT_DOUBLE_EQ(longest(other, 1, 0, 0), 0.8);
}


// A hundredth of the weight accelerates: a step a hundred times as long
TEST(EulerianTimeStep, creepingMeltKeepsItsSteps)
{
    const eulerianTimeStep l(limits());
    EXPECT_NEAR(longest(l, 10, 0, 0.01*g), 5*std::sqrt(dx/g), 1e-12);
    EXPECT_EQ(ruling(l, 10, 0, 0), "growth");

    // Without gravity there is no scale
    EXPECT_EQ(ruling(limits("", 0), 10, 0, 1e3), "growth");
    EXPECT_EQ(limits("", 0).accepted(10, {0, 1e3}), 10);
}


// A step is repeated if it is twice too long, and the repeated one stands, also
// where the velocity changes by as much in a step of any length
TEST(EulerianTimeStep, repeatsWhatIsTooLong)
{
    const eulerianTimeStep l(limits());
    const scalar force = 0.05*std::sqrt(dx/g);
    EXPECT_EQ(l.accepted(1.99*force, {0, g}), 1.99*force);
    EXPECT_DOUBLE_EQ(l.accepted(2.01*force, {0, g}), force);
    EXPECT_EQ(l.accepted(7.9e-3, {100, 0}), 7.9e-3);
    EXPECT_DOUBLE_EQ(l.accepted(8.1e-3, {100, 0}), 4e-3);

    const scalar jump = 5;
    const scalar shorter = l.accepted(0.1, {0, jump/0.1});
    EXPECT_DOUBLE_EQ(shorter, force);
    EXPECT_EQ(l.accepted(shorter, {0, jump/shorter}), shorter);
}


TEST(EulerianTimeStep, badInput)
{
    for
    (
        const std::string wrong :
        {
            "Courant 0.7;", "Courant 0;", "growth 1;", "force 0;", "force -1;",
            "capillary 0.9;"
        }
    )
    {
        try
        {
            limits(wrong);
            ADD_FAILURE() << wrong << " accepted";
        }
        catch (const error& err)
        {
            EXPECT_NE
            (
                err.message().find(wrong.substr(0, wrong.find(' '))),
                std::string::npos
            ) << err.message();
        }
    }
}
