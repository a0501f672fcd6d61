/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

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
    EXPECT_EQ(active, wordList({"artificialViscosity", "heatConduction"}));
}


TEST(EffectSwitches, badInputIsRejected)
{
    sceneCase files;

    EXPECT_THROW(effects(files, "antigravity on;"), IOerror);
    EXPECT_THROW(effects(files, "XSPH maybe;"), IOerror);
    EXPECT_THROW(effects(files, "")("antigravity"), error);
}


// ************************************************************************* //
