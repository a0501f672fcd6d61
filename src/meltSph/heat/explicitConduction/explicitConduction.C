/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitConduction.H"
#include "addToRunTimeSelectionTable.H"
#include "conductivity.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(explicitConduction, 0);
    addToRunTimeSelectionTable(rateTerm, explicitConduction, dictionary);
}
}


Foam::melt::explicitConduction::explicitConduction
(
    const dictionary&,
    sphSystem& system
)
:
    rateTerm(system),
    scale_(system.near.kernel(), system.spacing)
{
    system_.pairs.conduction = true;
    system_.pairs.kappa = system_.thermo.kappaSolid();
    system_.pairs.spacing = system_.spacing;
}


void Foam::melt::explicitConduction::allocate()
{
    particles& f = system_.fluid;
    f.require({&f.dH, &f.conductionScale});
    if (!uniformConductivity(system_.thermo))
    {
        f.require({&f.kappa});
    }
}


void Foam::melt::explicitConduction::prepare()
{
    if (!system_.fluid.kappa.empty())
    {
        setConductivity(system_.thermo, system_.fluid);
    }
    scale_.update
    (
        system_.near, system_.walls, system_.pairs.kappa, system_.fluid
    );
}


void Foam::melt::explicitConduction::limit(timeStepControl& control) const
{
    const double h = system_.near.kernel().h();
    const enthalpyCurve& curve = system_.thermo.enthalpy();
    const double kappa =
        scale_.inside()
       *max(system_.thermo.kappaSolid(), system_.thermo.kappaLiquid());
    const double Cp = min(curve.CpSolid, curve.CpLiquid);

    control.limit("thermal", h*h*system_.thermo.rho()*Cp/kappa);
}

// ************************************************************************* //
