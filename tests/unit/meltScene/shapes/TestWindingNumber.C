/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "shapeTestTools.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

//- Of which no node is replaced by its moments
windingNumber exactly(std::vector<windingNumber::triangle> triangles)
{
    return windingNumber(std::move(triangles), 1e100);
}


windingNumber::vector eigen(const point& p)
{
    return {p.x(), p.y(), p.z()};
}


const boundBox twice(-2*point::one, 2*point::one);


void turn(windingNumber::triangle& t)
{
    std::swap(t.b, t.c);
}

} // End anonymous namespace


TEST(WindingNumber, ofClosedSurfaceIsOneInsideAndZeroOutside)
{
    const windingNumber w(exactly(trianglesOf(sphereSurface(3))));

    // The polyhedron of level 3 has an inscribed sphere of radius 0.98
    for (const point& p : randomPoints(2000, twice))
    {
        if (mag(p) < 0.98)
        {
            EXPECT_NEAR(w(eigen(p)), 1, 1e-12) << p.x();
        }
        else if (mag(p) > 1)
        {
            EXPECT_NEAR(w(eigen(p)), 0, 1e-12) << p.x();
        }
    }
}


TEST(WindingNumber, ofTreeIsNearToThatOfTheSum)
{
    const auto triangles = trianglesOf(sphereSurface(4));
    const windingNumber exact(exactly(triangles));
    const windingNumber tree(triangles);
    const windingNumber finer(triangles, 4);

    double error = 0;
    double finerError = 0;
    for (const point& p : randomPoints(2000, twice))
    {
        const auto x = eigen(p);
        error = std::max(error, std::abs(tree(x) - exact(x)));
        finerError = std::max(finerError, std::abs(finer(x) - exact(x)));
    }

    EXPECT_LT(error, 0.1);
    EXPECT_LT(finerError, error/4);
    EXPECT_GT(error, 0);
}


TEST(WindingNumber, ofHalfASphereIsHalfAtItsCentre)
{
    auto triangles = trianglesOf(sphereSurface(3));
    triangles.erase
    (
        std::remove_if
        (
            triangles.begin(),
            triangles.end(),
            [](const auto& t) { return t.a.z() + t.b.z() + t.c.z() < 0; }
        ),
        triangles.end()
    );

    EXPECT_NEAR(exactly(triangles)({0, 0, 0}), 0.5, 1e-12);
}


TEST(WindingNumber, isItsNegativeForTurnedTriangles)
{
    auto triangles = trianglesOf(sphereSurface(2));
    std::for_each(triangles.begin(), triangles.end(), turn);

    EXPECT_NEAR(exactly(triangles)({0.1, 0.2, 0.3}), -1, 1e-12);
    EXPECT_LT(windingNumber(triangles).volume(), 0);
}


TEST(WindingNumber, fallsByTwiceTheShareOfTurnedTriangles)
{
    // At the centre each triangle counts by its solid angle; evenly spread,
    // a tenth of them turned leaves 1 - 2/10
    auto triangles = trianglesOf(sphereSurface(4));
    std::mt19937 engine(1);
    std::shuffle(triangles.begin(), triangles.end(), engine);
    std::for_each
    (
        triangles.begin(),
        triangles.begin() + triangles.size()/10,
        turn
    );

    EXPECT_NEAR(exactly(triangles)({0, 0, 0}), 0.8, 0.01);
}


TEST(WindingNumber, leavesOutTrianglesWithoutArea)
{
    auto triangles = trianglesOf(sphereSurface(2));
    const double before = windingNumber(triangles)({0.1, 0.2, 0.3});
    const windingNumber::vector a(1, 0, 0), b(0, 1, 0);
    triangles.insert(triangles.begin(), {a, a, b});
    triangles.insert(triangles.begin(), {a, 0.5*(a + b), b});

    const windingNumber w(triangles);
    EXPECT_EQ(w.nDegenerate(), 2);
    EXPECT_NEAR(w({0.1, 0.2, 0.3}), before, 1e-12);
}


TEST(WindingNumber, ofNothingIsZero)
{
    const windingNumber w({});
    EXPECT_EQ(w({0, 0, 0}), 0);
    EXPECT_EQ(w.volume(), 0);
}


TEST(WindingNumber, volumeOfOctahedronIsThatOfTheClosedForm)
{
    auto triangles = trianglesOf(sphereSurface(0));
    EXPECT_NEAR(windingNumber(triangles).volume(), 4.0/3, 1e-14);

    // Far from the origin as well
    const windingNumber::vector shift(1e6, -1e6, 1e6);
    for (auto& t : triangles)
    {
        t = {t.a + shift, t.b + shift, t.c + shift};
    }
    EXPECT_NEAR(windingNumber(triangles).volume(), 4.0/3, 1e-9);
}


// ************************************************************************* //
