/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "shapeFill.H"
#include "shapeTestTools.H"

#include <omp.h>

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

const vector down(0, -9.81, 0);

const std::string cube("type box; min (0 0 0); max (1 1 1);");

const std::string sphere("type sphere; centre (0 0 0); radius 1;");


pointField exactly(const shape& body, const label n, scalar& spacing)
{
    const dictionary dict(dictOf("nParticles " + std::to_string(n) + ";"));
    return shapeFill::fillExactly(body, dict, down, spacing);
}


//- Number of points that have none near to their image in the plane
label nWithoutImage(const pointField& points, const direction d)
{
    label n = 0;
    for (const point& p : points)
    {
        point image(p);
        image[d] *= -1;
        bool found = false;
        for (const point& q : points)
        {
            found = found || mag(q - image) < 1e-9;
        }
        n += !found;
    }
    return n;
}


std::string messageFor(const std::string& entries)
{
    return messageOf
    (
        [&]
        {
            scalar spacing;
            shapeFill::fillExactly
            (
                *shapeOf(cube),
                dictOf(entries),
                down,
                spacing
            );
        }
    );
}

} // End anonymous namespace


TEST(ShapeFill, fillsABoxWithWholeCells)
{
    const pointField points
    (
        shapeFill::fill
        (
            *shapeOf("type box; min (0 0 0); max (0.4 0.6 1);"),
            0.1,
            down
        )
    );
    EXPECT_EQ(points.size(), 4*6*10);
    const boundBox box(points, false);
    EXPECT_NEAR(mag(box.min() - point(0.05, 0.05, 0.05)), 0, 1e-12);
    EXPECT_NEAR(mag(box.max() - point(0.35, 0.55, 0.95)), 0, 1e-12);
}


TEST(ShapeFill, standsHalfASpacingAboveTheFloorWhereverGravityPoints)
{
    const auto body = shapeOf(cube);
    for (direction d = 0; d < 3; ++d)
    {
        for (const scalar sign : {-1, 1})
        {
            vector g(0.1, 0.1, 0.1);
            g[d] = sign*9.81;
            const boundBox box(shapeFill::fill(*body, 0.07, g), false);
            const scalar distance = sign < 0 ? box.min()[d] : 1 - box.max()[d];
            EXPECT_NEAR(distance, 0.035, 1e-12);
        }
    }
}


TEST(ShapeFill, isAsSymmetricAsTheShape)
{
    for (const scalar spacing : {0.15, 0.17, 0.2, 0.23})
    {
        const pointField points
        (
            shapeFill::fill(*shapeOf(sphere), spacing, down)
        );
        EXPECT_EQ(nWithoutImage(points, 0), 0);
        EXPECT_EQ(nWithoutImage(points, 2), 0);
    }

    // Without gravity in all directions
    const pointField points
    (
        shapeFill::fill(*shapeOf(sphere), 0.17, vector::zero)
    );
    EXPECT_EQ(nWithoutImage(points, 1), 0);
}


TEST(ShapeFill, numberTendsToVolumeOverCell)
{
    const auto body = shapeOf(sphere);
    const scalar spacing = 0.04;
    const label n = shapeFill::fill(*body, spacing, down).size();
    EXPECT_NEAR(n*pow3(spacing)/body->volume(), 1, 0.005);
}


TEST(ShapeFill, ofTooWideSpacingIsEmptyAndOfNoneAnError)
{
    EXPECT_EQ(shapeFill::fill(*shapeOf(cube), 10, down).size(), 0);
    EXPECT_THROW(shapeFill::fill(*shapeOf(cube), 0, down), Foam::error);
    EXPECT_THROW(shapeFill::fill(*shapeOf(cube), -1, down), Foam::error);
    EXPECT_THROW
    (
        shapeFill::fill(*shapeOf(cube), std::nan(""), down),
        Foam::error
    );
}


TEST(ShapeFill, reachesNumbersExactly)
{
    const auto body = shapeOf(sphere);
    for (const label n : {1, 100, 1000, 1001, 1009, 5000})
    {
        scalar spacing = -1;
        const pointField points(exactly(*body, n, spacing));
        ASSERT_EQ(points.size(), n);

        // A piece of melt fills about its cell of the lattice
        if (n > 1)
        {
            EXPECT_NEAR(n*pow3(spacing)/body->volume(), 1, 0.1) << n;
        }
        for (const bool in : body->inside(points))
        {
            EXPECT_TRUE(in);
        }
    }
}


TEST(ShapeFill, dropsThePointsWhoseCellsAreFilledLeast)
{
    // 999 of 1000: the one that misses is at a corner of the cube
    scalar spacing = -1;
    const pointField points(exactly(*shapeOf(cube), 999, spacing));
    const pointField full(shapeFill::fill(*shapeOf(cube), spacing, down));
    ASSERT_EQ(points.size(), 999);
    ASSERT_EQ(full.size(), 1000);

    const point missing(sum(full) - sum(points));
    const boundBox lattice(full, false);
    for (direction d = 0; d < 3; ++d)
    {
        EXPECT_NEAR
        (
            mag(missing[d] - lattice.midpoint()[d]),
            0.5*lattice.span()[d],
            1e-9
        );
    }
}


TEST(ShapeFill, dropsEvenlyOfThoseFilledAlike)
{
    // 238 of 15 x 4 x 4: the two that miss are not neighbours
    const auto body = shapeOf("type box; min (0 0 0); max (4 1 1);");
    scalar spacing = -1;
    const pointField points(exactly(*body, 238, spacing));

    pointField missing;
    for (const point& p : shapeFill::fill(*body, spacing, down))
    {
        if (!points.found(p))
        {
            missing.append(p);
        }
    }
    ASSERT_EQ(missing.size(), 2);
    EXPECT_GT(mag(missing[0] - missing[1]), 1.8*spacing);
}


TEST(ShapeFill, givesTheSamePointsWithAnyNumberOfThreads)
{
    writeGeometry(sphereSurface(3), "sphere.off");
    const auto body = shapeOf("type triSurface; file \"sphere.off\";");
    const int nThreads = omp_get_max_threads();

    List<pointField> points(2);
    scalarField spacing(2);
    forAll(points, i)
    {
        omp_set_num_threads(i + 1);
        points[i] = exactly(*body, 1003, spacing[i]);
    }
    omp_set_num_threads(nThreads);

    EXPECT_EQ(points[0], points[1]);
    EXPECT_EQ(spacing[0], spacing[1]);
}


TEST(ShapeFill, refusesNumbersThatItCannotReach)
{
    // Between 9^3 and 10^3
    const std::string message(messageFor("nParticles 850;"));
    EXPECT_NE(message.find("nParticles"), std::string::npos);
    EXPECT_NE(message.find("729"), std::string::npos) << message;
    EXPECT_NE(message.find("1000"), std::string::npos) << message;
    EXPECT_EQ(messageFor("nParticles 850; maxSurplus 0.2;"), "");

    for (const char* n : {"0", "-5", "nan", "2.5"})
    {
        const std::string text("nParticles " + std::string(n) + ";");
        EXPECT_NE(messageFor(text).find("nParticles"), std::string::npos) << n;
    }
    EXPECT_NE
    (
        messageFor("nParticles 10; maxSurplus -1;").find("maxSurplus"),
        std::string::npos
    );
}


TEST(ShapeFill, overlapIsThatOfVolumes)
{
    const auto body = shapeOf(cube);
    const auto overlapsWith = [&](const std::string& text)
    {
        const auto other = shapeOf(text);
        const bool result = shapeFill::overlap(*body, *other, 0.1);
        EXPECT_EQ(result, shapeFill::overlap(*other, *body, 0.1));
        return result;
    };

    EXPECT_TRUE(overlapsWith(cube));
    EXPECT_TRUE(overlapsWith("type box; min (0.9 0.9 0.9); max (2 2 2);"));
    EXPECT_TRUE(overlapsWith("type box; min (0.99 0 0); max (2 1 1);"));
    EXPECT_TRUE(overlapsWith("type sphere; centre (0.5 0.5 0.5); radius 0.1;"));
    EXPECT_FALSE(overlapsWith("type box; min (1 0 0); max (2 1 1);"));
    EXPECT_FALSE(overlapsWith("type box; min (1.5 0 0); max (2 1 1);"));

    // The bounds overlap, the shapes do not
    EXPECT_FALSE(overlapsWith("type sphere; centre (1.5 1.5 1.5); radius 0.8;"));
}


TEST(ShapeFill, outsideFindsThePointsThatAreNotInTheBox)
{
    const pointField points({point(0.5, 0.5, 0.5), point(2, 0, 0), point::one});
    EXPECT_EQ
    (
        shapeFill::outside(points, boundBox(point::zero, point::one)),
        labelList({1})
    );
}


// ************************************************************************* //
