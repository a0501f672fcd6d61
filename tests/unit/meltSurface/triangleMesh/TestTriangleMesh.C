/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "triangleMesh.H"

#include <cmath>
#include <gtest/gtest.h>

using Foam::melt::triangleMesh;

namespace
{

//- Tetrahedron with corners at the origin and at 1 on each axis, shifted
triangleMesh tetrahedron(const double shift)
{
    triangleMesh mesh;
    mesh.points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (double& x : mesh.points)
    {
        x += shift;
    }
    mesh.triangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    return mesh;
}

}

TEST(triangleMesh, volumeAndAreaOfTetrahedron)
{
    EXPECT_DOUBLE_EQ(tetrahedron(0).volume(), 1.0/6);
    EXPECT_DOUBLE_EQ(tetrahedron(0).area(), 1.5 + std::sqrt(3.0)/2);
    EXPECT_NEAR(tetrahedron(1e3).volume(), 1.0/6, 1e-12);
}

TEST(triangleMesh, closedSurfaceHasNoBadEdges)
{
    EXPECT_EQ(tetrahedron(0).nBadEdges(), 0u);
}

TEST(triangleMesh, holeGivesThreeBadEdges)
{
    triangleMesh mesh = tetrahedron(0);
    mesh.triangles.resize(9);
    EXPECT_EQ(mesh.nBadEdges(), 3u);
}

TEST(triangleMesh, flippedTriangleGivesThreeBadEdges)
{
    triangleMesh mesh = tetrahedron(0);
    std::swap(mesh.triangles[0], mesh.triangles[1]);
    EXPECT_EQ(mesh.nBadEdges(), 3u);
}

TEST(triangleMesh, emptyMesh)
{
    EXPECT_EQ(triangleMesh().volume(), 0);
    EXPECT_EQ(triangleMesh().area(), 0);
    EXPECT_EQ(triangleMesh().nBadEdges(), 0u);
}
