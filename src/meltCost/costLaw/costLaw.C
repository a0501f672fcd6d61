/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costLaw.H"
#include "checkedEntry.H"
#include "FixedList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Student's t of 97.5 % for degrees of freedom >= 1. M. Abramowitz, I. A.
//  Stegun, Handbook of mathematical functions, 1964, table 26.10; beyond it
//  equation 26.7.5, whose error is below 0.1 %
scalar studentT(const label freedom)
{
    static const FixedList<scalar, 10> table
    ({
        12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228
    });
    if (freedom <= table.size())
    {
        return table[freedom - 1];
    }
    const scalar z = 1.959964;
    return
        z
      + (pow3(z) + z)/(4*freedom)
      + (5*pow5(z) + 16*pow3(z) + 3*z)/(96*sqr(scalar(freedom)));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::costLaw::costLaw
(
    const scalar factor,
    const scalar exponent,
    const scalar spread,
    const scalar points,
    const scalar freedom,
    const scalar centre,
    const scalar variation
)
:
    factor_(factor),
    exponent_(exponent),
    spread_(spread),
    points_(points),
    freedom_(freedom),
    centre_(centre),
    variation_(variation)
{}


Foam::melt::costLaw::costLaw(const dictionary& dict)
:
    factor_
    (
        checkedEntry::get(dict, "factor", dimless, checkedEntry::positive())
    ),
    exponent_
    (
        checkedEntry::get(dict, "exponent", dimless, checkedEntry::any())
    ),
    spread_
    (
        checkedEntry::get(dict, "spread", dimless, scalarMinMax(1, GREAT))
    ),
    points_
    (
        checkedEntry::get(dict, "points", dimless, checkedEntry::positive())
    ),
    freedom_
    (
        checkedEntry::get(dict, "freedom", dimless, checkedEntry::notNegative())
    ),
    centre_
    (
        checkedEntry::get(dict, "centre", dimless, checkedEntry::positive())
    ),
    variation_
    (
        checkedEntry::get
        (
            dict, "variation", dimless, checkedEntry::notNegative()
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::costLaw Foam::melt::costLaw::fit
(
    const UList<scalar>& x,
    const UList<scalar>& y,
    const scalarMinMax& exponents
)
{
    const label n = x.size();
    scalar meanX = 0;
    scalar meanY = 0;

    forAll(x, i)
    {
        if (!(x[i] > 0 && y[i] > 0))
        {
            FatalErrorInFunction
                << "Point (" << x[i] << ' ' << y[i] << ") of a power law"
                << nl << "Accepted: numbers > 0" << exit(FatalError);
        }
        meanX += log(x[i])/n;
        meanY += log(y[i])/n;
    }

    scalar sumXX = 0;
    scalar sumXY = 0;
    forAll(x, i)
    {
        sumXX += sqr(log(x[i]) - meanX);
        sumXY += (log(x[i]) - meanX)*(log(y[i]) - meanY);
    }

    const bool sloped = sumXX > n*SMALL;
    const scalar b = exponents.clip(sloped ? sumXY/sumXX : 0);
    const scalar logA = meanY - b*meanX;

    scalar residual = 0;
    forAll(x, i)
    {
        residual += sqr(log(y[i]) - logA - b*log(x[i]));
    }
    const label freedom = n - (sloped ? 2 : 1);

    return costLaw
    (
        exp(logA),
        b,
        freedom
      ? min(exp(studentT(freedom)*sqrt(residual/freedom)), GREAT)
      : GREAT,
        n,
        freedom,
        exp(meanX),
        sloped ? sumXX : 0
    );
}


Foam::scalar Foam::melt::costLaw::spread(const scalar x) const
{
    const scalar away =
        variation_ > 0 ? sqr(log(x/centre_))/variation_ : 0;
    return pow(spread_, sqrt(1 + 1/points_ + away));
}


Foam::dictionary Foam::melt::costLaw::dict() const
{
    dictionary dict;
    dict.add("factor", factor_);
    dict.add("exponent", exponent_);
    dict.add("spread", spread_);
    dict.add("points", points_);
    dict.add("freedom", freedom_);
    dict.add("centre", centre_);
    dict.add("variation", variation_);
    return dict;
}


// ************************************************************************* //
