/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatSources.H"
#include "meltScene.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"

using namespace Foam;
using namespace Foam::melt;
using unitTest::sceneCase;

namespace
{

const char* const SouzaMendesDutra =
    "material { thermo { rho 1000; Cp 2000; kappa 0.2; solidus 330;"
    " TMin 280; TMax 400; } rheology { type SouzaMendesDutra;"
    " tau0 1; K 1; n 0.5; jumpNumber 1; } }";


effectSwitches effects(sceneCase& files, const std::string& entries)
{
    files.setMaterial(sceneCase::material() + "effects {" + entries + "}");
    return meltScene(files.mesh(), 0.1).effects();
}

} // End anonymous namespace


TEST(EffectSwitches, heatConductionIsOnIfTemperaturesDiffer)
{
    sceneCase files;
    EXPECT_FALSE(effects(files, "")("heatConduction"));

    files.setBoundary("T", "\".*\" { type fixedValue; value uniform 300; }");
    EXPECT_FALSE(effects(files, "")("heatConduction"));

    files.setBoundary("T", "\".*\" { type fixedValue; value uniform 301; }");
    EXPECT_TRUE(effects(files, "")("heatConduction"));

    files.setBoundary("T", "\".*\" { type zeroGradient; }");
    files.setShapes
    (
        sceneCase::box
        (
            "cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)",
            "{ type linear; direction (0 0 1); T1 300; T2 310; }"
        )
    );
    EXPECT_TRUE
    (
        meltScene(files.mesh(), 0.1).effects()("heatConduction")
    );
}


TEST(EffectSwitches, generalisedNewtonianFollowsTheRheology)
{
    sceneCase files;
    EXPECT_FALSE(effects(files, "")("generalisedNewtonian"));

    files.setMaterial(SouzaMendesDutra);
    EXPECT_TRUE
    (
        meltScene(files.mesh(), 0.1).effects()("generalisedNewtonian")
    );
}


TEST(EffectSwitches, mayBeForced)
{
    sceneCase files;

    EXPECT_TRUE(effects(files, "heatConduction on;")("heatConduction"));
    EXPECT_TRUE(effects(files, "XSPH auto;")("XSPH"));
    EXPECT_FALSE(effects(files, "XSPH off;")("XSPH"));

    const wordList active
    (
        effects(files, "XSPH off; heatConduction on;").active()
    );
    EXPECT_EQ
    (
        active,
        wordList
        (
            {
                "artificialViscosity", "heatConduction", "particleCollision",
                "rigidSolids"
            }
        )
    );
    EXPECT_TRUE(effects(files, "phaseChange on;")("phaseChange"));
}


TEST(EffectSwitches, heatSourcesAreOnIfThereAreAny)
{
    sceneCase files;
    EXPECT_FALSE(effects(files, "")("heatSources"));

    const std::string lamp =
        "heatSources { lamp { type pointSource; position (0 0 0.9);"
        " power 10; } }";
    files.setMaterial(sceneCase::material() + lamp);
    {
        const meltScene scene(files.mesh(), 0.1);
        EXPECT_TRUE(scene.effects()("heatSources"));
        EXPECT_TRUE(scene.effects()("heatConduction"));
        EXPECT_TRUE(scene.effects()("phaseChange"));
        EXPECT_EQ(heatSources(scene.dict()).size(), 1);
    }

    files.setMaterial
    (
        sceneCase::material() + lamp + "effects { heatSources off; }"
    );
    const meltScene scene(files.mesh(), 0.1);
    EXPECT_EQ(heatSources(scene.dict()).size(), 0);
}


TEST(EffectSwitches, phaseChangeIsOnIfTheSceneCrossesTheMeltingRange)
{
    // The melting range is 330 K, the cube has 300 K
    sceneCase files;
    const std::string two = "kappa 1; kappaLiquid 3; liquidus 340;";

    const auto conductivities = [&](const char* T, const char* choice)
    {
        files.setMaterial
        (
            sceneCase::material(two) + "effects { " + choice + " }"
        );
        files.setBoundary
        (
            "T", std::string("\".*\" { type fixedValue; value uniform ")
          + T + "; }"
        );
        const meltScene scene(files.mesh(), 0.1);
        return std::make_pair
        (
            scene.thermo().kappaSolid(), scene.thermo().kappaLiquid()
        );
    };
    using pair = std::pair<scalar, scalar>;

    EXPECT_EQ(conductivities("330", ""), pair(1, 1));
    EXPECT_EQ(conductivities("331", ""), pair(1, 3));
    EXPECT_EQ(conductivities("331", "phaseChange off;"), pair(1, 1));
    EXPECT_EQ(conductivities("330", "phaseChange on;"), pair(1, 3));

    files.setBoundary("T", "\".*\" { type zeroGradient; }");
    files.set
    (
        "constant/meltProperties",
        "shapes { " + sceneCase::box
        (
            "cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)",
            "{ type uniform; value 340; }"
        ) + "}" + sceneCase::material(two)
    );
    const meltScene liquid(files.mesh(), 0.1);
    EXPECT_FALSE(liquid.effects()("phaseChange"));
    EXPECT_EQ(liquid.thermo().kappaSolid(), 3);

    // At its melting point it is solid, and can melt
    files.set
    (
        "constant/meltProperties",
        "shapes { " + sceneCase::box
        (
            "cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)",
            "{ type uniform; value 330; }"
        ) + "}" + sceneCase::material("kappa 1; kappaLiquid 3;")
    );
    files.setBoundary("T", "\".*\" { type fixedValue; value uniform 340; }");
    const meltScene melting(files.mesh(), 0.1);
    EXPECT_TRUE(melting.effects()("phaseChange"));
    EXPECT_EQ(melting.thermo().kappaLiquid(), 3);
}


TEST(EffectSwitches, rigidSolidsAreOnUnlessAllIsLiquidAndStaysSo)
{
    // The melting range ends at 330 K
    sceneCase files;
    const auto on = [&](const std::string& T, const std::string& more)
    {
        files.set
        (
            "constant/meltProperties",
            "shapes { " + sceneCase::box
            (
                "cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)",
                "{ type uniform; value " + T + "; }"
            ) + "}" + sceneCase::material() + more
        );
        return meltScene(files.mesh(), 0.1).effects()("rigidSolids");
    };

    EXPECT_TRUE(on("300", ""));
    EXPECT_TRUE(on("330", ""));
    EXPECT_FALSE(on("331", ""));
    EXPECT_FALSE(on("300", "effects { rigidSolids off; }"));
    EXPECT_TRUE
    (
        on("331", "heatSources { air { type oven; temperature 290; h 10; } }")
    );
}


TEST(EffectSwitches, surfaceHeatLossIsTheExchangeWithAnOven)
{
    sceneCase files;
    const std::string sources =
        "heatSources { air { type oven; temperature 290; h 10;"
        " emissivity 0.5; }"
        " lamp { type pointSource; position (0 0 0.9); power 10; } }";

    const auto made = [&](const std::string& more)
    {
        files.setMaterial(sceneCase::material() + sources + more);
        const meltScene scene(files.mesh(), 0.1);
        return heatSources(scene.dict()).size();
    };

    EXPECT_FALSE(effects(files, "")("surfaceHeatLoss"));
    EXPECT_EQ(made(""), 2);
    EXPECT_EQ(made("effects { surfaceHeatLoss off; }"), 1);
    EXPECT_EQ(made("effects { heatSources off; }"), 0);

    files.setMaterial(sceneCase::material() + sources);
    const meltScene scene(files.mesh(), 0.1);
    EXPECT_TRUE(scene.effects()("surfaceHeatLoss"));

    OStringStream os;
    scene.effects().report(os);
    const scalar h = 10 + 4*0.5*5.670367e-8*pow3(300.0);
    OStringStream number;
    number << "Bi = " << h*0.4/scene.thermo().kappaSolid();
    EXPECT_NE(os.str().find(number.str()), std::string::npos) << os.str();
}


TEST(EffectSwitches, buoyancyNeedsGravityAndTemperaturesThatDiffer)
{
    sceneCase files;
    EXPECT_FALSE(effects(files, "")("buoyancy"));

    files.setBoundary("T", "\".*\" { type fixedValue; value uniform 301; }");
    EXPECT_TRUE(effects(files, "")("buoyancy"));
    EXPECT_FALSE(effects(files, "buoyancy off;")("buoyancy"));

    files.set("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);");
    EXPECT_FALSE(effects(files, "")("buoyancy"));
}


TEST(EffectSwitches, latentHeatIsOnIfTheMaterialHasIt)
{
    sceneCase files;
    EXPECT_FALSE(effects(files, "")("latentHeat"));

    const std::string L = sceneCase::material("latentHeat 1e5;");
    files.setMaterial(L);
    EXPECT_EQ
    (
        meltScene(files.mesh(), 0.1).thermo().enthalpy().latentHeat, 1e5
    );
    files.setMaterial(L + "effects { latentHeat off; }");
    EXPECT_EQ
    (
        meltScene(files.mesh(), 0.1).thermo().enthalpy().latentHeat, 0
    );
}


TEST(EffectSwitches, surfaceTensionFollowsTheBondNumber)
{
    // The cube has an edge of 0.4 m: Bo = rho 9.81 0.4^2/sigma
    sceneCase files;
    EXPECT_FALSE(effects(files, "")("surfaceTension"));

    const auto on = [&](const char* sigma, const char* choice)
    {
        files.setMaterial
        (
            sceneCase::material(std::string("surfaceTension ") + sigma)
          + "effects { " + choice + " }"
        );
        return meltScene(files.mesh(), 0.1).effects()("surfaceTension");
    };
    EXPECT_FALSE(on("0.03;", ""));
    EXPECT_TRUE(on("0.03;", "surfaceTension on;"));
    EXPECT_TRUE(on("100;", ""));
    EXPECT_FALSE(on("100;", "surfaceTension off;"));
    EXPECT_THROW(on("-1;", ""), IOerror);

    files.set("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);");
    EXPECT_TRUE(on("0.03;", ""));
}


TEST(EffectSwitches, numbersAreThoseOfTheScene)
{
    sceneCase files;
    files.setMaterial
    (
        "material { thermo { rho 500; Cp 2000; CpLiquid 1000; kappa 2;"
        " solidus 310; latentHeat 8e4; TMin 280; TMax 400; }"
        " rheology { type Newtonian; eta 10; } }"
    );
    files.setBoundary("T", "\".*\" { type fixedValue; value uniform 340; }");
    const meltScene scene(files.mesh(), 0.1);

    const scalar t = files.mesh().time().endTime().value();
    const auto number = [&](const word& name)
    {
        for (const effectRules::rule& rule : effectRules::all())
        {
            if (rule.name == name)
            {
                const string text(rule.judge(scene).number);
                return atof(text.substr(text.find('=') + 1).c_str());
            }
        }
        return -1.0;
    };
    EXPECT_NEAR(number("heatConduction"), 2/(500*1000.0)*t/0.16, 1e-5*t);
    EXPECT_NEAR(number("latentHeat"), 2000*40/8e4, 1e-4);
    EXPECT_NEAR(number("phaseChange"), 0.25, 1e-4);
    EXPECT_NEAR(number("generalisedNewtonian"), 1, 1e-4);
    EXPECT_NEAR
    (
        number("artificialViscosity"), 500*std::sqrt(9.81*0.4)*0.4/10, 0.01
    );
}


TEST(EffectSwitches, warnOfWhatIsOffThoughNeeded)
{
    sceneCase files;
    files.setBoundary("T", "\".*\" { type fixedValue; value uniform 301; }");

    const auto report = [&](const char* choice)
    {
        OStringStream os;
        effects(files, choice).report(os);
        return std::string(os.str());
    };
    EXPECT_EQ(report("").find("Warning"), std::string::npos);
    EXPECT_NE
    (
        report("heatConduction off;").find("Warning: heatConduction is off"),
        std::string::npos
    );
}


TEST(EffectSwitches, badInputIsRejected)
{
    sceneCase files;

    EXPECT_THROW(effects(files, "antigravity on;"), IOerror);
    EXPECT_THROW(effects(files, "XSPH maybe;"), IOerror);
    EXPECT_THROW(effects(files, "")("antigravity"), error);
}


// ************************************************************************* //
