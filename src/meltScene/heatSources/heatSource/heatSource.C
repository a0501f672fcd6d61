/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatSource.H"
#include "checkedEntry.H"

namespace Foam
{
namespace melt
{
    defineTypeName(heatSource);
    defineRunTimeSelectionTable(heatSource, dictionary);
}
}

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::melt::heatSource::notNegative
(
    const Function1<scalar>& function,
    const scalar time
) const
{
    const scalar value = function.value(time);
    checkedEntry::check
    (
        dict_, function.name(), value, checkedEntry::notNegative()
    );
    return value;
}


Foam::autoPtr<Foam::Function1<Foam::scalar>>
Foam::melt::heatSource::function(const word& keyword) const
{
    autoPtr<Function1<scalar>> result(Function1<scalar>::New(keyword, dict_));
    notNegative(*result, 0);
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::heatSource::heatSource(const word& name, const dictionary& dict)
:
    name_(name),
    dict_(dict),
    active_(dict.lookupOrDefault<bool>("active", true))
{}


Foam::autoPtr<Foam::melt::heatSource> Foam::melt::heatSource::New
(
    const word& name,
    const dictionary& dict
)
{
    const word type(dict.get<word>("type"));
    auto constructor = dictionaryConstructorTablePtr_->cfind(type);

    if (!constructor.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown type " << type << " of heat source " << name << nl
            << "Valid types: "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }
    return constructor()(name, dict);
}

// ************************************************************************* //
