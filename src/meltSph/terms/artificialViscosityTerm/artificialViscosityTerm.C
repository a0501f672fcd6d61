/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "artificialViscosityTerm.H"
#include "addToRunTimeSelectionTable.H"
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
    rateTerm(system)
{
    const scalarMinMax notNegative(checkedEntry::notNegative());

    system_.pairs.artificialViscosity = true;
    system_.pairs.alphaC =
        checkedEntry::get(dict, "alpha", dimless, notNegative)
       *system_.soundSpeed;
    system_.pairs.beta = checkedEntry::get(dict, "beta", dimless, notNegative);
}

// ************************************************************************* //
