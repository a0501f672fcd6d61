/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stressDivergence.H"
#include "stressLaw.H"

void Foam::melt::addStressDivergence
(
    const neighbourhood& near,
    const wallState& walls,
    particles& f
)
{
    pairPass(near, walls, f, stressLaw(f, walls));
}

// ************************************************************************* //
