/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mathematicalConstants.H"
#include "meltUnitTests.H"
#include "shapeTestTools.H"

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

const scalar pi = constant::mathematical::pi;

const std::string box("type box; min (-1 0 2); max (1 3 6);");

const std::string sphere("type sphere; centre (1 2 3); radius 2;");

const std::string cylinder
(
    "type cylinder; point1 (0 0 0); point2 (0 4 0); radius 1.5;"
);

const std::string turned
(
    "scale (1 2 0.5); rotate ((1 2 3) (3 -1 2)); translate (1 0 -5);"
);


//- Share of the bounds that is inside, times their volume
scalar sampledVolume(const shape& body)
{
    const label n = 200000;
    const boundBox bounds(body.bounds());
    label nInside = 0;
    for (const bool in : body.inside(randomPoints(n, bounds)))
    {
        nInside += in;
    }
    return bounds.volume()*nInside/n;
}


void expectBounds(const shape& body, const point& min, const point& max)
{
    EXPECT_NEAR(mag(body.bounds().min() - min), 0, 1e-12);
    EXPECT_NEAR(mag(body.bounds().max() - max), 0, 1e-12);
}


void expectMessage(const std::string& text, const std::string& entry)
{
    const std::string message(messageOf([&] { shapeOf(text); }));
    EXPECT_NE(message.find(entry), std::string::npos)
        << text << " gives: " << message;
}

} // End anonymous namespace


TEST(Shape, hasTheVolumeOfTheClosedForm)
{
    EXPECT_NEAR(shapeOf(box)->volume(), 24, 1e-12);
    EXPECT_NEAR(shapeOf(sphere)->volume(), 32*pi/3, 1e-12);
    EXPECT_NEAR(shapeOf(cylinder)->volume(), 9*pi, 1e-12);
    EXPECT_NEAR(shapeOf(box + "scale (2 3 -4);")->volume(), 24*24, 1e-10);
}


TEST(Shape, containsAsMuchAsItsVolume)
{
    for (const std::string& text : {box, sphere, cylinder})
    {
        // Half a per cent is three standard deviations of the sampling
        for (const std::string& end : {std::string(), turned})
        {
            const auto body = shapeOf(text + end);
            EXPECT_NEAR(sampledVolume(*body)/body->volume(), 1, 0.01)
                << text << end;
        }
    }
}


TEST(Shape, hasExactBounds)
{
    expectBounds(*shapeOf(box), point(-1, 0, 2), point(1, 3, 6));
    expectBounds(*shapeOf(sphere), point(-1, 0, 1), point(3, 4, 5));
    expectBounds(*shapeOf(cylinder), point(-1.5, 0, -1.5), point(1.5, 4, 1.5));

    // An ellipsoid stays one when it is turned by a right angle
    expectBounds
    (
        *shapeOf
        (
            "type sphere; centre (0 0 0); radius 1; scale (1 2 3);"
            "rotate ((1 0 0) (0 1 0)); translate (10 0 0);"
        ),
        point(8, -1, -3),
        point(12, 1, 3)
    );
}


TEST(Shape, boundsHoldEveryPointInside)
{
    for (const std::string& text : {box, sphere, cylinder})
    {
        const auto body = shapeOf(text + turned);
        const boundBox bounds(body->bounds());
        boundBox larger(bounds);
        larger.inflate(1);

        boundBox found;
        const pointField points(randomPoints(100000, larger));
        const boolList inside(body->inside(points));
        forAll(points, i)
        {
            if (inside[i])
            {
                EXPECT_TRUE(bounds.contains(points[i]));
                found.add(points[i]);
            }
        }

        // And they are not larger than need be
        EXPECT_GT(cmptMin(cmptDivide(found.span(), bounds.span())), 0.75);
    }
}


TEST(Shape, extentIsAlongADirection)
{
    const scalarMinMax extent(shapeOf(box)->extent(vector(0, 0.6, 0.8)));
    EXPECT_NEAR(extent.min(), 1.6, 1e-12);
    EXPECT_NEAR(extent.max(), 6.6, 1e-12);
}


TEST(Shape, refusesBadInputAndNamesTheEntry)
{
    expectMessage("type cone;", "cylinder");
    expectMessage("radius 1;", "type");
    expectMessage("type box; min (0 0 0); max (1 0 1);", "max");
    expectMessage("type box; min (0 0 0);", "max");
    expectMessage("type box; min (0 0 nan); max (1 1 1);", "min");
    expectMessage("type sphere; centre (0 0 0); radius 0;", "radius");
    expectMessage("type sphere; centre (0 0 0); radius -1;", "radius");
    expectMessage("type sphere; centre (0 0 0); radius nan;", "radius");
    expectMessage
    (
        "type cylinder; point1 (0 0 0); point2 (0 0 0); radius 1;",
        "point2"
    );
}


TEST(Shape, motionAtTheStart)
{
    const autoPtr<shape> body
    (
        shapeOf(box + "translate (1 0 0); U (1 2 3); omega (0 0 4);")
    );

    // Centre of the bounds: (1 1.5 4)
    const vectorField U
    (
        body->velocity(pointField({point(1, 1.5, 4), point(2, 1.5, 0)}))
    );
    EXPECT_EQ(U[0], vector(1, 2, 3));
    EXPECT_EQ(U[1], vector(1, 6, 3));

    EXPECT_EQ(shapeOf(box)->velocity(pointField(1, point::zero))[0], vector::zero);
    expectMessage(box + "U (0 nan 0);", "U");
}


// Walls around the bounds are not crossed, and volume is kept
TEST(Shape, vortexAtTheStart)
{
    const autoPtr<shape> body
    (
        shapeOf("type box; min (0 0 0); max (2 1 1); vortex 3;")
    );
    const scalar d = 1e-4;
    const vectorField U
    (
        body->velocity
        (
            pointField
            ({
                point(1, 0, 0), point(0, 0.3, 0), point(2, 0.3, 0.5),
                point(0.7, 1, 0),
                point(0.7 + d, 0.3, 0), point(0.7 - d, 0.3, 0),
                point(0.7, 0.3 + d, 0), point(0.7, 0.3 - d, 0)
            })
        )
    );
    EXPECT_NEAR(mag(U[0] - vector(3, 0, 0)), 0, 1e-14);
    EXPECT_NEAR(U[1].x(), 0, 1e-14);
    EXPECT_NEAR(U[2].x(), 0, 1e-14);
    EXPECT_NEAR(U[3].y(), 0, 1e-14);
    EXPECT_NEAR
    (
        (U[4].x() - U[5].x() + U[6].y() - U[7].y())/(2*d), 0, 1e-6
    );
    expectMessage(box + "vortex nan;", "vortex");
}

// ************************************************************************* //
