/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rateTerm.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(rateTerm, 0);
    defineRunTimeSelectionTable(rateTerm, dictionary);
}
}


Foam::autoPtr<Foam::melt::rateTerm> Foam::melt::rateTerm::New
(
    const dictionary& dict,
    sphSystem& system
)
{
    const word type(dict.get<word>("type"));
    const auto constructor = dictionaryConstructorTablePtr_->cfind(type);

    if (!constructor.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            typeName,
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return autoPtr<rateTerm>(constructor()(dict, system));
}

// ************************************************************************* //
