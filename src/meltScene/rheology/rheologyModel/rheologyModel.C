/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rheologyModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(rheologyModel, 0);
    defineRunTimeSelectionTable(rheologyModel, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::melt::rheologyModel> Foam::melt::rheologyModel::New
(
    const dictionary& dict
)
{
    const word modelType(dict.get<word>("type"));

    const auto cstrIter = dictionaryConstructorTablePtr_->cfind(modelType);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict.lookup("type"))
            << "Unknown rheology " << modelType << nl
            << "Valid rheologies: "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return cstrIter.val()(dict.optionalSubDict(modelType + "Coeffs"));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::melt::rheologyModel::jumpNumber
(
    const scalarField& T
) const
{
    return tmp<scalarField>(new scalarField());
}


// ************************************************************************* //
