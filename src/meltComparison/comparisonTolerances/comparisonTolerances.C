/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "comparisonTolerances.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::melt::comparisonTolerances::shapeQuantities
({
    "intersectionOverUnion",
    "TL2",
    "TMax",
    "meanDistance",
    "HausdorffDistance"
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::comparisonTolerances::check
(
    const dictionary& dict,
    const wordList& columns
)
{
    for (const entry& e : dict)
    {
        if (e.isDict())
        {
            continue;
        }
        if (!shapeQuantities.found(e.keyword()) && !columns.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown tolerance " << e.keyword() << nl
                << "Accepted: " << shapeQuantities
                << " and the columns of the diagnostics, " << columns
                << exit(FatalIOError);
        }
        // Units are those of the quantity
        checkedEntry::check
        (
            dict,
            e.keyword(),
            dict.get<scalar>(e.keyword()),
            checkedEntry::notNegative()
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::comparisonTolerances::comparisonTolerances
(
    const dictionary& dict,
    const wordList& columns
)
:
    dict_(dict)
{
    check(dict_, columns);
    for (const entry& e : dict_)
    {
        if (e.isDict())
        {
            check(e.dict(), columns);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::comparisonTolerances::found
(
    const word& quantity,
    const Pair<word>& methods
) const
{
    return
        dict_.found(quantity)
     || dict_.subOrEmptyDict(methods.first()).found(quantity)
     || dict_.subOrEmptyDict(methods.second()).found(quantity);
}


Foam::scalar Foam::melt::comparisonTolerances::value
(
    const word& quantity,
    const Pair<word>& methods
) const
{
    scalar loosest = 0;
    bool ofMethod = false;
    for (const word& method : methods)
    {
        const dictionary& dict = dict_.subOrEmptyDict(method);
        if (dict.found(quantity))
        {
            const scalar own = dict.get<scalar>(quantity);
            loosest =
                !ofMethod ? own
              : greaterIsBetter(quantity) ? min(loosest, own)
              : max(loosest, own);
            ofMethod = true;
        }
    }
    return ofMethod ? loosest : dict_.get<scalar>(quantity);
}


bool Foam::melt::comparisonTolerances::holds
(
    const word& quantity,
    const scalar value,
    const Pair<word>& methods
) const
{
    if (!found(quantity, methods))
    {
        return true;
    }

    // Written so that NaN fails
    const scalar tolerance = this->value(quantity, methods);
    return
        greaterIsBetter(quantity) ? value >= tolerance : value <= tolerance;
}


// ************************************************************************* //
