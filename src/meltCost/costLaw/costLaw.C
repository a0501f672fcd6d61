/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costLaw.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::costLaw::costLaw
(
    const scalar factor,
    const scalar exponent,
    const scalar spread,
    const scalar points,
    const scalar centre,
    const scalar variation
)
:
    factor_(factor),
    exponent_(exponent),
    spread_(spread),
    points_(points),
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
    const label freedom = max(label(1), n - (sloped ? 2 : 1));

    return costLaw
    (
        exp(logA),
        b,
        exp(2*sqrt(residual/freedom)),
        n,
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
    dict.add("centre", centre_);
    dict.add("variation", variation_);
    return dict;
}


// ************************************************************************* //
