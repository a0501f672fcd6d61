/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallConditions.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"
#include "OSspecific.H"

using namespace Foam;
using namespace Foam::melt;
using unitTest::sceneCase;

namespace
{

using velocityType = wallCondition::velocityType;
using thermalType = wallCondition::thermalType;

const wordList types({"wall", "wall", "patch", "symmetryPlane", "wall", "wall"});


std::string rejection(sceneCase& files)
{
    try
    {
        wallConditions walls(files.mesh());
    }
    catch (const error& err)
    {
        return err.message();
    }

    return "accepted";
}

} // End anonymous namespace


TEST(WallConditions, areThoseOfTheFiles)
{
    sceneCase files(types);
    files.setBoundary
    (
        "U",
        "xMin { type noSlip; }"
        "xMax { type slip; }"
        "zMin { type fixedValue; value uniform (1 2 0); }"
        "zMax { type movingWallVelocity;"
        "    value nonuniform List<vector> 4((1 0 0) (2 0 0) (3 0 0) (4 0 0)); }"
    );
    files.setBoundary
    (
        "T",
        "xMin { type zeroGradient; }"
        "xMax { type fixedValue; value uniform 350; }"
        "zMin { type externalWallHeatFluxTemperature; mode coefficient;"
        "    h uniform 25; Ta constant 280; }"
        "zMax { type zeroGradient; }"
    );
    const wallConditions walls(files.mesh());

    ASSERT_EQ(walls.conditions().size(), 6);

    EXPECT_EQ(walls[0].name, "xMin");
    EXPECT_EQ(walls[0].velocity, velocityType::noSlip);
    EXPECT_EQ(walls[0].thermal, thermalType::adiabatic);
    EXPECT_EQ(walls[0].U, vectorField(4, Zero));
    EXPECT_TRUE(walls[0].T.empty());

    EXPECT_EQ(walls[1].velocity, velocityType::slip);
    EXPECT_EQ(walls[1].thermal, thermalType::fixedTemperature);
    EXPECT_EQ(walls[1].T, scalarField(4, 350.));
    EXPECT_TRUE(walls[1].h.empty());

    // Open, although the files say nothing of it
    EXPECT_FALSE(walls[2].isWall());

    EXPECT_TRUE(walls[3].isWall());
    EXPECT_EQ(walls[3].velocity, velocityType::slip);
    EXPECT_EQ(walls[3].thermal, thermalType::adiabatic);

    EXPECT_EQ(walls[4].U, vectorField(4, vector(1, 2, 0)));
    EXPECT_EQ(walls[4].thermal, thermalType::convective);
    EXPECT_EQ(walls[4].h, scalarField(4, 25.));
    EXPECT_EQ(walls[4].T, scalarField(4, 280.));

    EXPECT_EQ(walls[5].U[2], vector(3, 0, 0));

    EXPECT_EQ(walls.TRange().min(), 280);
    EXPECT_EQ(walls.TRange().max(), 350);
}


TEST(WallConditions, adiabaticWallsHaveNoTemperature)
{
    sceneCase files;
    EXPECT_FALSE(wallConditions(files.mesh()).TRange().valid());
}


TEST(WallConditions, nameIsStrongerThanPattern)
{
    sceneCase files;
    files.setBoundary
    (
        "U",
        "xMin { type noSlip; }"
        "\"x.*\" { type slip; }"
        "\"[yz].*\" { type noSlip; }"
    );
    const wallConditions walls(files.mesh());

    EXPECT_EQ(walls[0].velocity, velocityType::noSlip);
    EXPECT_EQ(walls[1].velocity, velocityType::slip);
    EXPECT_EQ(walls[2].velocity, velocityType::noSlip);
}


TEST(WallConditions, missingFileIsNamed)
{
    for (const char* field : {"U", "T"})
    {
        sceneCase files;
        rm(unitTest::runTime().path()/"0"/field);

        const std::string message(rejection(files));
        EXPECT_NE
        (
            message.find(std::string("0/") + field), std::string::npos
        ) << message;
    }
}


TEST(WallConditions, missingPatchIsNamed)
{
    sceneCase files;
    files.setBoundary("U", "\"[xy].*\" { type noSlip; }");

    EXPECT_NE(rejection(files).find("zMin"), std::string::npos);
}


TEST(WallConditions, badInputIsRejected)
{
    for
    (
        const char* text
      : {
            "{ type inletOutlet; }",
            "{}",
            "{ type fixedValue; }",
            "{ type fixedValue; value uniform (nan 0 0); }",
            "{ type fixedValue; value uniform 3; }"
        }
    )
    {
        sceneCase files;
        files.setBoundary("U", std::string("\".*\" ") + text);
        EXPECT_NE(rejection(files), "accepted") << text;
    }

    for
    (
        const char* text
      : {
            "{ type calculated; }",
            "{ type fixedValue; }",
            "{ type fixedValue; value uniform -3; }",
            "{ type fixedValue; value uniform nan; }",
            "{ type externalWallHeatFluxTemperature; mode power; Q 3; }",
            "{ type externalWallHeatFluxTemperature; mode coefficient;"
            "  h uniform -1; Ta 300; }",
            "{ type externalWallHeatFluxTemperature; mode coefficient;"
            "  h uniform 1; Ta -1; }",
            "{ type externalWallHeatFluxTemperature; mode coefficient;"
            "  h uniform 1; }"
        }
    )
    {
        sceneCase files;
        files.setBoundary("T", std::string("\".*\" ") + text);
        EXPECT_NE(rejection(files), "accepted") << text;
    }
}


// ************************************************************************* //
