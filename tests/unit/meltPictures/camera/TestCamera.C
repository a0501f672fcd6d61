/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "camera.H"
#include "meltUnitTests.H"
#include "StringStream.H"

#include <random>

using namespace Foam;
using melt::camera;

namespace
{

dictionary dictionaryOf(const std::string& text)
{
    return dictionary(IStringStream(text)());
}

const vector yUp(0, 1, 0);
const vector zUp(0, 0, 1);
const boundBox box(point(-1, 0, -2), point(3, 5, 1));

void expectNear(const vector& a, const vector& b)
{
    EXPECT_NEAR(mag(a - b), 0, 1e-12) << a.x() << ' ' << a.y() << ' ' << a.z();
}

}

TEST(camera, bearingsOfTheTwoUsualUpwardDirections)
{
    expectNear(camera::bearing(yUp, 0, 0), vector(0, 0, 1));
    expectNear(camera::bearing(yUp, 90, 0), vector(1, 0, 0));
    expectNear(camera::bearing(zUp, 0, 0), vector(0, -1, 0));
    expectNear(camera::bearing(zUp, 90, 0), vector(1, 0, 0));
    expectNear(camera::bearing(zUp, 33, 90), zUp);
}

TEST(camera, axesAreOrthonormalAndRightHanded)
{
    const camera view(dictionary(), box, zUp, 0);
    expectNear(view.right() ^ view.top(), -view.direction());
    EXPECT_NEAR(mag(view.direction()), 1, 1e-12);
    EXPECT_NEAR(mag(view.right()), 1, 1e-12);
    EXPECT_NEAR(view.right() & zUp, 0, 1e-12);
    EXPECT_GT(view.top() & zUp, 0);
}

TEST(camera, frontViewPutsXToTheRightAndYUpwards)
{
    const camera view
    (
        dictionaryOf("azimuth 0; elevation 0;"), box, yUp, 0
    );
    expectNear(view.right(), vector(1, 0, 0));
    expectNear(view.top(), yUp);
    const vector middle = view.project(box.midpoint());
    EXPECT_NEAR(middle.x(), 0, 1e-12);
    EXPECT_NEAR(middle.y(), 0, 1e-12);
}

//- All corners are in the picture, and one touches each limiting edge
TEST(camera, anyBoxFromAnySideJustFits)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0, 1);
    const double margin = 0.1;
    const double legend = 0.25;
    for (int sample = 0; sample < 200; ++sample)
    {
        const point low(uniform(random), uniform(random), uniform(random));
        const vector span(uniform(random), uniform(random), uniform(random));
        dictionary dict = dictionaryOf("margin 0.1;");
        dict.set("azimuth", 360*uniform(random));
        dict.set("elevation", 160*uniform(random) - 80);
        dict.set("angle", 10 + 80*uniform(random));
        const camera view(dict, boundBox(low, low + span), yUp, legend);

        double left = 1, right = -1, bottom = 1, top = -1;
        const pointField corners(boundBox(low, low + span).points());
        for (const point& corner : corners)
        {
            const vector p = view.project(corner);
            EXPECT_GT(p.z(), 0);
            left = std::min(left, p.x());
            right = std::max(right, p.x());
            bottom = std::min(bottom, p.y());
            top = std::max(top, p.y());
        }
        const double tolerance = 1e-9;
        EXPECT_GE(left, -(1 - 2*margin) - tolerance);
        EXPECT_LE(right, 1 - 2*legend + tolerance);
        EXPECT_GE(bottom, -(1 - 2*margin) - tolerance);
        EXPECT_LE(top, 1 - 2*margin + tolerance);

        const bool fillsWidth =
            right - left > (1 - 2*margin) + (1 - 2*legend) - tolerance;
        const bool fillsHeight = top - bottom > 2*(1 - 2*margin) - tolerance;
        EXPECT_TRUE(fillsWidth || fillsHeight);
    }
}

TEST(camera, refusesBadEntries)
{
    for
    (
        const char* text :
        {
            "width 801;", "height 0;", "angle 0;", "angle nan;",
            "elevation 90;", "up (0 0 0);", "margin -1;"
        }
    )
    {
        EXPECT_THROW(camera(dictionaryOf(text), box, yUp, 0), Foam::IOerror)
            << text;
    }
}
