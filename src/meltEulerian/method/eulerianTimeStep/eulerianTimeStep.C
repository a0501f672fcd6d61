/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianTimeStep.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

scalar coefficient
(
    const dictionary& dict,
    const word& name,
    const scalarMinMax& accepted,
    const scalar defaultValue
)
{
    return melt::checkedEntry::getOrDefault
    (
        dict, name, dimless, accepted, defaultValue
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::melt::eulerianTimeStep::ofMotion
(
    const motion& m,
    word& limit
) const
{
    const scalar Courant = Courant_/max(m.Courant, VSMALL);
    const scalar share = min(m.acceleration/max(g_, VSMALL), scalar(1));
    const scalar force =
        force_*sqrt(dx_/max(g_, VSMALL))/max(share, VSMALL);
    limit = force < Courant ? "force" : "Courant";
    return min(Courant, force);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::eulerianTimeStep::eulerianTimeStep
(
    const dictionary& dict,
    const scalar dx,
    const scalar g,
    const scalar capillaryTime
)
:
    Courant_
    (
        coefficient(dict, "Courant", checkedEntry::positiveUpTo(0.5), 0.4)
    ),
    growth_
    (
        coefficient(dict, "growth", scalarMinMax(1 + SMALL, GREAT), 2)
    ),
    force_(coefficient(dict, "force", checkedEntry::positive(), 0.05)),
    capillary_
    (
        coefficient(dict, "capillary", checkedEntry::positiveUpTo(0.8), 0.5)
    ),
    dx_(dx),
    g_(g),
    capillaryTime_(capillaryTime)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::eulerianTimeStep::longest
(
    const scalar lastDeltaT,
    const motion& last,
    word& limit
) const
{
    scalar longest = growth_*lastDeltaT;
    limit = "growth";
    if (lastDeltaT <= 0)
    {
        longest = sqrt(Courant_*dx_/max(g_, VSMALL));
        limit = "start";
    }

    const auto shorten = [&](const scalar deltaT, const word& name)
    {
        if (deltaT < longest)
        {
            longest = deltaT;
            limit = name;
        }
    };
    word name;
    const scalar allowed = ofMotion(last, name);
    shorten(allowed, name);
    shorten(capillary_*capillaryTime_, "capillary");
    return longest;
}


Foam::scalar Foam::melt::eulerianTimeStep::accepted
(
    const scalar deltaT,
    const motion& m
) const
{
    word limit;
    const scalar allowed = ofMotion(m, limit);
    return deltaT > 2*allowed ? allowed : deltaT;
}

// ************************************************************************* //
