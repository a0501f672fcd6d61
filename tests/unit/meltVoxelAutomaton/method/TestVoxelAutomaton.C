/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltMethod.H"
#include "meltScene.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"
#include "voxelAutomatonMethod.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::melt;

namespace
{

using melt::unitTest::sceneCase;

//- Slab at x from 0.3 to 0.7 m, 0.1 m thick, on its own or in the shade of
//  another 0.2 m above it; a lamp 0.8 m above it
std::string shapes(const bool shade)
{
    return
        sceneCase::box("slab", "(0.3 0.3 0)", "(0.7 0.7 0.1)")
      + (
            shade
          ? sceneCase::box("roof", "(0.2 0.2 0.3)", "(0.8 0.8 0.4)")
          : std::string()
        );
}


//- meltProperties of these shapes, heated by these sources
void setScene
(
    const sceneCase& c,
    const std::string& shapes,
    const std::string& more
)
{
    c.set
    (
        "constant/meltProperties",
        "shapes { " + shapes + " } " + sceneCase::material()
      + " effects {} " + more
    );
}


//- Diagnostics after a number of steps
meltDiagnostics after
(
    sceneCase& c,
    const label nSteps,
    const scalar deltaT = 0
)
{
    const meltScene scene(c.mesh(), 0.05);
    voxelAutomatonMethod method(c.mesh(), scene);
    for (label i = 0; i < nSteps; ++i)
    {
        method.advance(deltaT > 0 ? deltaT : method.maxDeltaT());
    }
    return method.diagnostics();
}


//- The message of the error that making the method gives
string refusal(sceneCase& c)
{
    try
    {
        const meltScene scene(c.mesh(), 0.05);
        voxelAutomatonMethod method(c.mesh(), scene);
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "";
}

} // End anonymous namespace


// Power on a square plate of half edge a at height H below the lamp, see
// "solid angle of a rectangular plate": 4 asin(a^2/(a^2 + H^2))
TEST(VoxelAutomaton, lampHeatsThePlateByItsSolidAngle)
{
    sceneCase c;
    const scalar P = 100, a = 0.2, H = 0.8, dt = 1;
    setScene
    (
        c,
        shapes(false),
        "heatSources { lamp { type pointSource; position (0.5 0.5 0.9);"
        " power 100; } }"
    );
    const scalar angle = 4*std::asin(sqr(a)/(sqr(a) + sqr(H)));
    EXPECT_NEAR
    (
        after(c, 1, dt).heatIn/(P*dt*angle/(4*M_PI)), 1, 0.01
    );
}


TEST(VoxelAutomaton, whatIsInTheShadeStaysCold)
{
    sceneCase c;
    const std::string lamp
    (
        "heatSources { lamp { type pointSource; position (0.5 0.5 0.9);"
        " power 1e5; } }"
    );
    setScene
    (
        c,
        sceneCase::box("roof", "(0.2 0.2 0.3)", "(0.8 0.8 0.4)"),
        lamp
    );
    const scalar roof = after(c, 1, 0.01).heatIn;
    setScene(c, shapes(true), lamp);
    EXPECT_EQ(after(c, 1, 0.01).heatIn, roof);
}


// The sides of a cube and its top, against cold air
TEST(VoxelAutomaton, coolsToAirAndFloorButNotBeyondThem)
{
    sceneCase c;
    setScene
    (
        c,
        sceneCase::box("cube", "(0.4 0.4 0)", "(0.6 0.6 0.2)"),
        "heatSources { air { type oven; temperature 280; h 1e5; } }"
    );
    c.setBoundary
    (
        "T",
        "\".*\" { type zeroGradient; } zMin { type fixedValue; value uniform"
        " 285; }"
    );
    const meltDiagnostics first(after(c, 1));
    EXPECT_GT(first.heatOut, 0);
    const meltDiagnostics d(after(c, 3000));
    EXPECT_GE(d.minT, 280 - 1e-9);
    EXPECT_LE(d.maxT, 285);
    EXPECT_GT(d.heatOut, first.heatOut);
}


TEST(VoxelAutomaton, wrongInputIsRefusedAndTheRangeNamed)
{
    sceneCase c;
    const std::string box(sceneCase::box("cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)"));
    setScene(c, box, "");
    const auto solution = [&](const std::string& entries)
    {
        c.set("system/voxelAutomatonSolution", entries);
        return refusal(c);
    };
    EXPECT_EQ(solution(""), "");

    const std::string published("spreading { rule published; stepTime 0.01; ");
    for
    (
        const char* entry
      : {
            "factor", "beta", "threshold", "initialEnergy", "alphaLiquid",
            "alphaSolid", "alphaFloor"
        }
    )
    {
        for (const char* value : {" 1.01; }", " -0.1; }"})
        {
            const string message(solution(published + entry + value));
            EXPECT_NE(message.find(entry), string::npos) << message;
            EXPECT_NE(message.find(">= 0 and <= 1"), string::npos) << message;
        }
    }
    // Four shares of more than the whole
    EXPECT_NE
    (
        solution(published + "share 0.26; }").find(">= 0 and <= 0.25"), string::npos
    );
    EXPECT_NE(solution("spreading { rule published; }"), "");
    EXPECT_NE
    (
        solution("spreading { rule wild; }").find("lubrication published"),
        string::npos
    );
    EXPECT_NE
    (
        solution("heat { neighbours 8; }").find("6, 18 or 26"), string::npos
    );
    // Beyond the limit of stability
    EXPECT_NE(solution("heat { interval 1.1; }").find("1"), string::npos);
    EXPECT_NE(solution("heat { interval 0; }"), "");
    EXPECT_NE(solution("heat { change 2; }"), "");
    EXPECT_NE(solution("heat { flowFraction 0; }"), "");
    EXPECT_NE(solution("spreading { dregs 2; }"), "");
    EXPECT_NE(solution("spreading { thicknessLimit 0; }"), "");
    EXPECT_NE(solution("spreading { yieldStress -1; }"), "");
    EXPECT_EQ(solution(""), "");

    setScene
    (
        c,
        box,
        "heatSources { lamp { type pointSource; position (0.5 0.5 0.2);"
        " power 100; } }"
    );
    EXPECT_NE(refusal(c).find("in the open"), string::npos);
    setScene(c, sceneCase::box("dust", "(0.01 0.01 0.01)", "(0.011 0.011 0.011)"), "");
    EXPECT_NE(refusal(c).find("thicker"), string::npos);
}

// ************************************************************************* //
