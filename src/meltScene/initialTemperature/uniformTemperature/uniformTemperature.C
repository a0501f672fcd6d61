/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "uniformTemperature.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(uniformTemperature);
    addToRunTimeSelectionTable
    (
        initialTemperature,
        uniformTemperature,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::uniformTemperature::uniformTemperature
(
    const dictionary& dict,
    const shape&
)
:
    value_
    (
        checkedEntry::get
        (
            dict,
            "value",
            dimTemperature,
            checkedEntry::notNegative()
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::melt::uniformTemperature::value
(
    const pointField& points
) const
{
    return tmp<scalarField>::New(points.size(), value_);
}


// ************************************************************************* //
