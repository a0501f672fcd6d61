/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltMethod.H"
#include "meltScene.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"
#include "meltVoxelAutomaton/voxelTestTools.H"
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


// A wall and air with h: in series with half a voxel of melt
TEST(VoxelAutomaton, halfAVoxelConductsBeforeASurface)
{
    sceneCase c;
    const scalar h = 20, Ta = 400, dx = 0.05, dt = 1e-3;
    const scalar floor = 0.4*0.4, sides = 4*0.4*0.1 + 0.4*0.4;
    for (const bool air : {false, true})
    {
        setScene
        (
            c,
            shapes(false),
            air ? "heatSources { air { type oven; temperature 400; h 20; } }" : ""
        );
        c.setBoundary
        (
            "T",
            air ? "\".*\" { type zeroGradient; }"
          : "\".*\" { type zeroGradient; } zMin { type"
            " externalWallHeatFluxTemperature; mode coefficient; h uniform 20;"
            " Ta constant 400; }"
        );
        const meltScene scene(c.mesh(), dx);
        voxelAutomatonMethod method(c.mesh(), scene);
        const scalar T = method.diagnostics().maxT;
        method.advance(dt);
        const scalar inSeries =
            1/(1/h + 0.5*dx/scene.thermo().kappaSolid());
        EXPECT_NEAR
        (
            method.diagnostics().heatIn
           /(inSeries*(air ? sides : floor)*(Ta - T)*dt),
            1,
            1e-3
        );
    }
}


TEST(VoxelAutomaton, wrongInputIsRefusedAndTheRangeNamed)
{
    sceneCase c;
    const std::string box
    (
        sceneCase::box("cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)")
    );
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
    const string sum(solution(published + "share 0.26; }"));
    EXPECT_NE(sum.find("Factors summing above 1"), string::npos) << sum;
    EXPECT_NE(sum.find(">= 0 and <= 0.25"), string::npos) << sum;
    EXPECT_EQ(solution(published + "share 0.25; }"), "");
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
    const string gamma(solution("heat { interval 1.1; }"));
    EXPECT_NE(gamma.find("interval"), string::npos) << gamma;
    EXPECT_NE(gamma.find("> 0 and <= 1"), string::npos) << gamma;
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
    setScene
    (
        c,
        sceneCase::box("dust", "(0.01 0.01 0.01)", "(0.011 0.011 0.011)"),
        ""
    );
    EXPECT_NE(refusal(c).find("thicker"), string::npos);

    // Terrain leaves nothing free
    setScene
    (
        c, box, "terrain { rock { type box; min (0 0 0); max (1 1 0.5); } }"
    );
    EXPECT_NE(refusal(c).find("The grid is empty"), string::npos);
}


TEST(VoxelAutomaton, roundedResolutionMakesNoFurtherLayer)
{
    const vector g(0, 0, -9.81);
    const boundBox domain(Zero, vector(1, 1, 2));
    const voxelFrame frame(domain, g, 0.0333);
    EXPECT_EQ(frame.n(), (std::array<int, 3>{30, 30, 60}));
    EXPECT_NEAR(frame.size().z(), 60*0.0333, 1e-12);
    EXPECT_NEAR(frame.position(0, 0, 0).x(), 0.5 - 15*0.0333, 1e-12);
    EXPECT_EQ(frame.position(0, 0, 0).z(), 0);
    EXPECT_EQ(voxelFrame(domain, g, 0.3).n(), (std::array<int, 3>{3, 3, 7}));
}


// A lamp has no temperature that would bound that of the melt: without
// conduction each kelvin above the material's TMax is paid for
TEST(VoxelAutomaton, strongLampHeatsBeyondTheScenesTemperatures)
{
    sceneCase c;
    c.set
    (
        "constant/meltProperties",
        "shapes { " + sceneCase::box("slab", "(0 0 0)", "(1 1 0.05)")
      + " } " + sceneCase::material("kappa 1e-6;")
      + " effects {} heatSources { lamp { type pointSource;"
        " position (0.5 0.5 0.9); power 1e7; } }"
    );
    const meltScene scene(c.mesh(), 0.05);
    voxelAutomatonMethod method(c.mesh(), scene);
    const meltDiagnostics start(method.diagnostics());
    for (label i = 0; i < 40; ++i)
    {
        method.advance(1);
    }
    const meltDiagnostics d(method.diagnostics());
    EXPECT_GT(d.maxT, 400 + 100);
    EXPECT_GE(d.minT, start.minT);
    EXPECT_NEAR
    (
        (d.thermalEnergy - start.thermalEnergy)/d.heatIn, 1, 1e-10
    );

    // In the middle, cos(angle) = 1 to 1/1000, over 4 pi (0.85 m)^2
    const scalar q = 1e7/(4*M_PI*sqr(0.85));
    EXPECT_NEAR((d.maxT - start.maxT)/(q*40/(1000*0.05*2000)), 1, 0.01);
}


// Boxes, sources and powers at random: mass to 1e-12, heat in = stored + out to
// 1e-10, nothing below nothing
TEST(VoxelAutomaton, randomSourcesKeepMassAndHeat)
{
    std::mt19937 engine(3);
    std::uniform_real_distribution<scalar> random(0, 1);
    const auto between = [&](const scalar low, const scalar high)
    {
        return std::to_string(low + (high - low)*random(engine)) + " ";
    };
    const auto corner = [&](const std::string& x, const scalar a, const scalar b)
    {
        return "(" + x + between(a, b) + between(a, b) + ")";
    };
    sceneCase c;
    for (int scene = 0; scene < 6; ++scene)
    {
        std::string bodies, sources;
        for (int i = 0; i < 3; ++i)
        {
            const std::string name(std::to_string(i));
            bodies += sceneCase::box
            (
                "box" + name,
                corner(between(0.3*i + 0.05, 0.3*i + 0.1), 0.05, 0.45),
                corner(between(0.3*i + 0.2, 0.3*i + 0.35), 0.5, 0.8),
                "{ type uniform; value " + between(290, 350) + "; }"
            );
            sources +=
                "lamp" + name + " { type pointSource; position "
              + corner(between(0.05, 0.95), 0.85, 0.95)
              + "; power " + between(0, 1e5) + "; }"
                " coil" + name + " { type volumetricSource;"
                " box ((0.2 0.2 0.2) (0.7 0.7 0.7)); powerDensity "
              + between(0, 1e5) + "; }";
        }
        sources +=
            "air { type oven; temperature " + between(280, 400) + "; h "
          + between(0, 100) + "; emissivity 0.9; }";
        setScene(c, bodies, "heatSources { " + sources + " }");

        const meltScene melt(c.mesh(), 0.05);
        voxelAutomatonMethod method(c.mesh(), melt);
        const meltDiagnostics start(method.diagnostics());
        for (label i = 0; i < 100; ++i)
        {
            method.advance(method.maxDeltaT());
        }
        const meltDiagnostics d(method.diagnostics());
        EXPECT_NEAR(d.mass/start.mass, 1, 1e-12) << "scene " << scene;
        EXPECT_NEAR
        (
            (d.thermalEnergy - start.thermalEnergy + d.heatOut)/d.heatIn,
            1,
            1e-10
        )
            << "scene " << scene;
        EXPECT_GT(d.heatIn, 0);
        EXPECT_TRUE(::unitTest::withinCapacity(method.grid()));
    }
}

// ************************************************************************* //
