/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "jumpNumberLogarithmic.H"
#include "checkedEntry.H"
#include "vectorMath.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(jumpNumberLogarithmic);
    addToRunTimeSelectionTable
    (
        temperatureLaw,
        jumpNumberLogarithmic,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::jumpNumberLogarithmic::jumpNumberLogarithmic
(
    const dictionary& dict,
    const scalarMinMax& accepted
)
:
    TMin_(checkedEntry::get(dict, "TMin", dimTemperature, checkedEntry::any())),
    TMax_(checkedEntry::get(dict, "TMax", dimTemperature, checkedEntry::any())),
    logAtTMin_(std::log1p(dict.get<scalar>("atTMin"))),
    logAtTMax_(std::log1p(dict.get<scalar>("atTMax")))
{
    scalarMinMax range(accepted);
    range.min() = max(range.min(), scalar(0));

    for (const char* end : {"atTMin", "atTMax"})
    {
        checkedEntry::check(dict, end, dict.get<scalar>(end), range);
    }

    checkedEntry::check
    (
        dict,
        "TMax",
        TMax_,
        scalarMinMax(std::nextafter(TMin_, VGREAT), VGREAT)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::jumpNumberLogarithmic::value
(
    const label n,
    const scalar* T,
    scalar* result
) const
{
    const scalar TMin = TMin_;
    const scalar width = TMax_ - TMin_;
    const scalar low = logAtTMin_;
    const scalar high = logAtTMax_;

    const heldExceptions held;

    #pragma omp simd
    for (label i = 0; i < n; ++i)
    {
        const scalar v = (T[i] - TMin)/width;
        const scalar u = v < 0 ? 0 : v > 1 ? 1 : v;

        result[i] = ::expm1((1 - u)*low + u*high);
    }
}


// ************************************************************************* //
