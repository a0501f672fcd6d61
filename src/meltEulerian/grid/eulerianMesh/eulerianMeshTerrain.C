/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMesh.H"
#include "meltScene.H"
#include "shape.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::eulerianMesh::findTerrain()
{
    const dictionary& terrain = scene_.dict().subOrEmptyDict("terrain");
    if (terrain.empty())
    {
        return;
    }
    scalarField within(mesh_->nCells(), 0);
    for (const word& name : terrain.toc())
    {
        const autoPtr<shape> body
        (
            shape::New
            (
                name, terrain.subDict(name), scene_.mesh().time().globalPath()
            )
        );
        const boolList inside(body->inside(mesh_->cellCentres()));
        forAll(inside, celli)
        {
            within[celli] = within[celli] > 0 || inside[celli];
        }
    }
    const std::vector<double> onGrid(this->onGrid(within));
    terrain_.assign(onGrid.begin(), onGrid.end());
}

// ************************************************************************* //
