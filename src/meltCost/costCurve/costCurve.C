/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costCurve.H"
#include "Pair.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::costCurve::costCurve(const word& method, const dictionary& dict)
:
    method_(method),
    domain_(dict.get<word>("elements") == "domain"),
    n_(dict.get<Pair<scalar>>("n")),
    error_(dict.subDict("error")),
    steps_
    (
        dict.found("steps") ? new costLaw(dict.subDict("steps")) : nullptr
    ),
    cpuTime_(dict.subDict("cpuTime"))
{
    const word elements(dict.get<word>("elements"));
    if (elements != "domain" && elements != "melt")
    {
        FatalIOErrorInFunction(dict)
            << "elements is " << elements << ", accepted: domain, melt"
            << exit(FatalIOError);
    }
    if (!(n_.min() > 0 && n_.max() >= n_.min()))
    {
        FatalIOErrorInFunction(dict)
            << "n is " << n_ << ", accepted: two numbers > 0, the least first"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::costCurve::elements
(
    const caseScales& scales,
    const scalar dx
) const
{
    return (domain_ ? scales.domainVolume : scales.meltVolume)/pow3(dx);
}


Foam::melt::costCurve::guess Foam::melt::costCurve::at
(
    const scalar n,
    const caseScales& scales
) const
{
    const scalar dx = scales.extent/n;
    const scalar own = steps_ ? scales.duration*(*steps_)(n) : 0;
    const bool ruled = own < scales.leastSteps;
    const scalar steps = ruled ? scales.leastSteps : own;
    const scalar stepSpread = ruled ? 1 : steps_->spread(n);

    return
    {
        dx,
        error_(n),
        error_.spread(n),
        error_.freedom(),
        steps,
        elements(scales, dx)*steps*cpuTime_(n),
        exp(sqrt(sqr(log(stepSpread)) + sqr(log(cpuTime_.spread(n)))))
    };
}


// ************************************************************************* //
