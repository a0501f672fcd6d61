/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseScales.H"
#include "meltScene.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"

using namespace Foam;
using namespace Foam::melt;
using unitTest::sceneCase;

namespace
{

// The cube has 0.4 m and 300 K, walls 301 K; the run ends at 1 s
caseScales scales
(
    sceneCase& files,
    const std::string& g,
    const std::string& thermo,
    const std::string& eta
)
{
    files.set("constant/g", "dimensions [0 1 -2 0 0 0 0]; value " + g + ";");
    files.setBoundary("T", "\".*\" { type fixedValue; value uniform 301; }");
    files.setMaterial
    (
        "material { thermo { rho 1000; Cp 2000; kappa 0.2; " + thermo
      + " TMin 280; TMax 400; } rheology { type Newtonian; eta " + eta
      + "; } }"
    );
    return caseScales(meltScene(files.mesh(), 0.1));
}

const char* const noGravity = "(0 0 0)";
const char* const gravity = "(0 0 -10)";

} // End anonymous namespace


TEST(CaseScales, withoutGravityHeatIsConductedOrMelts)
{
    sceneCase files;
    const caseScales heat(scales(files, noGravity, "solidus 290;", "10"));
    EXPECT_EQ(heat.caseClass, "conduction");
    EXPECT_NEAR(heat.duration, 1e-7/0.16, 1e-15);
    EXPECT_NEAR(heat.leastSteps, 1, 1e-12);
    EXPECT_NEAR(heat.extent, 0.4, 1e-12);
    EXPECT_NEAR(heat.meltVolume, 0.064, 1e-12);
    EXPECT_NEAR(heat.domainVolume, 1, 1e-12);

    EXPECT_EQ
    (
        scales(files, noGravity, "solidus 300.5; latentHeat 1e5;", "10")
       .caseClass,
        "phaseChange"
    );
}


TEST(CaseScales, aLiquidUnderGravityFlows)
{
    sceneCase files;

    // H^2/nu = 16 s: inertia rules until the end
    const caseScales flow(scales(files, gravity, "solidus 290;", "10"));
    EXPECT_EQ(flow.caseClass, "viscousFlow");
    EXPECT_NEAR(flow.duration, 5, 1e-12);

    // H^2/nu = 0.016 s, nu/(g H) = 2.5 s: it has hardly moved at the end
    EXPECT_EQ
    (
        scales(files, gravity, "solidus 290;", "1e4").caseClass, "viscousFlow"
    );

    // H^2/nu = 0.16 s, nu/(g H) = 0.25 s
    const caseScales film(scales(files, gravity, "solidus 290;", "1e3"));
    EXPECT_EQ(film.caseClass, "spreading");
    EXPECT_NEAR(film.duration, 4, 1e-12);
}


TEST(CaseScales, whatStaysSolidDoesNotFlow)
{
    sceneCase files;
    EXPECT_EQ
    (
        scales(files, gravity, "solidus 350;", "10").caseClass, "conduction"
    );
}


// ************************************************************************* //
