/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "initialTemperature.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(initialTemperature);
    defineRunTimeSelectionTable(initialTemperature, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::melt::initialTemperature>
Foam::melt::initialTemperature::New
(
    const dictionary& dict,
    const shape& body
)
{
    const word lawType(dict.get<word>("type"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(lawType);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict.lookup("type"))
            << "Entry 'type' of the initial temperature is " << lawType
            << "; accepted are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return cstrIter()(dict, body);
}


// ************************************************************************* //
