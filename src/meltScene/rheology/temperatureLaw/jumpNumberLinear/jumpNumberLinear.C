/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "jumpNumberLinear.H"
#include "checkedEntry.H"
#include "vectorMath.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(jumpNumberLinear);
    addToRunTimeSelectionTable(temperatureLaw, jumpNumberLinear, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::jumpNumberLinear::jumpNumberLinear
(
    const dictionary& dict,
    const scalarMinMax& accepted
)
:
    TMin_(checkedEntry::get(dict, "TMin", dimTemperature, checkedEntry::any())),
    TMax_(checkedEntry::get(dict, "TMax", dimTemperature, checkedEntry::any())),
    atTMin_(dict.get<scalar>("atTMin")),
    atTMax_(dict.get<scalar>("atTMax"))
{
    checkedEntry::check(dict, "atTMin", atTMin_, accepted);
    checkedEntry::check(dict, "atTMax", atTMax_, accepted);
    checkedEntry::check
    (
        dict,
        "TMax",
        TMax_,
        scalarMinMax(std::nextafter(TMin_, VGREAT), VGREAT)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::jumpNumberLinear::value
(
    const label n,
    const scalar* T,
    scalar* result
) const
{
    const scalar TMin = TMin_;
    const scalar width = TMax_ - TMin_;
    const scalar low = atTMin_;
    const scalar high = atTMax_;

    const heldExceptions held;

    #pragma omp simd
    for (label i = 0; i < n; ++i)
    {
        const scalar v = (T[i] - TMin)/width;
        const scalar u = v < 0 ? 0 : v > 1 ? 1 : v;

        result[i] = (1 - u)*low + u*high;
    }
}


// ************************************************************************* //
