/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocityGradient.H"
#include "gradientLaw.H"

void Foam::melt::velocityGradient
(
    const neighbourhood& near,
    const wallState& walls,
    particles& f,
    const bool deformation
)
{
    forcePass
    (
        near,
        walls,
        f,
        gradientLaw(f, walls, near.kernel().dimensions(), deformation)
    );
}

// ************************************************************************* //
