/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltScene.H"
#include "sceneCase.H"
#include "shape.H"
#include "meltUnitTests.H"
#include "OSspecific.H"

using namespace Foam;
using namespace Foam::melt;
using unitTest::sceneCase;

namespace
{

const scalar spacing = 0.1;


//- The message with which a scene of this case is rejected
std::string rejection(sceneCase& files, const scalar resolution = spacing)
{
    try
    {
        meltScene scene(files.mesh(), resolution);
    }
    catch (const error& err)
    {
        return err.message();
    }

    return "accepted";
}


void expectRejected(sceneCase& files, const char* words)
{
    const std::string message(rejection(files));
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

} // End anonymous namespace


TEST(MeltScene, fillsItsShapes)
{
    sceneCase files;
    const meltScene scene(files.mesh(), spacing);

    ASSERT_EQ(scene.shapes().size(), 1);
    EXPECT_EQ(scene.shapes()[0].name(), "cube");
    EXPECT_EQ(scene.points(0).size(), 64);
    EXPECT_NEAR(scene.pointVolume(0), 0.001, 1e-15);
    EXPECT_EQ(scene.T(0), scalarField(64, 300.));
    EXPECT_EQ(scene.g(), vector(0, 0, -9.81));
    EXPECT_EQ(scene.resolution(), spacing);
    EXPECT_EQ(scene.TRange().min(), 300);
    EXPECT_EQ(scene.TRange().max(), 300);
}


TEST(MeltScene, volumeIsThatOfTheShapeAtAnyResolution)
{
    sceneCase files;

    for (const scalar resolution : {0.01, 0.0173, 0.05, 0.09, 0.13})
    {
        const meltScene scene(files.mesh(), resolution);
        EXPECT_NEAR
        (
            scene.pointVolume(0)*scene.points(0).size(), 0.064, 1e-15
        );
    }
}


TEST(MeltScene, numberOfParticlesGivesTheResolution)
{
    sceneCase files;
    files.setShapes
    (
        "cube { type box; min (0.3 0.3 0); max (0.7 0.7 0.4); nParticles 512;"
        "    T { type uniform; value 300; } }"
      + sceneCase::box("slab", "(0 0 0.6)", "(1 1 0.7)")
    );
    const meltScene counted(files.mesh());

    EXPECT_EQ(counted.points(0).size(), 512);
    EXPECT_NEAR(counted.resolution(), 0.05, 0.002);
    EXPECT_NEAR(counted.points(1).size(), 800, 100);

    // The option is stronger
    const meltScene given(files.mesh(), spacing);
    EXPECT_EQ(given.points(0).size(), 64);
}


TEST(MeltScene, rejectsAMissingResolution)
{
    sceneCase files;
    EXPECT_NE(rejection(files, 0).find("resolution"), std::string::npos);
}


TEST(MeltScene, rejectsWrongShapes)
{
    sceneCase files;

    files.setShapes("");
    expectRejected(files, "no shape");

    files.setShapes(sceneCase::box("thin", "(0.3 0.3 0)", "(0.7 0.7 1e-5)"));
    expectRejected(files, "thin is empty");

    files.setShapes(sceneCase::box("high", "(0.3 0.3 0.7)", "(0.7 0.7 1.3)"));
    expectRejected(files, "high is outside the domain");

    files.setShapes
    (
        sceneCase::box("a", "(0.1 0.1 0)", "(0.5 0.5 0.4)")
      + sceneCase::box("b", "(0.3 0.3 0.2)", "(0.7 0.7 0.5)")
    );
    expectRejected(files, "a and b overlap");

    files.setShapes
    (
        sceneCase::box("a", "(0.1 0.1 0)", "(0.5 0.5 0.4)")
      + sceneCase::box("b", "(0.5 0.1 0)", "(0.9 0.5 0.4)")
    );
    EXPECT_EQ(rejection(files), "accepted");
}


TEST(MeltScene, rejectsTemperaturesThatTheMaterialHasNot)
{
    sceneCase files;

    for (const char* value : {"279", "401"})
    {
        const std::string T
        (
            std::string("{ type uniform; value ") + value + "; }"
        );
        files.setShapes
        (
            sceneCase::box("cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)", T)
        );
        expectRejected(files, "outside the range of the material");
    }

    files.setShapes(sceneCase::box("cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)"));
    files.setBoundary("T", "\".*\" { type fixedValue; value uniform 500; }");
    expectRejected(files, "0/T");
}


TEST(MeltScene, rejectsAMissingPart)
{
    sceneCase files;

    files.setMaterial("");
    expectRejected(files, "material");

    files.setMaterial("material {}");
    expectRejected(files, "thermo");

    files.setMaterial(sceneCase::material("rho -1;"));
    expectRejected(files, "rho");
}


TEST(MeltScene, acceptsTheAnnotatedDictionary)
{
    const fileName annotated
    (
        getEnv("MELTFOAM_DIR")/"etc/caseDicts/meltFoam/meltProperties"
    );
    sceneCase files;
    cp(annotated, unitTest::runTime().path()/"constant/meltProperties");

    const meltScene scene(files.mesh());

    EXPECT_EQ(scene.points(0).size(), 1000);
    EXPECT_TRUE(scene.rheology().shearRateDependent());
    EXPECT_TRUE(scene.effects()("heatConduction"));
}


TEST(MeltScene, acceptsTheMaterialsThatAreReady)
{
    const fileName directory
    (
        getEnv("MELTFOAM_DIR")/"etc/caseDicts/meltFoam/materials"
    );
    sceneCase files;

    const fileNameList materials(readDir(directory, fileName::FILE));
    ASSERT_FALSE(materials.empty());

    for (const fileName& material : materials)
    {
        files.setMaterial
        (
            "material { #include \"" + directory/material + "\"\n }"
        );
        EXPECT_EQ(rejection(files), "accepted") << material;
    }
}


// ************************************************************************* //
