/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellLocations.H"
#include "meltSph/mesh/hexMesh.H"
#include "meltUnitTests.H"
#include "tetIndices.H"

#include <omp.h>
#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;

namespace
{

// 3 n points in the cube of that size, two thirds of them on planes x = i/4
pointField pointsIn(const scalar size, const label n)
{
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<scalar> uniform(0, 1);
    pointField points(3*n);

    forAll(points, i)
    {
        for (direction d = 0; d < 3; ++d)
        {
            const scalar c = uniform(generator);
            points[i][d] = size*(i < n ? c : std::round(4*c)/4);
        }
    }

    return points;
}


// Position that the coordinates mean, as particle::position() has it
point meant(const polyMesh& mesh, const cellLocations& in, const label i)
{
    const tetIndices tet(in.cell[i], in.tetFace[i], in.tetPoint[i]);
    return tet.tet(mesh).barycentricToPoint(in.coordinates[i]);
}

} // End anonymous namespace


TEST(CellLocations, coordinatesMeanThePoints)
{
    // The small cells have determinants of 1e-17 m^3 and less
    for (const scalar size : {1.0, 1e-5})
    {
        const autoPtr<polyMesh> mesh
        (
            unitTest::boxMesh(labelVector(4, 3, 5), point::uniform(size))
        );
        const pointField points(pointsIn(size, 500));
        const cellLocations in(mesh(), points);

        EXPECT_EQ(in.outside, 0);
        forAll(points, i)
        {
            ASSERT_GE(in.cell[i], 0);
            EXPECT_LT(mag(meant(mesh(), in, i) - points[i]), 1e-14*size);
        }
    }
}


TEST(CellLocations, cellsContainThePoints)
{
    const autoPtr<polyMesh> mesh
    (
        unitTest::boxMesh(labelVector(4, 3, 5), vector::one)
    );
    const pointField points(pointsIn(1, 500));
    const cellLocations in(mesh(), points);

    forAll(points, i)
    {
        EXPECT_TRUE
        (
            mesh->pointInCell(points[i], in.cell[i], polyMesh::CELL_TETS)
        );
    }
}


TEST(CellLocations, sameWithAnyNumberOfThreads)
{
    const autoPtr<polyMesh> mesh
    (
        unitTest::boxMesh(labelVector(4, 3, 5), vector::one)
    );
    const pointField points(pointsIn(1, 2000));

    const int nThreads = omp_get_max_threads();
    omp_set_num_threads(1);
    const cellLocations a(mesh(), points);
    omp_set_num_threads(3);
    const cellLocations b(mesh(), points);
    omp_set_num_threads(nThreads);

    EXPECT_EQ(a.cell, b.cell);
    EXPECT_EQ(a.tetFace, b.tetFace);
    EXPECT_EQ(a.tetPoint, b.tetPoint);
    EXPECT_EQ(a.coordinates, b.coordinates);
}


TEST(CellLocations, outsidePointsGetTheNearestBoundaryCell)
{
    const autoPtr<polyMesh> mesh
    (
        unitTest::boxMesh(labelVector(4, 4, 4), vector::one)
    );
    pointField points(3, point(0.6, 0.6, 0.6));
    points[1].z() = -0.2;
    points[2] = point(3, 0.1, 0.6);
    const cellLocations in(mesh(), points);

    EXPECT_EQ(in.outside, 2);
    EXPECT_EQ(in.cell[1], mesh->findCell(point(0.6, 0.6, 0.01)));
    EXPECT_EQ(in.cell[2], mesh->findCell(point(0.99, 0.1, 0.6)));
    forAll(points, i)
    {
        EXPECT_LT(mag(meant(mesh(), in, i) - points[i]), 1e-13);
    }
}


// ************************************************************************* //
