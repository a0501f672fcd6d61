/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "buoyancy.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::buoyancy::buoyancy(const dictionary& dict, const bool active)
:
    beta_
    (
        checkedEntry::getOrDefault
        (
            dict, "beta", dimless/dimTemperature, checkedEntry::any(), 0
        )
    ),
    TRef_
    (
        beta_ == 0
      ? 0
      : checkedEntry::get
        (
            dict, "TRef", dimTemperature, checkedEntry::notNegative()
        )
    )
{
    if (!active)
    {
        beta_ = 0;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::faceVelocities Foam::melt::buoyancy::acceleration
(
    const vector& g,
    const scalarField& alpha,
    const scalarField& T,
    const eulerianMesh& mesh
) const
{
    faceVelocities result;
    for (direction a = 0; a < 3; ++a)
    {
        result[a].assign(mesh.grid().nFaces(a), g[a]);
    }
    if (beta_ != 0)
    {
        const std::vector<double> alphaOfCell(mesh.onGrid(alpha));
        const std::vector<double> TOfCell(mesh.onGrid(T));
        const auto buoyant = [&](const int cell)
        {
            return
                alphaOfCell[cell] > VSMALL
              ? 1 - beta_*(TOfCell[cell] - TRef_) : -1;
        };
        mesh.grid().forAllFaces([&](int a, int face, int lower, int upper)
        {
            if (lower >= 0 && upper >= 0 && mesh.has(lower) && mesh.has(upper))
            {
                const scalar below = buoyant(lower), above = buoyant(upper);
                if (below >= 0 || above >= 0)
                {
                    result[a][face] *=
                        below < 0 ? above
                      : above < 0 ? below : 0.5*(below + above);
                }
            }
        });
    }
    return result;
}

// ************************************************************************* //
