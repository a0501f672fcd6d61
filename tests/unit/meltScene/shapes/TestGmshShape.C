/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mathematicalConstants.H"
#include "meltUnitTests.H"
#include "OSspecific.H"
#include "shapeTestTools.H"
#include "triSurfaceSearch.H"

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

//- A unit cube with a hole of radius r drilled through
const std::string drilledCube
(
    "SetFactory(\"OpenCASCADE\");\n"
    "DefineConstant[ r = 0.3 ];\n"
    "Box(1) = {0, 0, 0, 1, 1, 1};\n"
    "Cylinder(2) = {0.5, 0.5, -1, 0, 0, 3, r};\n"
    "BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n"
    "Mesh.CharacteristicLengthMax = 0.05;\n"
);


//- A fresh directory with the script
void writeScript(const std::string& text = drilledCube)
{
    rmDir(geometryDirectory(), true);
    writeGeometry(text, "cube.geo");
}


//- Paths of the surfaces made
fileNameList surfaces()
{
    fileNameList found;
    for (const fileName& name : readDir(geometryDirectory(), fileName::FILE))
    {
        if (name.hasExt("stl"))
        {
            found.append(geometryDirectory()/name);
        }
    }
    return found;
}


scalar drilledVolume(const scalar radius)
{
    return 1 - constant::mathematical::pi*sqr(radius);
}

} // End anonymous namespace


TEST(GmshShape, meshesTheScript)
{
    writeScript();
    const auto body = shapeOf("type gmsh; file \"cube.geo\";");
    EXPECT_NEAR(body->volume(), drilledVolume(0.3), 3e-3);
    EXPECT_NEAR(mag(body->bounds().max() - point::one), 0, 1e-6);

    const boolList inside
    (
        body->inside(pointField({point(0.5, 0.5, 0.5), point(0.1, 0.1, 0.1)}))
    );
    EXPECT_FALSE(inside[0]);
    EXPECT_TRUE(inside[1]);
}


TEST(GmshShape, agreesWithOpenFOAM)
{
    writeScript();
    const auto body = shapeOf("type gmsh; file \"cube.geo\";");
    const pointField points
    (
        randomPoints(20000, boundBox(-point::one, 2*point::one))
    );
    ASSERT_EQ(surfaces().size(), 1);
    const triSurface surface(surfaces()[0]);

    EXPECT_EQ
    (
        body->inside(points),
        boolList(triSurfaceSearch(surface).calcInside(points))
    );
}


TEST(GmshShape, meshesAgainOnlyWhenSomethingChanged)
{
    writeScript();
    shapeOf("type gmsh; file \"cube.geo\";");
    ASSERT_EQ(surfaces().size(), 1);
    const fileName first(surfaces()[0]);

    // A mark that only a new mesh would wipe out: the time stamp
    const auto time = highResLastModified(first);
    shapeOf("type gmsh; file \"cube.geo\"; scale 2;");
    EXPECT_EQ(highResLastModified(first), time);
    EXPECT_EQ(surfaces().size(), 1);

    const auto wider =
        shapeOf("type gmsh; file \"cube.geo\"; parameters { r 0.4; }");
    EXPECT_EQ(surfaces().size(), 2);
    EXPECT_NEAR(wider->volume(), drilledVolume(0.4), 3e-3);

    writeGeometry(drilledCube + "// changed\n", "cube.geo");
    shapeOf("type gmsh; file \"cube.geo\";");
    EXPECT_EQ(surfaces().size(), 3);
}


TEST(GmshShape, tellsTheCommandThatFailed)
{
    writeScript("this is not a script\n");
    const std::string message
    (
        messageOf([] { shapeOf("type gmsh; file \"cube.geo\";"); })
    );
    EXPECT_NE(message.find("gmsh"), std::string::npos);
    EXPECT_NE(message.find("cube.geo"), std::string::npos);
    EXPECT_EQ(surfaces().size(), 0) << "a half-made surface is left";
}


TEST(GmshShape, refusesParametersThatAreNoNumbers)
{
    writeScript();
    const std::string message
    (
        messageOf
        (
            []
            {
                shapeOf
                (
                    "type gmsh; file \"cube.geo\"; parameters { r wide; }"
                );
            }
        )
    );
    EXPECT_NE(message, "");
}


// ************************************************************************* //
