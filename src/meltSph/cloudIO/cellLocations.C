/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellLocations.H"
#include "indexedOctree.H"
#include "polyMesh.H"
#include "polyMeshTetDecomposition.H"
#include "tetIndices.H"
#include "treeDataCell.H"
#include "treeDataFace.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

namespace
{
    // Points are located in chunks, each point first in the cell of the one
    // before. Fixed, so that the result does not depend on the thread count.
    constexpr label chunkSize = 256;

    // Relative inflation of the bounds of a search tree, as meshSearch has it
    constexpr scalar boundsMargin = 1e-4;


    // tetrahedron::pointToBarycentric gives up on determinants below
    // 1e-15 m^3, and the cells of a small domain have such
    barycentric coordinatesIn(const tetPointRef& tet, const point& p)
    {
        const vector e0(tet.a() - tet.d());
        const vector e1(tet.b() - tet.d());
        const vector e2(tet.c() - tet.d());
        const vector r(p - tet.d());

        const scalar volume = e0 & (e1 ^ e2);

        if (volume == 0)
        {
            return barycentric(-GREAT, 0, 0, 0);
        }

        const scalar a = (r & (e1 ^ e2))/volume;
        const scalar b = (r & (e2 ^ e0))/volume;
        const scalar c = (r & (e0 ^ e1))/volume;

        return barycentric(a, b, c, 1 - a - b - c);
    }


    void primeForThreads(const polyMesh& mesh)
    {
        (void)mesh.tetBasePtIs();
        (void)mesh.cellTree();
        (void)mesh.cells();
        (void)mesh.cellPoints();
        (void)mesh.cellCentres();
        (void)mesh.faceCentres();
        (void)mesh.faceAreas();
    }


    indexedOctree<treeDataFace> boundaryTree(const polyMesh& mesh)
    {
        const label nBoundaryFaces = mesh.nFaces() - mesh.nInternalFaces();

        treeBoundBox bounds(mesh.points());
        bounds.inflate(boundsMargin);

        return indexedOctree<treeDataFace>
        (
            treeDataFace
            (
                true,
                mesh,
                identity(nBoundaryFaces, mesh.nInternalFaces())
            ),
            bounds,
            8,      // levels, leaf size, duplicity: as meshSearch has them
            10,
            3.0
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool cellLocations::locateIn
(
    const polyMesh& mesh,
    const point& p,
    const label celli,
    const label i
)
{
    if (celli < 0)
    {
        return false;
    }

    const tetIndices tet(polyMeshTetDecomposition::findTet(mesh, celli, p));

    if (tet.cell() < 0)
    {
        return false;
    }

    cell[i] = celli;
    tetFace[i] = tet.face();
    tetPoint[i] = tet.tetPt();
    coordinates[i] = coordinatesIn(tet.tet(mesh), p);

    return true;
}


void cellLocations::extrapolate
(
    const polyMesh& mesh,
    const point& p,
    const label celli,
    const label i
)
{
    scalar best = -VGREAT;

    for
    (
        const tetIndices& tet
      : polyMeshTetDecomposition::cellTetIndices(mesh, celli)
    )
    {
        const barycentric b(coordinatesIn(tet.tet(mesh), p));

        if (cmptMin(b) > best)
        {
            best = cmptMin(b);
            cell[i] = celli;
            tetFace[i] = tet.face();
            tetPoint[i] = tet.tetPt();
            coordinates[i] = b;
        }
    }
}


label cellLocations::locateOutside
(
    const polyMesh& mesh,
    const pointField& points
)
{
    label n = 0;

    if (!cell.found(-1))
    {
        return n;
    }

    const indexedOctree<treeDataFace> tree(boundaryTree(mesh));

    forAll(points, i)
    {
        if (cell[i] < 0)
        {
            ++n;
            const label index = tree.findNearest(points[i], VGREAT).index();
            const label facei = tree.shapes().faceLabels()[index];
            extrapolate(mesh, points[i], mesh.faceOwner()[facei], i);
        }
    }

    return n;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

cellLocations::cellLocations(const polyMesh& mesh, const pointField& points)
:
    cell(points.size(), -1),
    tetFace(points.size(), -1),
    tetPoint(points.size(), -1),
    coordinates(points.size()),
    outside(0)
{
    primeForThreads(mesh);
    const indexedOctree<treeDataCell>& tree = mesh.cellTree();
    const label n = points.size();
    const label nChunks = (n + chunkSize - 1)/chunkSize;

    #pragma omp parallel for schedule(dynamic)
    for (label chunk = 0; chunk < nChunks; ++chunk)
    {
        label last = -1;

        for (label i = chunk*chunkSize; i < min(n, (chunk + 1)*chunkSize); ++i)
        {
            if (!locateIn(mesh, points[i], last, i))
            {
                locateIn(mesh, points[i], tree.findInside(points[i]), i);
            }

            last = cell[i];
        }
    }

    outside = locateOutside(mesh, points);
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
