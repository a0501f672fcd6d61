/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMesh.H"
#include "OSspecific.H"
#include "processorPolyPatch.H"
#include "Time.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::word Foam::melt::eulerianMesh::regionName("eulerian");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using triple = Foam::melt::staggeredGrid::triple;

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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::eulerianMesh::eulerianMesh(const meltScene& scene)
:
    scene_(scene),
    domain_(scene),
    box_(scene.mesh().bounds())
{
    for (const polyPatch& patch : scene.mesh().boundaryMesh())
    {
        if (patch.coupled() && !isA<processorPolyPatch>(patch))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of the domain is of type "
                << patch.type() << '.' << nl
                << "Accepted by the method eulerian: wall, patch, symmetryPlane,"
                << " symmetry and empty"
                << exit(FatalError);
        }
    }
    makeGrid();
    findCells();
    if (Pstream::master())
    {
        provide(scene.mesh().time(), "fvSchemes");
        provide(scene.mesh().time(), "fvSolution");
    }
    makeMesh();
    findTerrain();
    setWalls();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<double>
Foam::melt::eulerianMesh::onGrid(const scalarField& values) const
{
    List<scalarField> ofRank(Pstream::nProcs());
    ofRank[Pstream::myProcNo()] = values;
    Pstream::gatherList(ofRank);
    Pstream::scatterList(ofRank);
    std::vector<double> result(grid_->nCells(), 0);
    forAll(ofRank, rank)
    {
        forAll(ofRank[rank], celli)
        {
            result[gridCells_[rank][celli]] = ofRank[rank][celli];
        }
    }
    return result;
}


Foam::scalarField
Foam::melt::eulerianMesh::onMesh(const std::vector<double>& values) const
{
    scalarField result(mesh_->nCells());
    forAll(result, celli)
    {
        result[celli] = values[gridCell(celli)];
    }
    return result;
}


Foam::point Foam::melt::eulerianMesh::faceCentre
(
    const int a,
    const int cell
) const
{
    triple opposite(grid_->position(cell));
    const point lower(position(opposite));
    ++opposite[(a + 1) % 3];
    ++opposite[(a + 2) % 3];
    return 0.5*(lower + position(opposite));
}


int Foam::melt::eulerianMesh::cellAt(const point& p) const
{
    triple c;
    for (direction k = 0; k < 3; ++k)
    {
        const scalar share = (p[k] - box_.min()[k])/box_.span()[k];
        c[k] = min(max(int(share*grid_->n()[k]), 0), grid_->n()[k] - 1);
    }
    return grid_->cell(c);
}


std::vector<char> Foam::melt::eulerianMesh::missing() const
{
    std::vector<char> result(grid_->nCells());
    for (int cell = 0; cell < grid_->nCells(); ++cell)
    {
        result[cell] = !has(cell);
    }
    return result;
}

// ************************************************************************* //
