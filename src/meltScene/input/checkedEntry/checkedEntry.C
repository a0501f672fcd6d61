/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkedEntry.H"
#include "dimensionedScalar.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarMinMax Foam::melt::checkedEntry::positive()
{
    return scalarMinMax(VSMALL, VGREAT);
}


Foam::scalarMinMax Foam::melt::checkedEntry::notNegative()
{
    return scalarMinMax(0, VGREAT);
}


Foam::scalarMinMax Foam::melt::checkedEntry::any()
{
    return scalarMinMax(-VGREAT, VGREAT);
}


Foam::scalarMinMax Foam::melt::checkedEntry::positiveUpTo(const scalar highest)
{
    return scalarMinMax(VSMALL, highest);
}


Foam::string Foam::melt::checkedEntry::accepted(const scalarMinMax& range)
{
    OStringStream os;
    os  << "a finite number";

    if (range.min() == VSMALL)
    {
        os  << " > 0";
    }
    else if (range.min() > -VGREAT)
    {
        os  << " >= " << range.min();
    }

    if (range.max() < VGREAT)
    {
        os  << (range.min() > -VGREAT ? " and" : "") << " <= " << range.max();
    }

    return os.str();
}


void Foam::melt::checkedEntry::check
(
    const dictionary& dict,
    const word& keyword,
    const scalar value,
    const scalarMinMax& range
)
{
    // Written so that NaN fails
    if (!(value >= range.min() && value <= range.max()))
    {
        FatalIOErrorInFunction(dict.lookup(keyword))
            << "Entry " << keyword << " = " << value << " is not accepted: "
            << accepted(range).c_str() << " is expected."
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::melt::checkedEntry::get
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dimensions,
    const scalarMinMax& range
)
{
    const scalar value = dimensionedScalar(keyword, dimensions, dict).value();

    check(dict, keyword, value, range);

    return value;
}


Foam::scalar Foam::melt::checkedEntry::getOrDefault
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dimensions,
    const scalarMinMax& range,
    const scalar defaultValue
)
{
    return
        dict.found(keyword)
      ? get(dict, keyword, dimensions, range)
      : defaultValue;
}


// ************************************************************************* //
