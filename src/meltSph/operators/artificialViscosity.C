/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "artificialViscosity.H"
#include "artificialViscosityLaw.H"

void Foam::melt::addArtificialViscosity
(
    const neighbourhood& near,
    const double alpha,
    const double beta,
    const double soundSpeed,
    particles& f
)
{
    pairPass
    (
        near,
        wallState(),
        f,
        artificialViscosityLaw(f, near.kernel().h(), alpha*soundSpeed, beta)
    );
}

// ************************************************************************* //
