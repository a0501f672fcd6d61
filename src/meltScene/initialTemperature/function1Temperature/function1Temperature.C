/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "function1Temperature.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(function1Temperature);
    addToRunTimeSelectionTable
    (
        initialTemperature,
        function1Temperature,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::function1Temperature::function1Temperature
(
    const dictionary& dict,
    const shape&
)
:
    dict_(dict),
    direction_(dict.get<vector>("direction")),
    origin_(dict.lookupOrDefault<point>("origin", Zero)),
    value_(Function1<scalar>::New("value", dict))
{
    if (!(mag(direction_) > 0))
    {
        FatalIOErrorInFunction(dict.lookup("direction"))
            << "Entry 'direction' is " << direction_
            << "; accepted is a vector that is not zero" << exit(FatalIOError);
    }
    direction_.normalise();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::melt::function1Temperature::value
(
    const pointField& points
) const
{
    const scalarField coordinate(direction_ & (points - origin_));
    tmp<scalarField> T(value_->value(coordinate));

    for (const scalar Ti : T())
    {
        checkedEntry::check(dict_, "value", Ti, checkedEntry::notNegative());
    }

    return T;
}


// ************************************************************************* //
