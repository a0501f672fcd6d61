/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"
#include "volFields.H"

using namespace Foam;
using namespace Foam::melt;
using unitTest::sceneCase;

namespace
{

//- A material that melts at 300 K, with latent heat, on a hot floor
std::string melting(const std::string& rheology)
{
    return
        "material { thermo { rho 1000; Cp 2000; CpLiquid 3000; kappa 50;"
        " kappaLiquid 20; solidus 300; latentHeat 1e4; TMin 200; TMax 500; }"
        " rheology { type Newtonian; eta " + rheology + "; } }\n";
}


const std::string hotFloor =
    "zMin { type fixedValue; value uniform 400; }"
    " \".*\" { type zeroGradient; }";


//- The message of the error that the method is refused with
std::string refusal(sceneCase& files, const word& file, const std::string& dict)
{
    files.set(file, dict);
    try
    {
        const meltScene scene(files.mesh(), 0.1);
        eulerianMethod(files.mesh(), scene);
    }
    catch (const error& err)
    {
        return err.message();
    }
    return "accepted";
}

} // End anonymous namespace


// Splashing in a closed box: nothing is lost, and alpha stays in 0..1
TEST(EulerianMethod, conservesMassAndEnergy)
{
    sceneCase files;
    files.setMaterial(melting("1"));
    files.setBoundary("T", hotFloor);
    const meltScene scene(files.mesh(), 0.1);
    eulerianMethod method(files.mesh(), scene);

    const meltDiagnostics start(method.diagnostics());
    EXPECT_NEAR(start.mass, 64, 1e-9);
    EXPECT_NEAR(start.solidFraction(), 1, 1e-12);

    scalar time = 0;
    for (label step = 0; step < 60; ++step)
    {
        const scalar deltaT = min(method.maxDeltaT(), 0.5);
        ASSERT_GT(deltaT, 0);
        method.advance(deltaT);
        time += deltaT;
        const meltDiagnostics d(method.diagnostics());
        ASSERT_NEAR(d.mass, start.mass, 1e-9*start.mass);
        ASSERT_NEAR
        (
            d.thermalEnergy - start.thermalEnergy,
            d.heatIn - d.heatOut,
            1e-6*d.heatIn
        );
        ASSERT_GE(d.minT, 300 - 1e-6);
        ASSERT_LE(d.maxT, 400);
        ASSERT_GE(d.bounds.min().z(), -1e-12);
    }
    const meltDiagnostics end(method.diagnostics());
    EXPECT_GT(time, 1);
    EXPECT_GT(end.meltedFraction, 0);
    EXPECT_GT(end.heatIn, 0);
}


// What has the temperature of its wall exchanges round-off with it: no failure
TEST(EulerianMethod, thermalEquilibrium)
{
    sceneCase files;
    files.set("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);");
    files.setBoundary("T", hotFloor);
    files.setShapes
    (
        sceneCase::box
        (
            "melt", "(0 0 0)", "(1 1 0.4)",
            "{ type linear; direction (1 0 0); T1 390; T2 399; }"
        )
    );
    const meltScene scene(files.mesh(), 0.25);
    eulerianMethod method(files.mesh(), scene);
    for (label step = 0; step < 100; ++step)
    {
        method.advance(1e6);
    }
    EXPECT_NEAR(method.diagnostics().maxT, 400, 1e-9);
}


// Convection in a full box: there is no room for what the solver leaves of div U
TEST(EulerianMethod, fullBoxStaysFull)
{
    sceneCase files;
    files.set("system/eulerianSolution", "buoyancy { beta 1e-3; TRef 300; }");
    files.setMaterial(melting("0.1"));
    files.setShapes
    (
        sceneCase::box
        (
            "all", "(0 0 0)", "(1 1 1)",
            "{ type linear; direction (1 0 0); T1 320; T2 380; }"
        )
    );
    const meltScene scene(files.mesh(), 0.1);
    eulerianMethod method(files.mesh(), scene);
    for (label step = 0; step < 6; ++step)
    {
        method.advance(min(method.maxDeltaT(), 1.0));
    }
    EXPECT_GT(method.diagnostics().maxU, 1e-3);
    const volScalarField& alpha =
        files.mesh().time().lookupObject<fvMesh>(eulerianMesh::regionName)
       .lookupObject<volScalarField>("alpha.melt");
    EXPECT_LE(gMax(alpha.primitiveField()), 1 + 1e-9);
    EXPECT_GE(gMin(alpha.primitiveField()), 1 - 1e-4);
    EXPECT_NEAR(gAverage(alpha.primitiveField()), 1, 1e-9);
}


// Solid melt does not creep, whatever its viscosity is
TEST(EulerianMethod, solidStays)
{
    for (const std::string solid : {"type constraint;", "type sink; coefficient 1e12;"})
    {
        sceneCase files;
        files.set("system/eulerianSolution", "solid { " + solid + " }");
        files.setShapes
        (
            sceneCase::box
            (
                "cube", "(0.3 0.3 0.3)", "(0.7 0.7 0.7)",
                "{ type uniform; value 300; }"
            )
        );
        const meltScene scene(files.mesh(), 0.1);
        eulerianMethod method(files.mesh(), scene);
        for (label step = 0; step < 10; ++step)
        {
            method.advance(method.maxDeltaT());
        }
        EXPECT_LT(method.diagnostics().maxU, 1e-6) << solid;

        // The log says that a body would fall
        OStringStream log;
        method.report(log);
        EXPECT_EQ
        (
            log.str().find("64 cells of solid melt hang on no wall")
         != std::string::npos,
            solid.find("constraint") != std::string::npos
        ) << log.str();
        EXPECT_NEAR(method.diagnostics().centreOfMass.z(), 0.5, 1e-5) << solid;
    }
}


TEST(EulerianMethod, startsWithTheMotionOfItsShapes)
{
    sceneCase files;
    files.set("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);");
    files.setShapes
    (
        "cube { type box; min (0.3 0.3 0.3); max (0.7 0.7 0.7);"
        " U (0.3 0 0); omega (0 0 1); T { type uniform; value 350; } }"
    );
    const meltScene scene(files.mesh(), 0.1);
    eulerianMethod method(files.mesh(), scene);
    const scalar deltaT = 0.01;
    for (label step = 0; step < 10; ++step)
    {
        method.advance(deltaT);
    }
    const meltDiagnostics d(method.diagnostics());
    EXPECT_NEAR(d.centreOfMass.x(), 0.5 + 0.3*0.1, 1e-3);
    EXPECT_NEAR(d.centreOfMass.y(), 0.5, 1e-3);
    EXPECT_GT(d.maxU, 0.35);
}


// 0/p_rgh: a column on an open floor rests on the pressure that is its weight,
// falls without it, and stands on a floor that is closed
TEST(EulerianMethod, pressureOfOpenPatches)
{
    const auto speed = [](const std::string& floor)
    {
        sceneCase files({"wall", "wall", "wall", "wall", "patch", "patch"});
        files.setBoundary("U", "\".*\" { type slip; }");
        if (floor.size())
        {
            files.set
            (
                "0/p_rgh",
                "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;"
                " boundaryField { zMin { " + floor + " } zMax { type fixedValue;"
                " value uniform 9810; } \"[xy].*\" { type zeroGradient; } }"
            );
        }
        files.setShapes
        (
            sceneCase::box
            (
                "column", "(0 0 0)", "(1 1 0.6)",
                "{ type uniform; value 350; }"
            )
        );
        const meltScene scene(files.mesh(), 0.1);
        eulerianMethod method(files.mesh(), scene);
        method.advance(0.01);
        return method.diagnostics().maxU;
    };
    EXPECT_NEAR(speed("type fixedValue; value uniform 5886;"), 0, 1e-8);
    EXPECT_NEAR(speed("type uniformFixedValue; uniformValue 5886;"), 0, 1e-8);
    EXPECT_NEAR(speed("type zeroGradient;"), 0, 1e-8);
    EXPECT_NEAR(speed(""), 0.0981, 1e-3);

    // Half the weight
    EXPECT_NEAR(speed("type fixedValue; value uniform 2943;"), 0.04905, 5e-4);
}


TEST(EulerianMethod, badPressure)
{
    sceneCase files({"wall", "wall", "wall", "wall", "wall", "patch"});
    const auto refused = [&](const std::string& floor, const std::string& top)
    {
        return refusal
        (
            files,
            "0/p_rgh",
            "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;"
            " boundaryField { zMin { " + floor + " } zMax { " + top
          + " } \"[xy].*\" { type zeroGradient; } }"
        );
    };
    const std::string zero("type zeroGradient;");
    EXPECT_NE
    (
        refused("type fixedValue; value uniform 0;", zero)
       .find("on wall zMin is not supported"),
        std::string::npos
    );
    EXPECT_NE
    (
        refused(zero, "type fixedGradient; gradient uniform 1;")
       .find("Accepted: fixedValue"),
        std::string::npos
    );
    EXPECT_EQ(refused(zero, zero), "accepted");
}


TEST(EulerianMethod, badInput)
{
    const word file("system/eulerianSolution");
    const std::pair<std::string, std::string> wrong[] =
    {
        {"timeStep { force 0; }", "force"},
        {"momentum { tolerance 0; }", "tolerance"},
        {"momentum { wetFrom 0.6; }", "wetFrom"},
        {"momentum { maxSweeps 0; }", "maxSweeps"},
        {"energy { tolerance -1; }", "tolerance"},
        {"solid { type rigid; }", "constraint none sink"},
        {"solid { type sink; }", "coefficient"},
        {"solid { flowFraction 2; }", "flowFraction"},
        {"buoyancy { beta 1e-3; }", "TRef"}
    };
    for (const auto& [dict, word] : wrong)
    {
        sceneCase files;
        EXPECT_NE(refusal(files, file, dict).find(word), std::string::npos)
            << dict << ": " << refusal(files, file, dict);
    }

    sceneCase files;
    files.setMaterial
    (
        sceneCase::material()
      + " vents { summit { position (0.5 0.5 2); radius 0.1; rate 1;"
        " temperature 300; } }"
    );
    EXPECT_NE
    (
        refusal(files, file, "").find("is not in the domain"),
        std::string::npos
    );
}


// 5 kg/s of 350 K, h = 1e4 + 3000 (350 - 300) J/kg
TEST(EulerianMethod, ventsBringMassAndHeat)
{
    sceneCase files;
    files.setMaterial
    (
        melting("1")
      + " vents { summit { position (0.5 0.5 0.2); radius 0.15; rate 5;"
        " temperature 350; } }"
    );
    const meltScene scene(files.mesh(), 0.1);
    eulerianMethod method(files.mesh(), scene);
    const meltDiagnostics start(method.diagnostics());
    scalar time = 0;
    for (label step = 0; step < 20; ++step)
    {
        const scalar deltaT = min(method.maxDeltaT(), 0.05);
        method.advance(deltaT);
        time += deltaT;
    }
    const meltDiagnostics d(method.diagnostics());
    EXPECT_GT(time, 0.1);
    EXPECT_NEAR(d.mass - start.mass, 5*time, 1e-9*start.mass);
    EXPECT_NEAR
    (
        d.thermalEnergy - start.thermalEnergy, 5*time*1.6e5, 1e-6*5*time*1.6e5
    );
}


// A step that a cube stands on: what of the cube is in it is not there, and
// nothing comes there
TEST(EulerianMethod, terrainHasNoMelt)
{
    sceneCase files;
    files.setMaterial
    (
        sceneCase::material()
      + " terrain { step { type box; min (-1 -1 -1); max (0.5 2 0.3); } }"
    );
    const meltScene scene(files.mesh(), 0.1);
    eulerianMethod method(files.mesh(), scene);
    EXPECT_NEAR(method.diagnostics().mass, 64 - 24, 1e-9);
    for (label step = 0; step < 30; ++step)
    {
        method.advance(min(method.maxDeltaT(), 0.05));
    }
    const meltDiagnostics d(method.diagnostics());
    EXPECT_NEAR(d.mass, 40, 1e-9);
    EXPECT_GT(d.frontRadius, 0.3);

    const fvMesh& region =
        files.mesh().time().lookupObject<fvMesh>("eulerian");
    const auto& alpha = region.lookupObject<volScalarField>("alpha.melt");
    forAll(alpha, celli)
    {
        const point& c = region.C()[celli];
        if (c.x() < 0.5 && c.z() < 0.3)
        {
            ASSERT_EQ(alpha[celli], 0) << c.x() << ' ' << c.y() << ' ' << c.z();
        }
    }
}
