/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelWalls.H"
#include "fvMesh.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::size_t Foam::melt::voxelWalls::index
(
    const int side,
    const int x,
    const int y,
    const int z
) const
{
    return
        side < 2 ? std::size_t(y)*n_[2] + z
      : side < 4 ? std::size_t(x)*n_[2] + z
      : std::size_t(x)*n_[1] + y;
}


void Foam::melt::voxelWalls::addFace
(
    const voxelFrame& frame,
    const int side,
    const boundBox& face,
    const contact& c
)
{
    std::vector<contact>& contacts = contacts_[side];
    if (contacts.empty())
    {
        const int normal = side/2;
        contacts.resize
        (
            std::size_t(n_[(normal + 1) % 3])*n_[(normal + 2) % 3],
            contact{0, 0}
        );
    }
    std::array<int, 3> begin, end;
    frame.range(face, begin, end);
    begin[side/2] = 0;
    end[side/2] = 1;
    for (int x = begin[0]; x < end[0]; ++x)
    {
        for (int y = begin[1]; y < end[1]; ++y)
        {
            for (int z = begin[2]; z < end[2]; ++z)
            {
                contacts[index(side, x, y, z)] = c;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::voxelWalls::voxelWalls
(
    const meltScene& scene,
    const voxelFrame& frame
)
:
    n_(frame.n()),
    open_{}
{
    const fvMesh& mesh = scene.mesh();
    const boundBox& domain = mesh.bounds();
    const scalar tolerance = 1e-6*domain.mag();

    for (const wallCondition& condition : scene.walls().conditions())
    {
        const polyPatch& patch = mesh.boundaryMesh()[condition.patchi];
        forAll(patch, facei)
        {
            const boundBox face(pointField(patch.localPoints(),
                patch.localFaces()[facei]), false);
            int side = -1;
            for (int s = 0; s < 6; ++s)
            {
                const vector n(frame.normal(s));
                const scalar edge =
                    max(n & domain.min(), n & domain.max());
                if (min(n & face.min(), n & face.max()) > edge - tolerance)
                {
                    side = s;
                }
            }
            if (side < 0)
            {
                FatalErrorInFunction
                    << "Patch " << condition.name << " is not on a side of "
                    << domain << nl << "Accepted by the method voxelAutomaton:"
                    << " a domain that is a box along the axes"
                    << exit(FatalError);
            }
            if (side < 5)
            {
                open_[side] = open_[side] || !condition.isWall();
            }
            if (condition.thermal != wallCondition::thermalType::adiabatic)
            {
                const bool fixed =
                    condition.thermal
                 == wallCondition::thermalType::fixedTemperature;
                addFace
                (
                    frame,
                    side,
                    face,
                    {condition.T[facei], fixed ? -1 : condition.h[facei]}
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::voxelWalls::heats() const
{
    return std::any_of
    (
        contacts_.begin(),
        contacts_.end(),
        [](const std::vector<contact>& c) { return !c.empty(); }
    );
}

// ************************************************************************* //
