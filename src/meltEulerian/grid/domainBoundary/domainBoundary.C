/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "domainBoundary.H"
#include "ofAllRanks.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::domainBoundary::domainBoundary(const meltScene& scene)
:
    walls_(scene.mesh().boundaryMesh().nNonProcessor() + 1),
    pressure_(scene)
{
    const polyMesh& mesh = scene.mesh();
    walls_.last().velocity = wallCondition::velocityType::open;
    walls_.last().thermal = wallCondition::thermalType::adiabatic;

    pointField points;
    faceList faces;
    for (label patchi = 0; patchi < nPatches(); ++patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        wallCondition& wall = walls_[patchi];
        wall = scene.walls()[patchi];
        if (!wall.isWall() && pressure_.closes(patchi))
        {
            wall.velocity = wallCondition::velocityType::slip;
        }
        wall.U = ofAllRanks(wall.U);
        wall.T = ofAllRanks(wall.T);
        wall.h = ofAllRanks(wall.h);

        const pointField patchPoints(ofAllRanks(patch.localPoints()));
        faceList patchFaces(patch.localFaces());
        labelList nPoints(Pstream::nProcs());
        nPoints[Pstream::myProcNo()] = patch.nPoints();
        Pstream::gatherList(nPoints);
        Pstream::scatterList(nPoints);
        label offset = points.size();
        for (label rank = 0; rank < Pstream::myProcNo(); ++rank)
        {
            offset += nPoints[rank];
        }
        for (face& f : patchFaces)
        {
            for (label& pointi : f)
            {
                pointi += offset;
            }
        }
        patchFaces = ofAllRanks(patchFaces);
        points.append(patchPoints);
        faces.append(patchFaces);
        patch_.append(labelList(patchFaces.size(), patchi));
        ofPatch_.append(identity(patchFaces.size()));
    }
    points_.transfer(points);
    faces_.reset(new primitiveFacePatch(faces, points_));

    // Not flat in a plane case
    treeBoundBox box(points_);
    box.inflate(0.1);
    tree_.reset
    (
        new indexedOctree<search>
        (
            search(false, faces_(), indexedOctree<search>::perturbTol()),
            box,
            8,
            10,
            3.0
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelPair Foam::melt::domainBoundary::nearest(const point& p) const
{
    const label facei =
        tree_->findNearest(p, magSqr(tree_->bb().span())).index();
    return labelPair(patch_[facei], ofPatch_[facei]);
}

// ************************************************************************* //
