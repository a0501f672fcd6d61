/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ArrheniusLaw.H"
#include "checkedEntry.H"
#include "vectorMath.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(ArrheniusLaw);
    addToRunTimeSelectionTable(temperatureLaw, ArrheniusLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::ArrheniusLaw::ArrheniusLaw
(
    const dictionary& dict,
    const scalarMinMax& accepted
)
:
    reference_(dict.get<scalar>("reference")),
    TReference_
    (
        checkedEntry::get
        (
            dict, "TReference", dimTemperature, checkedEntry::positive()
        )
    ),
    Ta_(checkedEntry::get(dict, "Ta", dimTemperature, checkedEntry::any())),
    TFloor_
    (
        checkedEntry::get
        (
            dict, "TFloor", dimTemperature, checkedEntry::positive()
        )
    )
{
    checkedEntry::check(dict, "reference", reference_, accepted);

    // The ends of the law: the coldest and the hottest of temperatures
    checkedEntry::check(dict, "Ta", value(TFloor_), accepted);
    checkedEntry::check(dict, "Ta", value(VGREAT), accepted);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::ArrheniusLaw::value
(
    const label n,
    const scalar* T,
    scalar* result
) const
{
    const scalar reference = reference_;
    const scalar inverseTReference = 1/TReference_;
    const scalar Ta = Ta_;
    const scalar TFloor = TFloor_;

    const heldExceptions held;

    #pragma omp simd
    for (label i = 0; i < n; ++i)
    {
        const scalar Ti = T[i] < TFloor ? TFloor : T[i];

        result[i] = reference*::exp(Ta*(1/Ti - inverseTReference));
    }
}


// ************************************************************************* //
