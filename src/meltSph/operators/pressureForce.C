/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pressureForce.H"
#include "pressureLaw.H"

void Foam::melt::addPressureForce
(
    const neighbourhood& near,
    const wallState& walls,
    particles& f
)
{
    pairPass(near, walls, f, pressureLaw(f, walls));
}

// ************************************************************************* //
