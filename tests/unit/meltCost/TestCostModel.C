/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costModel.H"
#include "meltUnitTests.H"
#include "StringStream.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

// coarse: error 0.1/n, dear; floor: error 0.05, cheap; ten steps per duration,
// 1 us or 0.1 us an element in a step; no spread unless said otherwise
std::string model(const std::string& spread = "1")
{
    const std::string exact = " spread 1; points 3; freedom 1; centre 4; variation 1; ";
    return
        "machine test; extrapolation 2; classes { conduction { cases (slab);"
        " methods {"
        " fine { elements melt; n (2 8);"
        " error { factor 0.1; exponent -1; spread " + spread + ";"
        " points 1e10; freedom 1e10; centre 4; variation 1e10; }"
        " steps { factor 10; exponent 0;" + exact + "}"
        " cpuTime { factor 1e-6; exponent 0;" + exact + "} }"
        " \"floor:rough\" { elements domain; n (2 8);"
        " error { factor 0.05; exponent 0;" + exact + "}"
        " steps { factor 10; exponent 0;" + exact + "}"
        " cpuTime { factor 1e-7; exponent 0;" + exact + "} } } } }";
}

costModel read(const std::string& text)
{
    return costModel(dictionary(IStringStream(text)()));
}

// A cube of 1 m that fills half of its domain, for a duration of 1
caseScales cube()
{
    caseScales scales;
    scales.caseClass = "conduction";
    scales.extent = 1;
    scales.meltVolume = 1;
    scales.domainVolume = 2;
    scales.duration = 1;
    scales.leastSteps = 1;
    return scales;
}

bool all(const word&)
{
    return true;
}

costModel::choice choose
(
    const costRequest& request,
    const std::string& text = model(),
    const costModel::filter& usable = all
)
{
    return read(text).choose(request, cube(), usable);
}

} // End anonymous namespace


TEST(CostModel, accuracyTakesTheCheapestThatIsAccurateEnough)
{
    const costModel::choice rough(choose(costRequest::accuracy("0.051")));
    EXPECT_EQ(rough.method, "floor:rough");
    EXPECT_NEAR(rough.guess.resolution, 0.5, 1e-12);
    EXPECT_NEAR(rough.guess.cpuTime, 16*10*1e-7, 1e-18);

    const costModel::choice fine(choose(costRequest::accuracy("0.03")));
    EXPECT_EQ(fine.method, "fine");
    EXPECT_NEAR(fine.guess.resolution, 0.25, 1e-12);
    EXPECT_NEAR(fine.guess.error, 0.025, 1e-12);
    EXPECT_NEAR(fine.guess.cpuTime, 64*10*1e-6, 1e-15);
    EXPECT_LE(fine.n, fine.finest);
}


TEST(CostModel, budgetTakesTheMostAccurateWithinIt)
{
    // 5^3 10 1e-6 s = 1.25 ms
    const costModel::choice c(choose(costRequest::budget("1.3e-3")));
    EXPECT_EQ(c.method, "fine");
    EXPECT_NEAR(c.guess.resolution, 0.2, 1e-12);

    // However much: twice as fine as tried, and it is said
    const costModel::choice all(choose(costRequest::budget("1h")));
    EXPECT_NEAR(all.guess.resolution, 1.0/16, 1e-12);
    EXPECT_GT(all.n, all.finest);
}


TEST(CostModel, theUpperEndOfTheRangeMustMeetTheRequest)
{
    const costModel::choice c
    (
        choose(costRequest::accuracy("0.03"), model("2"))
    );
    EXPECT_NEAR(c.guess.resolution, 1.0/7, 1e-12);
    EXPECT_LE(c.guess.worstError(), 0.03);
}


TEST(CostModel, whatCannotBeUsedIsNotChosen)
{
    const auto noPreset = [](const word& method)
    {
        return method.find(':') == word::npos;
    };
    EXPECT_EQ
    (
        choose(costRequest::accuracy("0.051"), model(), noPreset).method,
        "fine"
    );
    EXPECT_THROW
    (
        choose
        (
            costRequest::accuracy("0.051"),
            model(),
            [](const word&) { return false; }
        ),
        Foam::error
    );
}


TEST(CostModel, deltaTLimitsTheSteps)
{
    caseScales scales(cube());
    scales.leastSteps = 1000;
    const costModel::choice c
    (
        read(model()).choose(costRequest::accuracy("0.03"), scales, all)
    );
    EXPECT_NEAR(c.guess.steps, 1000, 1e-9);
    EXPECT_NEAR(c.guess.cpuTime, 64*1000*1e-6, 1e-12);
}


TEST(CostModel, saysTheBestThatCanBeHad)
{
    try
    {
        choose(costRequest::accuracy("0.001"));
        FAIL();
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("fine at 0.0625 m"), std::string::npos)
            << e.message();
    }
    try
    {
        choose(costRequest::budget("1e-9"));
        FAIL();
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("floor:rough at 0.5 m"), std::string::npos)
            << e.message();
    }
}


TEST(CostModel, refusesBadInput)
{
    EXPECT_THROW(read("machine a; classes {}"), Foam::IOerror);
    EXPECT_THROW
    (
        read("machine a; extrapolation 0.5; classes {}"), Foam::IOerror
    );
    EXPECT_THROW
    (
        choose
        (
            costRequest::budget("1s"),
            "machine a; extrapolation 1; classes {}"
        ),
        Foam::error
    );

    // The spread of an error is >= 1
    EXPECT_THROW(choose(costRequest::budget("1s"), model("0")), Foam::IOerror);
}


// ************************************************************************* //
