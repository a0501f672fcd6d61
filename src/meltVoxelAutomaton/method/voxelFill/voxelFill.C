/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelFill.H"
#include "fvMesh.H"
#include "initialTemperature.H"
#include "shape.H"
#include "shapeVoxels.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::voxelFill::fillTerrain
(
    const meltScene& scene,
    const voxelFrame& frame,
    voxelGrid& grid
)
{
    const dictionary& terrain = scene.dict().subOrEmptyDict("terrain");
    for (const word& name : terrain.toc())
    {
        const autoPtr<shape> body
        (
            shape::New
            (
                name, terrain.subDict(name), scene.mesh().time().globalPath()
            )
        );
        const shapeVoxels voxels(*body, frame);
        for (const shapeVoxels::filledVoxel& f : voxels.filled())
        {
            grid.fillRock(f.v[0], f.v[1], f.v[2], f.share);
        }
    }
    grid.refresh();
}


void Foam::melt::voxelFill::fillMelt
(
    const meltScene& scene,
    const voxelFrame& frame,
    voxelGrid& grid
)
{
    const dictionary& shapes = scene.dict().subDict("shapes");
    for (const shape& body : scene.shapes())
    {
        const autoPtr<initialTemperature> T
        (
            initialTemperature::New
            (
                shapes.subDict(body.name()).subDict("T"), body
            )
        );
        const shapeVoxels voxels(body, frame);
        const std::vector<shapeVoxels::filledVoxel>& filled = voxels.filled();
        pointField centres(filled.size());
        forAll(centres, i)
        {
            const std::array<int, 3>& v = filled[i].v;
            centres[i] = frame.position(v[0] + 0.5, v[1] + 0.5, v[2] + 0.5);
        }
        const scalarField values(T->value(centres));
        forAll(centres, i)
        {
            const std::array<int, 3>& v = filled[i].v;
            grid.fill(v[0], v[1], v[2], filled[i].share, values[i]);
        }
    }
    grid.refresh();

    if (grid.totalMass() == 0)
    {
        FatalIOErrorInFunction(shapes)
            << "The grid is empty: no shape fills a voxel of "
            << scene.resolution() << " m that terrain leaves free." << nl
            << "Accepted: a shape thicker than that" << exit(FatalIOError);
    }
}

// ************************************************************************* //
