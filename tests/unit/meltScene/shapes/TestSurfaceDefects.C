/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "shapeTestTools.H"
#include "surfaceDefects.H"

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

//- The surface without the triangles of these labels
triSurface without(const triSurface& surface, const labelHashSet& labels)
{
    DynamicList<labelledTri> triangles;
    forAll(surface, i)
    {
        if (!labels.found(i))
        {
            triangles.append(surface[i]);
        }
    }
    return triSurface(triangles, surface.points());
}

} // End anonymous namespace


TEST(SurfaceDefects, closedSurfaceHasNone)
{
    const surfaceDefects defects(sphereSurface(2));
    EXPECT_TRUE(defects.closed());
    EXPECT_EQ(defects.nOpenEdges(), 0);
    EXPECT_EQ(defects.nHoles(), 0);
    EXPECT_EQ(defects.nTurnedEdges(), 0);
}


TEST(SurfaceDefects, countsHolesAndTheirEdges)
{
    // Triangles 0 and 100 of level 2 have no point in common
    const surfaceDefects defects(without(sphereSurface(2), {0, 100}));
    EXPECT_FALSE(defects.closed());
    EXPECT_EQ(defects.nHoles(), 2);
    EXPECT_EQ(defects.nOpenEdges(), 6);
    EXPECT_EQ(defects.nTurnedEdges(), 0);
}


TEST(SurfaceDefects, countsTheEdgesOfATurnedTriangle)
{
    triSurface surface(sphereSurface(2));
    Swap(surface[7][0], surface[7][1]);

    const surfaceDefects defects(surface);
    EXPECT_FALSE(defects.closed());
    EXPECT_EQ(defects.nHoles(), 0);
    EXPECT_EQ(defects.nTurnedEdges(), 3);
}


// ************************************************************************* //
