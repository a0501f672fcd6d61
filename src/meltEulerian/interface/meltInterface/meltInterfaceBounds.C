/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltInterface.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Less melt than this in a cell goes to the neighbours, and more than this above
// a full cell [-]
const Foam::scalar dust = 5e-10;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::meltInterface::bounded(const scalar alpha)
{
    return alpha <= 1 + dust && (alpha >= dust || alpha == 0);
}


template<class Action>
void Foam::melt::meltInterface::forAllBeside
(
    const int cell,
    const bool toSolid,
    const Action& action
) const
{
    const staggeredGrid& grid = mesh_.grid();
    const staggeredGrid::triple at(grid.position(cell));
    for (int a = 0; a < 3; ++a)
    {
        for (const int step : {-1, 1})
        {
            staggeredGrid::triple c(at);
            c[a] += step;
            const int other = grid.inside(c) ? grid.cell(c) : -1;
            if
            (
                other >= 0
             && mesh_.has(other)
             && (toSolid || !grid.blocked(other))
            )
            {
                action(other);
            }
        }
    }
}


void Foam::melt::meltInterface::bound(scalarField& alphaH)
{
    bool allBounded = true;
    for (const scalar value : alpha_.primitiveField())
    {
        allBounded = allBounded && bounded(value);
    }
    if (!returnReduce(allBounded, andOp<bool>()))
    {
        std::vector<double> alpha(mesh_.onGrid(alpha_));
        std::vector<double> alphaHOfCell(mesh_.onGrid(alphaH));
        for (int cell = 0; cell < mesh_.grid().nCells(); ++cell)
        {
            // To cells that flow; in a full domain, to all
            for (const bool toSolid : {false, true})
            {
                if (!bounded(alpha[cell]))
                {
                    distribute(cell, toSolid, alpha, alphaHOfCell);
                }
            }
        }
        alpha_.primitiveFieldRef() = mesh_.onMesh(alpha);
        alphaH = mesh_.onMesh(alphaHOfCell);
    }
    alpha_.correctBoundaryConditions();
}


void Foam::melt::meltInterface::distribute
(
    const int cell,
    const bool toSolid,
    std::vector<double>& alpha,
    std::vector<double>& alphaH
)
{
    // All cells have the same volume
    const auto give = [&](const int to, const double part)
    {
        const double enthalpy =
            part == alpha[cell] ? alphaH[cell] : part*alphaH[cell]/alpha[cell];
        alpha[cell] -= part;
        alphaH[cell] -= enthalpy;
        alpha[to] += part;
        alphaH[to] += enthalpy;
        redistributed_ += mag(part)*mesh_.grid().volume();
    };

    // Rings of neighbours around the cell, nearest first
    seen_.resize(mesh_.grid().nCells(), 0);
    seen_[cell] = ++search_;
    std::vector<int> ring(1, cell), next;
    while (ring.size() && !bounded(alpha[cell]))
    {
        next.clear();
        for (const int c : ring)
        {
            forAllBeside(c, toSolid, [&](const int neighbour)
            {
                if (seen_[neighbour] != search_)
                {
                    seen_[neighbour] = search_;
                    next.push_back(neighbour);
                }
            });
        }
        std::sort(next.begin(), next.end(), [&](const int a, const int b)
        {
            return alpha[a] != alpha[b] ? alpha[a] > alpha[b] : a < b;
        });
        for (const int neighbour : next)
        {
            const double room = 1 - alpha[neighbour];
            if (alpha[cell] > 1 && room > 0)
            {
                give(neighbour, min(alpha[cell] - 1, room));
            }
            else if
            (
                !bounded(alpha[cell])
             && alpha[cell] < dust
             && alpha[neighbour] > dust - min(alpha[cell], 0.0)
             && alpha[neighbour] + alpha[cell] <= 1
            )
            {
                give(neighbour, alpha[cell]);
            }
        }
        ring.swap(next);
    }
}

// ************************************************************************* //
