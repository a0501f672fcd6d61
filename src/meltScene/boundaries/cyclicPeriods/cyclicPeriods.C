/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicPeriods.H"
#include "cyclicPolyPatch.H"
#include "polyMesh.H"
#include "processorPolyPatch.H"
#include "SubField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // Lengths and areas that are equal but for the digits of a mesh's file,
    // relative to the domain
    constexpr Foam::scalar tolerance = 1e-5;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::cyclicPeriods::reject
(
    const polyPatch& patch,
    const word& entry,
    const string& reason
) const
{
    FatalIOErrorInFunction(mesh_.boundaryMesh().objectPath())
        << "Entry " << entry << " of patch " << patch.name() << ": "
        << reason.c_str() << nl
        << "Accepted: type cyclic, two opposite sides of the box of the domain,"
        << " one the other translated along an axis" << exit(FatalIOError);
}


void Foam::melt::cyclicPeriods::add(const polyPatch& patch)
{
    const cyclicPolyPatch& cyclic = refCast<const cyclicPolyPatch>(patch);
    const boundBox& box = mesh_.bounds();
    const vector span(box.span());

    if (!cyclic.parallel())
    {
        reject(patch, "transform", "the patches are rotated, not translated");
    }

    const vector mean(sum(patch.faceAreas()));
    direction axis = 0;
    for (direction d = 1; d < vector::nComponents; ++d)
    {
        axis = mag(mean[d]) > mag(mean[axis]) ? d : axis;
    }
    const scalar side = mean[axis] > 0 ? box.max()[axis] : box.min()[axis];
    const scalar area = cmptProduct(span)/span[axis];

    for (const point& p : patch.localPoints())
    {
        if (mag(p[axis] - side) > tolerance*span[axis])
        {
            reject
            (
                patch,
                "faces",
                "a point of the patch is not on the side of the domain's box"
            );
        }
    }
    if (mag(mag(mean) - area) > tolerance*area)
    {
        reject(patch, "faces", "the patch is not a whole side of the domain");
    }

    // Both are whole sides, so only a neighbour on another axis is wrong
    const vector between
    (
        average(cyclic.neighbPatch().faceCentres())
      - average(patch.faceCentres())
    );
    if (mag(mag(between[axis]) - span[axis]) > tolerance*span[axis])
    {
        reject
        (
            patch, "neighbourPatch", "it is not the opposite side of the domain"
        );
    }
    period_[axis] = span[axis];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::cyclicPeriods::cyclicPeriods(const polyMesh& mesh)
:
    mesh_(mesh),
    period_(Zero)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            if (Pstream::parRun())
            {
                reject(patch, "type", "the run has several ranks");
            }
            add(patch);
        }
        else if (patch.coupled() && !isA<processorPolyPatch>(patch))
        {
            reject(patch, "type", "type " + patch.type() + " is not supported");
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::cyclicPeriods::refuse(const word& method) const
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            FatalIOErrorInFunction(mesh_.boundaryMesh().objectPath())
                << "The method " << method << " has no cyclic patches: patch "
                << patch.name() << " has type cyclic." << nl
                << "Accepted: a domain without, or another method"
                << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
