/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltInterface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Less melt than this in a cell goes to the neighbours, and more than this above
// a full cell [-]
const Foam::scalar dust = 5e-10;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::meltInterface::accepts(const label celli) const
{
    return !mesh_.grid().blocked(mesh_.gridCell(celli));
}


void Foam::melt::meltInterface::bound(scalarField& alphaH)
{
    const fvMesh& mesh = mesh_.mesh();
    const labelListList& cellCells = mesh.cellCells();
    scalarField& alpha = alpha_.primitiveFieldRef();

    // All cells have the same volume
    const auto give = [&](const label from, const label to, const scalar part)
    {
        const scalar enthalpy =
            part == alpha[from] ? alphaH[from] : part*alphaH[from]/alpha[from];
        alpha[from] -= part;
        alphaH[from] -= enthalpy;
        alpha[to] += part;
        alphaH[to] += enthalpy;
        redistributed_ += mag(part)*mesh.V()[from];
    };

    const auto bounded = [&](const label celli)
    {
        return
            alpha[celli] <= 1 + dust
         && (alpha[celli] >= dust || alpha[celli] == 0);
    };

    // Rings of neighbours around the cell, nearest first: of those that flow,
    // then, in a full domain, of all
    const auto distribute = [&](const label celli, const bool toSolid)
    {
        labelHashSet seen(labelList(1, celli));
        labelList ring(1, celli);
        while (ring.size() && !bounded(celli))
        {
            DynamicList<label> next;
            for (const label c : ring)
            {
                for (const label neighbour : cellCells[c])
                {
                    if
                    (
                        (toSolid || accepts(neighbour))
                     && seen.insert(neighbour)
                    )
                    {
                        next.append(neighbour);
                    }
                }
            }
            Foam::sort(next, [&](const label a, const label b)
            {
                return alpha[a] != alpha[b] ? alpha[a] > alpha[b] : a < b;
            });
            for (const label neighbour : next)
            {
                const scalar room = 1 - alpha[neighbour];
                if (alpha[celli] > 1 && room > 0)
                {
                    give(celli, neighbour, min(alpha[celli] - 1, room));
                }
                else if
                (
                    !bounded(celli)
                 && alpha[celli] < dust
                 && alpha[neighbour] > dust - min(alpha[celli], scalar(0))
                 && alpha[neighbour] + alpha[celli] <= 1
                )
                {
                    give(celli, neighbour, alpha[celli]);
                }
            }
            ring = next;
        }
    };

    forAll(alpha, celli)
    {
        for (const bool toSolid : {false, true})
        {
            if (!bounded(celli))
            {
                distribute(celli, toSolid);
            }
        }
    }
    alpha_.correctBoundaryConditions();
}

// ************************************************************************* //
