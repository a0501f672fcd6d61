/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "artificialViscosityTerm.H"
#include "addToRunTimeSelectionTable.H"
#include "artificialViscosity.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(artificialViscosityTerm, 0);
    addToRunTimeSelectionTable(rateTerm, artificialViscosityTerm, dictionary);
}
}


Foam::melt::artificialViscosityTerm::artificialViscosityTerm
(
    const dictionary& dict,
    sphSystem& system
)
:
    rateTerm(system),
    alpha_
    (
        checkedEntry::get(dict, "alpha", dimless, checkedEntry::notNegative())
    ),
    beta_
    (
        checkedEntry::get(dict, "beta", dimless, checkedEntry::notNegative())
    )
{}


void Foam::melt::artificialViscosityTerm::addRates()
{
    addArtificialViscosity
    (
        system_.near, alpha_, beta_, system_.soundSpeed, system_.fluid
    );
}

// ************************************************************************* //
