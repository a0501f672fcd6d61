/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelDensity.H"
#include "IOField.H"
#include "polyMesh.H"
#include "Time.H"
#include "voxelSurface.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::melt::voxelDensity::io
(
    const polyMesh& mesh,
    const word& name
)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        "voxelAutomaton",
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::voxelDensity::voxelDensity(const polyMesh& mesh)
:
    values_(IOField<scalar>(io(mesh, "density"))),
    voxels_(IOField<label>(io(mesh, "densityVoxels"))),
    grid_(IOField<vector>(io(mesh, "densityGrid")))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::voxelDensity::found(const polyMesh& mesh)
{
    return io(mesh, "density").typeHeaderOk<IOField<scalar>>(true);
}


Foam::melt::triangleMesh Foam::melt::voxelDensity::surface
(
    const scalar level
) const
{
    const std::vector<int> ijk(voxels_.begin(), voxels_.end());
    const std::vector<float> values(values_.begin(), values_.end());
    const point& origin = grid_[0];
    return voxelSurface
    (
        values.size(),
        ijk.data(),
        values.data(),
        {origin.x(), origin.y(), origin.z()},
        edge(),
        level
    );
}

// ************************************************************************* //
