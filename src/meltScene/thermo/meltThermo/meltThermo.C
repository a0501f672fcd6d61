/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltThermo.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::meltThermo::meltThermo(const dictionary& dict)
{
    using namespace checkedEntry;

    const dimensionSet dimCp(dimEnergy/dimMass/dimTemperature);
    const dimensionSet dimKappa(dimPower/dimLength/dimTemperature);

    rho_ = get(dict, "rho", dimDensity, positive());

    enthalpy_.CpSolid = get(dict, "Cp", dimCp, positive());
    enthalpy_.CpLiquid =
        getOrDefault(dict, "CpLiquid", dimCp, positive(), enthalpy_.CpSolid);

    kappaSolid_ = get(dict, "kappa", dimKappa, notNegative());
    kappaLiquid_ =
        getOrDefault(dict, "kappaLiquid", dimKappa, notNegative(), kappaSolid_);

    TMin_ = get(dict, "TMin", dimTemperature, notNegative());
    TMax_ = get(dict, "TMax", dimTemperature, scalarMinMax(TMin_, VGREAT));

    enthalpy_.solidus = get(dict, "solidus", dimTemperature, positive());
    enthalpy_.liquidus = getOrDefault
    (
        dict,
        "liquidus",
        dimTemperature,
        scalarMinMax(enthalpy_.solidus, VGREAT),
        enthalpy_.solidus
    );

    enthalpy_.latentHeat =
        getOrDefault(dict, "latentHeat", dimEnergy/dimMass, notNegative(), 0);

    surfaceTension_ = getOrDefault
    (
        dict, "surfaceTension", dimForce/dimLength, notNegative(), 0
    );
}


// ************************************************************************* //
