/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitConduction.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(explicitConduction, 0);
    addToRunTimeSelectionTable(rateTerm, explicitConduction, dictionary);
}
}


bool Foam::melt::explicitConduction::uniform() const
{
    return system_.thermo.kappaSolid() == system_.thermo.kappaLiquid();
}


Foam::melt::explicitConduction::explicitConduction
(
    const dictionary&,
    sphSystem& system
)
:
    rateTerm(system)
{
    system_.pairs.conduction = true;
    system_.pairs.kappa = system_.thermo.kappaSolid();
    system_.pairs.spacing = system_.spacing;
}


void Foam::melt::explicitConduction::allocate()
{
    particles& f = system_.fluid;
    f.require({&f.dH});
    if (!uniform())
    {
        f.require({&f.kappa});
    }
}


void Foam::melt::explicitConduction::prepare()
{
    if (uniform())
    {
        return;
    }

    particles& f = system_.fluid;
    const int n = f.size();
    const enthalpyCurve curve = system_.thermo.enthalpy();
    const double solid = system_.thermo.kappaSolid();
    const double liquid = system_.thermo.kappaLiquid();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.kappa[i] = solid + (liquid - solid)*curve.liquidFraction(f.h[i]);
    }
}


void Foam::melt::explicitConduction::limit(timeStepControl& control) const
{
    const double h = system_.near.kernel().h();
    const enthalpyCurve& curve = system_.thermo.enthalpy();
    const double kappa =
        max(system_.thermo.kappaSolid(), system_.thermo.kappaLiquid());
    const double Cp = min(curve.CpSolid, curve.CpLiquid);

    control.limit("thermal", h*h*system_.thermo.rho()*Cp/kappa);
}

// ************************************************************************* //
