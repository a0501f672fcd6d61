/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltInterface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Less melt than this in a cell goes to the neighbours [-]
const Foam::scalar dust = 1e-9;

// A cell may give to its neighbours' neighbours, and so on, this far
const Foam::label maxRings = 20;

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

    forAll(alpha, celli)
    {
        if (alpha[celli] <= 1 && (alpha[celli] >= dust || alpha[celli] == 0))
        {
            continue;
        }

        // Rings of neighbours around the cell, nearest first
        labelHashSet seen(labelList(1, celli));
        labelList ring(1, celli);
        for (label i = 0; i < maxRings && ring.size(); ++i)
        {
            DynamicList<label> next;
            for (const label c : ring)
            {
                for (const label neighbour : cellCells[c])
                {
                    if (accepts(neighbour) && seen.insert(neighbour))
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
                    alpha[celli] < dust
                 && alpha[celli] != 0
                 && alpha[neighbour] > dust - min(alpha[celli], scalar(0))
                 && alpha[neighbour] + alpha[celli] <= 1
                )
                {
                    give(celli, neighbour, alpha[celli]);
                }
            }
            if
            (
                alpha[celli] <= 1
             && (alpha[celli] >= dust || alpha[celli] == 0)
            )
            {
                break;
            }
            ring = next;
        }
    }
    alpha_.correctBoundaryConditions();
}

// ************************************************************************* //
