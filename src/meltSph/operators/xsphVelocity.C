/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "xsphVelocity.H"
#include "xsphLaw.H"

void Foam::melt::xsphVelocity
(
    const neighbourhood& near,
    const double epsilon,
    particles& f
)
{
    pairPass(near, wallState(), f, xsphLaw(f, epsilon));
}

// ************************************************************************* //
