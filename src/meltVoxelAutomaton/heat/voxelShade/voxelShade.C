/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelShade.H"
#include "voxelRays.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::voxelShade::voxelShade
(
    const voxelGrid& grid,
    const voxelFrame& frame
)
:
    grid_(grid),
    frame_(frame)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boolList Foam::melt::voxelShade::blocked
(
    const surfaceElements& elements,
    const labelList& set,
    const pointField& to
) const
{
    // Off the face, by less than anything that matters
    const scalar off = 1e-6*frame_.dx();

    boolList result(set.size());
    #pragma omp parallel for schedule(dynamic, 64)
    for (label k = 0; k < set.size(); ++k)
    {
        const label i = set[k];
        result[k] = voxelRays::blocked
        (
            grid_,
            frame_.coordinates
            (
                elements.position[i] + off*elements.normal[i]
            ),
            frame_.coordinates(to[k])
        );
    }
    return result;
}

// ************************************************************************* //
