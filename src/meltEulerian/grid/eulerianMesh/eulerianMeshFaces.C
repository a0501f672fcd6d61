/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMesh.H"
#include "meshSearch.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using triple = Foam::melt::staggeredGrid::triple;

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

// ************************************************************************* //
