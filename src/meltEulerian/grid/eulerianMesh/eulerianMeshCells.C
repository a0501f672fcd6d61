/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMesh.H"
#include "meshSearch.H"
#include "volFields.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using triple = Foam::melt::staggeredGrid::triple;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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

    // A centre on the border between ranks is the lower one's
    const meshSearch search(domain);
    labelList rank(grid_->nCells(), labelMax);
    triple c;
    for (c[2] = 0; c[2] < n[2]; ++c[2])
    {
        for (c[1] = 0; c[1] < n[1]; ++c[1])
        {
            for (c[0] = 0; c[0] < n[0]; ++c[0])
            {
                const triple next{c[0] + 1, c[1] + 1, c[2] + 1};
                const point centre(0.5*(position(c) + position(next)));
                if
                (
                    (isBox && !Pstream::parRun())
                 || search.findCell(centre) >= 0
                )
                {
                    rank[grid_->cell(c)] = Pstream::myProcNo();
                }
            }
        }
    }
    Pstream::listCombineGather(rank, minEqOp<label>());
    Pstream::listCombineScatter(rank);

    List<DynamicList<label>> cells(Pstream::nProcs());
    meshCell_.setSize(grid_->nCells(), -1);
    forAll(rank, cell)
    {
        if (rank[cell] == labelMax)
        {
            rank[cell] = -1;
            continue;
        }
        if (rank[cell] == Pstream::myProcNo())
        {
            meshCell_[cell] = cells[rank[cell]].size();
        }
        cells[rank[cell]].append(cell);
    }
    cellRank_.transfer(rank);
    gridCells_.setSize(cells.size());
    forAll(cells, rank)
    {
        gridCells_[rank].transfer(cells[rank]);
        if (gridCells_[rank].empty())
        {
            FatalErrorInFunction
                << "Rank " << rank << " has no cell of the mesh of "
                << scene_.resolution() << " m." << nl
                << "Accepted: parts of the domain that are larger"
                << exit(FatalError);
        }
    }
    grid_->setBlocked(missing());
}

// ************************************************************************* //
