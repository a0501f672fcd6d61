/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallParticleGenerator.H"
#include "wallLayers.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::melt::wallParticleGenerator::wallPatches
(
    const polyMesh& mesh
)
{
    DynamicList<label> walls;

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wallPolyPatch>(patch))
        {
            walls.append(patch.index());
        }
    }

    return labelList(walls);
}


Foam::melt::wallParticles Foam::melt::wallParticleGenerator::generate
(
    const polyMesh& mesh,
    const labelUList& patches,
    const scalar spacing,
    const scalar supportRadius,
    const boundBox& region
)
{
    if (!(spacing > 0) || !(supportRadius >= spacing/2))
    {
        FatalErrorInFunction
            << "spacing " << spacing << " m has to be positive and the support "
            << "radius " << supportRadius << " m at least half of it"
            << exit(FatalError);
    }

    const wallSurface surface(mesh, patches);
    wallParticleBuilder builder(surface, spacing, supportRadius, region);

    // Exact ones first: where two walls want the same place, the first has it
    forAll(surface.groups(), groupi)
    {
        if (surface.groups()[groupi].plane)
        {
            addPlaneWallLayers(builder, groupi);
        }
    }

    addConvexWallEdges(builder);
    addConvexWallCorners(builder);

    forAll(surface.groups(), groupi)
    {
        if (!surface.groups()[groupi].plane)
        {
            addCurvedWallLayers(builder, groupi);
        }
    }

    return std::move(builder.particles());
}


// ************************************************************************* //
