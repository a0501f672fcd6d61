/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "OSspecific.H"
#include "shapeTestTools.H"
#include "triSurfaceSearch.H"

#include <omp.h>

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

const boundBox twice(-2*point::one, 2*point::one);

//- The enclosed volume of sphereSurface(3)
scalar volumeOfSphere3()
{
    return windingNumber(trianglesOf(sphereSurface(3))).volume();
}


//- Every how many-th triangle is left out or turned
triSurface damaged(const label hole, const label turned)
{
    const triSurface surface(sphereSurface(3));
    DynamicList<labelledTri> triangles;
    forAll(surface, i)
    {
        labelledTri t(surface[i]);
        if (turned && i % turned == 0)
        {
            Swap(t[0], t[1]);
        }
        if (!hole || i % hole)
        {
            triangles.append(t);
        }
    }
    return triSurface(triangles, surface.points());
}


//- Share of points, farther than 0.1 from the sphere, on the wrong side
scalar wrongShare(const shape& body)
{
    const pointField points(randomPoints(20000, twice));
    const boolList inside(body.inside(points));
    label nWrong = 0;
    label n = 0;
    forAll(points, i)
    {
        if (mag(mag(points[i]) - 1) > 0.1)
        {
            ++n;
            nWrong += inside[i] != (mag(points[i]) < 1);
        }
    }
    return scalar(nWrong)/n;
}


void expectMessage(const std::string& text, const std::string& part)
{
    const std::string message
    (
        messageOf([&] { shapeOf("type triSurface;" + text); })
    );
    EXPECT_NE(message.find(part), std::string::npos)
        << text << " gives: " << message;
}

} // End anonymous namespace


TEST(TriSurfaceShape, readsTheFormatsOfOpenFOAM)
{
    for (const char* name : {"sphere.stl", "sphere.obj", "sphere.off"})
    {
        writeGeometry(sphereSurface(3), name);
        const auto body =
            shapeOf("type triSurface; file \"" + std::string(name) + "\";");

        // STL is single precision, text has six digits
        EXPECT_NEAR(body->volume(), volumeOfSphere3(), 1e-5) << name;
        EXPECT_NEAR(mag(body->bounds().span() - 2*vector::one), 0, 1e-5);
        EXPECT_EQ(wrongShare(*body), 0) << name;
    }
}


TEST(TriSurfaceShape, agreesWithOpenFOAMOnClosedSurfaces)
{
    writeGeometry(sphereSurface(3), "sphere.off");
    const triSurface surface(geometryDirectory()/"sphere.off");
    const pointField points(randomPoints(20000, twice));

    const boolList inside
    (
        shapeOf("type triSurface; file \"sphere.off\";")->inside(points)
    );
    EXPECT_EQ(inside, boolList(triSurfaceSearch(surface).calcInside(points)));
}


TEST(TriSurfaceShape, givesTheSameWithAnyNumberOfThreads)
{
    writeGeometry(damaged(20, 10), "damaged.obj");
    const pointField points(randomPoints(20000, twice));
    const int nThreads = omp_get_max_threads();

    List<boolList> inside(2);
    scalarField volume(2);
    forAll(inside, i)
    {
        omp_set_num_threads(i + 1);
        const auto body = shapeOf("type triSurface; file \"damaged.obj\";");
        inside[i] = body->inside(points);
        volume[i] = body->volume();
    }
    omp_set_num_threads(nThreads);

    EXPECT_EQ(inside[0], inside[1]);
    EXPECT_EQ(volume[0], volume[1]);
}


TEST(TriSurfaceShape, fillsDamagedSurfaces)
{
    writeGeometry(damaged(20, 0), "holes.off");
    writeGeometry(damaged(0, 10), "turned.off");

    for (const char* name : {"holes.off", "turned.off"})
    {
        const auto body =
            shapeOf("type triSurface; file \"" + std::string(name) + "\";");
        EXPECT_LT(wrongShare(*body), 0.01) << name;
        EXPECT_NEAR(body->volume()/volumeOfSphere3(), 1, 0.05) << name;
    }
}


TEST(TriSurfaceShape, turnsASurfaceThatPointsInwards)
{
    writeGeometry(damaged(0, 1), "inwards.off");
    const auto body = shapeOf("type triSurface; file \"inwards.off\";");
    EXPECT_NEAR(body->volume(), volumeOfSphere3(), 1e-5);
    EXPECT_EQ(wrongShare(*body), 0);
}


TEST(TriSurfaceShape, isTransformedAsAnyShape)
{
    writeGeometry(sphereSurface(3), "sphere.off");
    const auto body = shapeOf
    (
        "type triSurface; file \"sphere.off\"; scale (1 2 3);"
        "rotate ((1 0 0) (0 1 0)); translate (10 0 0);"
    );

    EXPECT_NEAR(body->volume(), 6*volumeOfSphere3(), 1e-4);
    EXPECT_NEAR(mag(body->bounds().min() - point(8, -1, -3)), 0, 1e-5);
    EXPECT_NEAR(mag(body->bounds().max() - point(12, 1, 3)), 0, 1e-5);
}


TEST(TriSurfaceShape, makesAMissingFile)
{
    writeGeometry(sphereSurface(1), "source.off");
    const fileName copy(geometryDirectory()/"copy.off");
    rm(copy);

    shapeOf
    (
        "type triSurface; file \"copy.off\";"
        "make \"cp constant/geometry/source.off constant/geometry/copy.off\";"
    );
    EXPECT_TRUE(isFile(copy));
}


TEST(TriSurfaceShape, refusesBadInputAndNamesTheEntry)
{
    const std::string empty("file \"empty.off\";");
    writeGeometry("OFF\n0 0 0\n", "empty.off");
    writeGeometry("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "flat.off");
    writeGeometry("text\n", "sphere.txt");
    writeGeometry(sphereSurface(3), "sphere.off");

    expectMessage("", "file");
    expectMessage("file \"missing.stl\";", "constant/triSurface/missing.stl");
    expectMessage("file \"sphere.txt\";", "stl");
    expectMessage(empty, "no triangles");
    expectMessage("file \"flat.off\";", "no volume");
    expectMessage("file \"missing.stl\"; make \"false\";", "false");
    expectMessage("file \"missing.stl\"; make \"true\";", "make");
    expectMessage("file \"sphere.off\"; scale 0;", "scale");
}


// ************************************************************************* //
