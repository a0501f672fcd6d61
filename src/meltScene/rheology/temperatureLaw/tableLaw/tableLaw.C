/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableLaw.H"
#include "checkedEntry.H"
#include "vectorMath.H"
#include "Function1.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(tableLaw);
    addToRunTimeSelectionTable(temperatureLaw, tableLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::tableLaw::tableLaw
(
    const dictionary& dict,
    const scalarMinMax& accepted
)
:
    TMin_(checkedEntry::get(dict, "TMin", dimTemperature, checkedEntry::any())),
    TMax_(checkedEntry::get(dict, "TMax", dimTemperature, checkedEntry::any())),
    values_
    (
        dict.getCheckOrDefault<label>("nPoints", 1001, labelMinMax::ge(2))
    )
{
    checkedEntry::check
    (
        dict,
        "TMax",
        TMax_,
        scalarMinMax(std::nextafter(TMin_, VGREAT), VGREAT)
    );

    const autoPtr<Function1<scalar>> function
    (
        Function1<scalar>::New("values", dict)
    );

    const label last = values_.size() - 1;

    forAll(values_, i)
    {
        values_[i] = function->value(TMin_ + (TMax_ - TMin_)*i/last);
        checkedEntry::check(dict, "values", values_[i], accepted);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::tableLaw::value
(
    const label n,
    const scalar* T,
    scalar* result
) const
{
    const scalar* values = values_.cdata();
    const label last = values_.size() - 1;
    const scalar TMin = TMin_;
    const scalar step = (TMax_ - TMin_)/last;

    const heldExceptions held;

    #pragma omp simd
    for (label i = 0; i < n; ++i)
    {
        const scalar v = (T[i] - TMin)/step;
        const scalar u = v < 0 ? 0 : v > last ? last : v;

        // NaN has no place in the table but keeps its weight
        const label j = u < last ? label(u) : last - 1;
        const scalar weight = u - j;

        result[i] = (1 - weight)*values[j] + weight*values[j + 1];
    }
}


Foam::scalarMinMax Foam::melt::tableLaw::range
(
    const scalar TMin,
    const scalar TMax
) const
{
    scalarMinMax result(temperatureLaw::range(TMin, TMax));

    const label last = values_.size() - 1;

    forAll(values_, i)
    {
        const scalar T = TMin_ + (TMax_ - TMin_)*i/last;

        if (T > TMin && T < TMax)
        {
            result.add(values_[i]);
        }
    }

    return result;
}


// ************************************************************************* //
