/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"
#include "effectTimes.H"
#include "surfaceTension.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::melt::eulerianMethod::longestStep(word& limit) const
{
    // From rest: no faster than falling freely
    scalar dx = GREAT;
    for (int a = 0; a < 3; ++a)
    {
        if (region_.grid().solved(a))
        {
            dx = min(dx, region_.grid().d()[a]);
        }
    }
    scalar longest = sqrt(Courant_*dx/max(mag(scene_.g()), VSMALL));
    limit = "start";
    if (lastDeltaT_ > 0)
    {
        longest = growth_*lastDeltaT_;
        limit = "growth";
    }
    const scalar Courant = interface_.Courant(flow_.U(), 1);
    if (Courant*longest > Courant_)
    {
        longest = Courant_/Courant;
        limit = "Courant";
    }
    if (surfaceTension_ > 0)
    {
        const scalar capillary = capillary_*surfaceTension::capillaryTime
        (
            region_.grid(), surfaceTension_, scene_.thermo().rho()
        );
        if (capillary < longest)
        {
            longest = capillary;
            limit = "capillary";
        }
    }
    return longest;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::eulerianMethod::maxDeltaT() const
{
    word limit;
    return longestStep(limit);
}


Foam::word Foam::melt::eulerianMethod::deltaTLimit() const
{
    word limit;
    longestStep(limit);
    return limit;
}


void Foam::melt::eulerianMethod::advance(const scalar deltaT)
{
    remaining_ = deltaT;
    scalar step = deltaT;
    while (remaining_ > 0)
    {
        const scalar part = step < (1 - SMALL)*remaining_ ? step : remaining_;
        const faceVelocities U(flow_.U());
        const std::vector<double> p(flow_.p());
        {
            const effectTimes::part timing(effectTimes::flow, "momentum");
            flow(part);
        }

        // What has just melted may be faster than anything was before
        const scalar Courant = interface_.Courant(flow_.U(), part);
        if (Courant > 2*Courant_)
        {
            flow_.set(U, p);
            step = part*Courant_/Courant;
            continue;
        }
        {
            const effectTimes::part timing(effectTimes::flow, "interface");
            interfaceSteps_ =
                interface_.advance(flow_.U(), part, Courant_, alphaH_);
        }
        vents_.flow
        (
            mesh_.time().value() - remaining_ + part,
            part,
            interface_.alpha().primitiveFieldRef(),
            alphaH_
        );
        interface_.alpha().correctBoundaryConditions();
        {
            const effectTimes::part timing("heatConduction", "enthalpy");
            exchangeHeat(part);
        }
        remaining_ = part < remaining_ ? remaining_ - part : 0;
        lastDeltaT_ = step;
        step *= growth_;
        cellSteps_ += nParticles();
    }
}

// ************************************************************************* //
