/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscousOperator.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(viscousOperator, 0);
    defineRunTimeSelectionTable(viscousOperator, dictionary);
}
}


Foam::autoPtr<Foam::melt::viscousOperator> Foam::melt::viscousOperator::New
(
    const dictionary& dict,
    const sphSystem& system
)
{
    const word type(dict.get<word>("operator"));
    const auto constructor = dictionaryConstructorTablePtr_->cfind(type);

    if (!constructor.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            "operator",
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return autoPtr<viscousOperator>(constructor()(dict, system));
}

// ************************************************************************* //
