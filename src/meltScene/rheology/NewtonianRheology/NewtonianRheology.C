/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "NewtonianRheology.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(NewtonianRheology, 0);
    addToRunTimeSelectionTable(rheologyModel, NewtonianRheology, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::NewtonianRheology::NewtonianRheology(const dictionary& dict)
:
    eta_(temperatureLaw::New("eta", dict, checkedEntry::positive()))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::NewtonianRheology::eta
(
    const label n,
    const scalar* shearRate,
    const scalar* T,
    scalar* eta
) const
{
    eta_->value(n, T, eta);
}


Foam::scalar Foam::melt::NewtonianRheology::etaMax
(
    const scalar TMin,
    const scalar TMax
) const
{
    return eta_->range(TMin, TMax).max();
}


// ************************************************************************* //
