/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "shapeTestTools.H"
#include "shapeTransformation.H"

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

shapeTransformation transformationOf(const std::string& text)
{
    return shapeTransformation(dictOf(text));
}


void expectNear(const vector& a, const vector& b)
{
    EXPECT_NEAR(mag(a - b), 0, 1e-12)
        << "(" << a.x() << " " << a.y() << " " << a.z() << ")";
}


std::string messageFor(const std::string& text)
{
    return messageOf([&] { transformationOf(text); });
}

} // End anonymous namespace


TEST(ShapeTransformation, withoutEntriesChangesNothing)
{
    const auto t = transformationOf("");
    expectNear(t.position(point(1, 2, 3)), point(1, 2, 3));
    EXPECT_DOUBLE_EQ(t.volumeRatio(), 1);
}


TEST(ShapeTransformation, scalesThenRotatesThenTranslates)
{
    const auto t = transformationOf
    (
        "scale (2 3 4); translate (10 20 30);"
        "rotate { type axisAngle; axis (0 0 1); angle 90; }"
    );

    // (1 1 1) -> (2 3 4) -> (-3 2 4) -> (7 22 34)
    expectNear(t.position(point(1, 1, 1)), point(7, 22, 34));
    EXPECT_NEAR(t.volumeRatio(), 24, 1e-12);
}


TEST(ShapeTransformation, scalesByOneNumber)
{
    expectNear
    (
        transformationOf("scale 0.5;").position(point(2, 4, 6)),
        point(1, 2, 3)
    );
}


TEST(ShapeTransformation, turnsTheFirstVectorIntoTheSecond)
{
    const auto t = transformationOf("rotate ((0 0 2) (0 3 0));");
    expectNear(t.position(point(0, 0, 1)), point(0, 1, 0));
    expectNear(t.position(point(1, 0, 0)), point(1, 0, 0));
}


TEST(ShapeTransformation, turnsOppositeVectorsWithoutMirroring)
{
    for (const char* axis : {"(1 0 0) (-1 0 0)", "(0 1 0) (0 -1 0)",
        "(0 0 1) (0 0 -1)", "(1 2 3) (-1 -2 -3)"})
    {
        const auto t =
            transformationOf("rotate (" + std::string(axis) + ");");
        const vector x(t.position(point(1, 0, 0)));
        const vector y(t.position(point(0, 1, 0)));
        const vector z(t.position(point(0, 0, 1)));
        EXPECT_NEAR((x ^ y) & z, 1, 1e-12) << axis;
    }
    expectNear
    (
        transformationOf("rotate ((1 2 3) (-1 -2 -3));")
       .position(point(1, 2, 3)),
        point(-1, -2, -3)
    );
}


TEST(ShapeTransformation, inverseUndoesPosition)
{
    const auto t = transformationOf
    (
        "scale (2 -3 4); rotate ((1 2 3) (3 -1 2)); translate (1 0 -5);"
    );
    for (const point& p : randomPoints(100, boundBox(-point::one, point::one)))
    {
        expectNear(t.inverse(t.position(p)), p);
    }
}


TEST(ShapeTransformation, refusesWhatItCannotDo)
{
    EXPECT_NE(messageFor("scale 0;").find("scale"), std::string::npos);
    EXPECT_NE(messageFor("scale (1 0 1);").find("scale"), std::string::npos);
    EXPECT_NE(messageFor("scale nan;"), "");
    EXPECT_NE(messageFor("scale (1 2 nan);"), "");
    EXPECT_NE(messageFor("scale 1 2;").find("scale"), std::string::npos);
    EXPECT_NE
    (
        messageFor("rotate ((0 0 0) (0 1 0));").find("rotate"),
        std::string::npos
    );
    EXPECT_NE(messageFor("rotate { type wrong; }"), "");
    EXPECT_NE(messageFor("translate 3;"), "");
}


// ************************************************************************* //
