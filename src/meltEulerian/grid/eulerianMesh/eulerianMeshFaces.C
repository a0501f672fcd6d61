/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMesh.H"

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


Foam::melt::meshLayout Foam::melt::eulerianMesh::whole(List<gridFace>& onGrid)
{
    const triple& n = grid_->n();
    labelList wholeCell(grid_->nCells(), -1);
    DynamicList<label> gridCell;
    forAll(cellRank_, cell)
    {
        if (cellRank_[cell] >= 0)
        {
            wholeCell[cell] = gridCell.size();
            gridCell.append(cell);
        }
    }

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
    DynamicList<gridFace> facesOnGrid;
    struct boundaryFace
    {
        face f;
        label cell;
        patchFace p;
    };
    List<DynamicList<boundaryFace>> boundary(domain_.nPatches());

    forAll(gridCell, celli)
    {
        const int cell = gridCell[celli];
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
                    grid_->inside(other) ? wholeCell[grid_->cell(other)] : -1;
                const gridFace g{a, grid_->face(a, at), side ? 1 : -1};
                if (otherCell > celli)
                {
                    faces.append(makeFace(a, at, 1));
                    owner.append(celli);
                    neighbour.append(otherCell);
                    facesOnGrid.append(g);
                }
                else if (otherCell < 0)
                {
                    triple opposite(at);
                    ++opposite[(a + 1) % 3];
                    ++opposite[(a + 2) % 3];
                    const point centre
                    (
                        0.5*(position(at) + position(opposite))
                    );
                    const labelPair onDomain(domain_.nearest(centre));
                    boundary[onDomain.first()].append
                    (
                        {
                            makeFace(a, at, g.sign),
                            celli,
                            {g, onDomain.second(), centre}
                        }
                    );
                }
            }
        }
    }

    meshLayout result;
    result.patchStart.setSize(boundary.size());
    result.patchSize.setSize(boundary.size());
    patchFaces_.setSize(boundary.size());
    forAll(boundary, patchi)
    {
        result.patchStart[patchi] = faces.size();
        result.patchSize[patchi] = boundary[patchi].size();
        patchFaces_[patchi].setSize(boundary[patchi].size());
        forAll(boundary[patchi], i)
        {
            const boundaryFace& b = boundary[patchi][i];
            faces.append(b.f);
            owner.append(b.cell);
            facesOnGrid.append(b.p.onGrid);
            patchFaces_[patchi][i] = b.p;
        }
    }
    result.points.transfer(points);
    result.faces.transfer(faces);
    result.owner.transfer(owner);
    result.neighbour.transfer(neighbour);
    onGrid.transfer(facesOnGrid);
    return result;
}

// ************************************************************************* //
