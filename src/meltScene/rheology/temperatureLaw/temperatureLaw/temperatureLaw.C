/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "temperatureLaw.H"
#include "constantLaw.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(temperatureLaw);
    defineRunTimeSelectionTable(temperatureLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::melt::temperatureLaw> Foam::melt::temperatureLaw::New
(
    const word& keyword,
    const dictionary& dict,
    const scalarMinMax& accepted
)
{
    if (!dict.isDict(keyword))
    {
        const scalar value = dict.get<scalar>(keyword);
        checkedEntry::check(dict, keyword, value, accepted);

        return autoPtr<temperatureLaw>(new constantLaw(value));
    }

    const dictionary& lawDict = dict.subDict(keyword);
    const word lawType(lawDict.get<word>("type"));

    const auto cstrIter = dictionaryConstructorTablePtr_->cfind(lawType);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(lawDict.lookup("type"))
            << "Unknown temperature law " << lawType << " of " << keyword
            << nl << "Valid laws: a number, or "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return cstrIter.val()(lawDict, accepted);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarMinMax Foam::melt::temperatureLaw::range
(
    const scalar TMin,
    const scalar TMax
) const
{
    scalarMinMax result(value(TMin));
    result.add(value(TMax));

    return result;
}


Foam::scalar Foam::melt::temperatureLaw::value(const scalar T) const
{
    scalar result;
    value(1, &T, &result);

    return result;
}


// ************************************************************************* //
