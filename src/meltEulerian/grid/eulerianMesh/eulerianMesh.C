/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMesh.H"
#include "emptyPolyPatch.H"
#include "meshSearch.H"
#include "OSspecific.H"
#include "Time.H"
#include "volFields.H"

#include <algorithm>
#include <cmath>

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


//- Corners of the face normal to a on the lower side of a cell, the normal
//  pointing up
FixedList<triple, 4> corners(const int a, const triple& c)
{
    const int b = (a + 1) % 3, d = (a + 2) % 3;
    FixedList<triple, 4> nodes(c);
    ++nodes[1][b];
    ++nodes[2][b];
    ++nodes[2][d];
    ++nodes[3][d];
    return nodes;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::point Foam::melt::eulerianMesh::position(const triple& node) const
{
    point p;
    for (direction k = 0; k < 3; ++k)
    {
        p[k] =
            box_.min()[k]
          + box_.span()[k]*(scalar(node[k])/grid_->n()[k]);
    }
    return p;
}


void Foam::melt::eulerianMesh::makeGrid()
{
    const fvMesh& domain = scene_.mesh();
    triple n;
    std::array<double, 3> d;
    std::array<bool, 3> solved;
    for (direction k = 0; k < 3; ++k)
    {
        solved[k] = domain.geometricD()[k] > 0;
        n[k] = 1;
        if (solved[k])
        {
            n[k] =
                max(1, int(std::lround(box_.span()[k]/scene_.resolution())));
        }
        d[k] = box_.span()[k]/n[k];
    }
    grid_ = std::make_unique<staggeredGrid>(n, d, solved);
}


void Foam::melt::eulerianMesh::findCells()
{
    const fvMesh& domain = scene_.mesh();
    const triple& n = grid_->n();
    const scalar volume = gSum(domain.V());
    const bool isBox = mag(volume/box_.volume() - 1) < 1e-6;

    const meshSearch search(domain);
    DynamicList<label> cells(grid_->nCells());
    meshCell_.setSize(grid_->nCells(), -1);
    triple c;
    for (c[2] = 0; c[2] < n[2]; ++c[2])
    {
        for (c[1] = 0; c[1] < n[1]; ++c[1])
        {
            for (c[0] = 0; c[0] < n[0]; ++c[0])
            {
                const triple next{c[0] + 1, c[1] + 1, c[2] + 1};
                const point centre(0.5*(position(c) + position(next)));
                if (isBox || search.findCell(centre) >= 0)
                {
                    meshCell_[grid_->cell(c)] = cells.size();
                    cells.append(grid_->cell(c));
                }
            }
        }
    }
    gridCell_.transfer(cells);
    grid_->setBlocked(missing());
}


void Foam::melt::eulerianMesh::makeMesh()
{
    const fvMesh& domain = scene_.mesh();
    const polyBoundaryMesh& patches = domain.boundaryMesh();
    const triple& n = grid_->n();
    const meshSearch search(domain);

    // Points that a cell uses
    labelList pointOf((n[0] + 1)*(n[1] + 1)*(n[2] + 1), -1);
    DynamicList<point> points;
    const auto pointAt = [&](const triple& node)
    {
        label& index = pointOf
        [
            node[0] + (n[0] + 1)*(node[1] + (n[1] + 1)*node[2])
        ];
        if (index < 0)
        {
            index = points.size();
            points.append(position(node));
        }
        return index;
    };
    const auto makeFace = [&](const int a, const triple& c, const int sign)
    {
        face f(4);
        const FixedList<triple, 4> nodes(corners(a, c));
        for (label i = 0; i < 4; ++i)
        {
            f[i] = pointAt(nodes[sign > 0 ? i : (4 - i) % 4]);
        }
        return f;
    };

    DynamicList<face> faces;
    DynamicList<label> owner, neighbour;
    DynamicList<gridFace> onGrid;
    struct boundaryFace
    {
        face f;
        label cell, domainFace;
        gridFace g;
    };
    List<DynamicList<boundaryFace>> boundary(patches.size());

    forAll(gridCell_, celli)
    {
        const int cell = gridCell_[celli];
        const int row = cell/n[0];
        const triple c{cell % n[0], row % n[1], row/n[1]};
        for (int a = 0; a < 3; ++a)
        {
            for (const int side : {0, 1})
            {
                triple other(c), at(c);
                other[a] += side ? 1 : -1;
                at[a] += side;
                const label otherCell =
                    grid_->inside(other) ? meshCell_[grid_->cell(other)] : -1;
                const gridFace g{a, grid_->face(a, at), side ? 1 : -1};
                if (otherCell > celli)
                {
                    faces.append(makeFace(a, at, 1));
                    owner.append(celli);
                    neighbour.append(otherCell);
                    onGrid.append(g);
                }
                else if (otherCell < 0)
                {
                    triple opposite(at);
                    ++opposite[(a + 1) % 3];
                    ++opposite[(a + 2) % 3];
                    const label domainFacei = search.findNearestBoundaryFace
                    (
                        0.5*(position(at) + position(opposite))
                    );
                    const label patchi = patches.whichPatch(domainFacei);
                    boundary[patchi].append
                    (
                        {
                            makeFace(a, at, g.sign),
                            celli,
                            domainFacei - patches[patchi].start(),
                            g
                        }
                    );
                }
            }
        }
    }

    domainFace_.setSize(patches.size());
    labelList starts(patches.size());
    forAll(boundary, patchi)
    {
        starts[patchi] = faces.size();
        domainFace_[patchi].setSize(boundary[patchi].size());
        forAll(boundary[patchi], i)
        {
            const boundaryFace& b = boundary[patchi][i];
            faces.append(b.f);
            owner.append(b.cell);
            onGrid.append(b.g);
            domainFace_[patchi][i] = b.domainFace;
        }
    }
    gridFaces_ = onGrid;

    const Time& time = domain.time();
    provide(time, "fvSchemes");
    provide(time, "fvSolution");
    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                regionName,
                time.constant(),
                time,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            pointField(points),
            faceList(faces),
            labelList(owner),
            labelList(neighbour)
        )
    );

    List<polyPatch*> newPatches(patches.size());
    forAll(patches, patchi)
    {
        newPatches[patchi] = patches[patchi].clone
        (
            mesh_->boundaryMesh(),
            patchi,
            domainFace_[patchi].size(),
            starts[patchi]
        ).ptr();
    }
    mesh_->addFvPatches(newPatches);

    // What is made is not read; schemes and solvers are
    fvSchemes& schemes = *mesh_;
    schemes.readOpt() = IOobject::MUST_READ;
    schemes.read();
    fvSolution& solution = *mesh_;
    solution.readOpt() = IOobject::MUST_READ;
    solution.read();
}


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


void Foam::melt::eulerianMesh::setWalls()
{
    forAll(mesh_->boundaryMesh(), patchi)
    {
        const polyPatch& patch = mesh_->boundaryMesh()[patchi];
        const wallCondition& w = wall(patchi);
        const auto condition =
            w.velocity == wallCondition::velocityType::open
          ? staggeredGrid::condition::open
          : w.velocity == wallCondition::velocityType::slip
          ? staggeredGrid::condition::slip : staggeredGrid::condition::noSlip;
        forAll(patch, i)
        {
            const gridFace& g = gridFaces_[patch.start() + i];
            const vector U
            (
                w.isWall() ? w.U[domainFace_[patchi][i]] : vector(Zero)
            );
            if (mag(U[g.direction]) > SMALL*mag(U))
            {
                FatalErrorInFunction
                    << "Wall " << w.name << " moves along its normal: U is "
                    << U << " m/s at " << patch.faceCentres()[i] << nl
                    << "Accepted by the method eulerian: 0/U along the wall"
                    << exit(FatalError);
            }
            grid_->setWall
            (
                g.direction,
                g.face,
                isA<emptyPolyPatch>(patch)
              ? staggeredGrid::condition::slip : condition,
                {U.x(), U.y(), U.z()}
            );
        }
    }
    grid_->setBlocked(missing());
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
