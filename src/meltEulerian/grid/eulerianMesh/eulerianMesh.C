/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMesh.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::word Foam::melt::eulerianMesh::regionName("eulerian");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The region needs schemes and solvers before it is made
void provide(const Time& time, const word& name)
{
    const fileName file
    (
        time.globalPath()/time.system()
       /Foam::melt::eulerianMesh::regionName/name
    );
    if (!isFile(file))
    {
        mkDir(file.path());
        cp
        (
            fileName(getEnv("MELTFOAM_DIR"))
           /"etc/caseDicts/meltFoam/eulerian"/name,
            file
        );
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::eulerianMesh::writeMesh()
{
    mesh_->polyMesh::write();

    // Once is enough
    HashTable<regIOobject*> parts(mesh_->lookupClass<regIOobject>());
    forAllIters(parts, part)
    {
        part.val()->writeOpt() = IOobject::NO_WRITE;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::eulerianMesh::eulerianMesh(const meltScene& scene)
:
    scene_(scene),
    box_(scene.mesh().bounds())
{
    for (const polyPatch& patch : scene.mesh().boundaryMesh())
    {
        if (patch.coupled())
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of the domain is of type "
                << patch.type() << '.' << nl
                << "Accepted by the method eulerian: wall, patch, symmetryPlane,"
                << " symmetry and empty, in a run without mpirun"
                << exit(FatalError);
        }
    }
    makeGrid();
    findCells();
    provide(scene.mesh().time(), "fvSchemes");
    provide(scene.mesh().time(), "fvSolution");
    makeMesh();
    writeMesh();
    setWalls();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<double>
Foam::melt::eulerianMesh::onGrid(const scalarField& values) const
{
    std::vector<double> result(grid_->nCells(), 0);
    forAll(values, celli)
    {
        result[gridCell_[celli]] = values[celli];
    }
    return result;
}


Foam::scalarField
Foam::melt::eulerianMesh::onMesh(const std::vector<double>& values) const
{
    scalarField result(gridCell_.size());
    forAll(result, celli)
    {
        result[celli] = values[gridCell_[celli]];
    }
    return result;
}


std::vector<char> Foam::melt::eulerianMesh::missing() const
{
    std::vector<char> result(grid_->nCells());
    for (int cell = 0; cell < grid_->nCells(); ++cell)
    {
        result[cell] = meshCell_[cell] < 0;
    }
    return result;
}

// ************************************************************************* //
