/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conductivity.H"

void Foam::melt::setConductivity(const meltThermo& thermo, particles& f)
{
    const int n = f.size();
    const enthalpyCurve curve = thermo.enthalpy();
    const double solid = thermo.kappaSolid();
    const double liquid = thermo.kappaLiquid();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.kappa[i] = solid + (liquid - solid)*curve.liquidFraction(f.h[i]);
    }
}

// ************************************************************************* //
