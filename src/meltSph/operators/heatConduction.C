/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatConduction.H"
#include "blockSum.H"
#include "conductionLaw.H"

double Foam::melt::heatConduction
(
    const neighbourhood& near,
    const wallState& walls,
    const double uniformKappa,
    const double spacing,
    particles& f
)
{
    std::vector<double> fromWalls(f.size());

    if (f.kappa.empty())
    {
        pairPass
        (
            near, walls, f,
            conductionLaw<true>
            (
                f, walls, uniformKappa, spacing, fromWalls.data()
            )
        );
    }
    else
    {
        pairPass
        (
            near, walls, f,
            conductionLaw<false>
            (
                f, walls, uniformKappa, spacing, fromWalls.data()
            )
        );
    }

    return blockSum
    (
        f.size(),
        [&](const int i) { return fromWalls[i]; }
    );
}

// ************************************************************************* //
