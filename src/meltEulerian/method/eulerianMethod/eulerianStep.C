/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"
#include "effectTimes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::melt::eulerianMethod::leastEdge() const
{
    scalar dx = GREAT;
    for (int a = 0; a < 3; ++a)
    {
        if (region_.grid().solved(a))
        {
            dx = min(dx, region_.grid().d()[a]);
        }
    }
    return dx;
}


Foam::melt::eulerianTimeStep::motion
Foam::melt::eulerianMethod::motion(const scalar acceleration) const
{
    return {interface_.Courant(flow_.U(), 1), acceleration};
}


Foam::scalar Foam::melt::eulerianMethod::longestStep(word& limit) const
{
    return timeStep_.longest(lastDeltaT_, motion(lastAcceleration_), limit);
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

        // What has just melted, or was let go, may be faster than anything was
        // before
        const scalar accepted =
            timeStep_.accepted(part, motion(flowRecord_.acceleration));
        if (accepted < part)
        {
            flow_.set(U, p);
            step = accepted;
            continue;
        }
        {
            const effectTimes::part timing(effectTimes::flow, "interface");
            interfaceSteps_ =
                interface_.advance
                (
                    flow_.U(), part, timeStep_.Courant(), alphaH_
                );
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
        lastAcceleration_ = flowRecord_.acceleration;
        step = maxDeltaT();
        cellSteps_ += nParticles();
    }
}

// ************************************************************************* //
