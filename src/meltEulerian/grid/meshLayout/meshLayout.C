/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshLayout.H"
#include "processorPolyPatch.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::meshLayout Foam::melt::meshLayout::part
(
    const labelUList& cellRank,
    const label rank
) const
{
    meshLayout result;

    // Cells in the order of the whole
    labelList cellHere(cellRank.size(), -1);
    DynamicList<label> cells;
    forAll(cellRank, celli)
    {
        if (cellRank[celli] == rank)
        {
            cellHere[celli] = cells.size();
            cells.append(celli);
        }
    }

    // Faces: inner ones, those of patches, those between ranks
    DynamicList<label> inner;
    List<DynamicList<label>> between(max(label(0), max(cellRank) + 1));
    forAll(neighbour, facei)
    {
        const label own = cellRank[owner[facei]];
        const label nei = cellRank[neighbour[facei]];
        if (own == rank && nei == rank)
        {
            inner.append(facei);
        }
        else if (own == rank || nei == rank)
        {
            between[own == rank ? nei : own].append(facei);
        }
    }
    DynamicList<label> used(inner);
    result.patchStart = labelList(patchStart.size());
    result.patchSize = labelList(patchStart.size());
    forAll(patchStart, patchi)
    {
        result.patchStart[patchi] = used.size();
        for (label i = 0; i < patchSize[patchi]; ++i)
        {
            const label facei = patchStart[patchi] + i;
            if (cellRank[owner[facei]] == rank)
            {
                used.append(facei);
            }
        }
        result.patchSize[patchi] = used.size() - result.patchStart[patchi];
    }
    forAll(between, other)
    {
        if (between[other].size())
        {
            result.neighbourRank.append(other);
            result.patchStart.append(used.size());
            result.patchSize.append(between[other].size());
            used.append(between[other]);
        }
    }

    labelList pointHere(points.size(), -1);
    DynamicList<label> pointsUsed;
    result.faces.setSize(used.size());
    result.owner.setSize(used.size());
    result.neighbour.setSize(inner.size());
    result.faceInWhole.setSize(used.size());
    forAll(used, i)
    {
        const label facei = used[i];
        const bool turned = cellHere[owner[facei]] < 0;
        face f(turned ? faces[facei].reverseFace() : faces[facei]);
        for (label& pointi : f)
        {
            if (pointHere[pointi] < 0)
            {
                pointHere[pointi] = pointsUsed.size();
                pointsUsed.append(pointi);
            }
            pointi = pointHere[pointi];
        }
        result.faces[i] = f;
        result.owner[i] =
            cellHere[turned ? neighbour[facei] : owner[facei]];
        if (i < inner.size())
        {
            result.neighbour[i] = cellHere[neighbour[facei]];
        }
        result.faceInWhole[i] = turned ? -facei - 1 : facei + 1;
    }
    result.points = pointField(points, pointsUsed);
    result.cellInWhole = cells;
    result.pointInWhole = pointsUsed;
    return result;
}


Foam::autoPtr<Foam::fvMesh> Foam::melt::meshLayout::mesh
(
    const IOobject& io,
    const polyBoundaryMesh& domainPatches
) const
{
    autoPtr<fvMesh> result
    (
        new fvMesh
        (
            io,
            pointField(points),
            faceList(faces),
            labelList(owner),
            labelList(neighbour)
        )
    );
    List<polyPatch*> patches(patchStart.size());
    const label nWhole = patchStart.size() - neighbourRank.size();
    forAll(patches, patchi)
    {
        patches[patchi] =
            patchi < nWhole
          ? domainPatches[patchi].clone
            (
                result->boundaryMesh(),
                patchi,
                patchSize[patchi],
                patchStart[patchi]
            ).ptr()
          : new processorPolyPatch
            (
                patchSize[patchi],
                patchStart[patchi],
                patchi,
                result->boundaryMesh(),
                Pstream::myProcNo(),
                neighbourRank[patchi - nWhole]
            );
    }
    result->addFvPatches(patches);
    return result;
}

// ************************************************************************* //
