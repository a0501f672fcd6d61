/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "buoyancy.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::buoyancy::buoyancy(const dictionary& dict)
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
{}


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
        const auto buoyant = [&](const label celli)
        {
            return
                alpha[celli] > VSMALL ? 1 - beta_*(T[celli] - TRef_) : -1;
        };
        const fvMesh& fv = mesh.mesh();
        forAll(fv.neighbour(), facei)
        {
            const scalar own = buoyant(fv.owner()[facei]);
            const scalar nei = buoyant(fv.neighbour()[facei]);
            if (own >= 0 || nei >= 0)
            {
                const eulerianMesh::gridFace& f = mesh.onGrid(facei);
                result[f.direction][f.face] *=
                    own < 0 ? nei : nei < 0 ? own : 0.5*(own + nei);
            }
        }
    }
    return result;
}

// ************************************************************************* //
