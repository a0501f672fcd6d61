/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompressible.H"
#include "addToRunTimeSelectionTable.H"
#include "blockSum.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "wallContact.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(incompressible, 0);
    addToRunTimeSelectionTable(sphScheme, incompressible, dictionary);
}
}


Foam::melt::incompressible::incompressible
(
    const dictionary& dict,
    const effectSwitches& effects,
    sphSystem& system
)
:
    sphScheme(dict, effects, system),
    kick_(system_, equations_)
{
    if (!equations_.implicit() || system_.pairs.pressure)
    {
        FatalIOErrorInFunction(dict)
            << "The scheme incompressible takes pressure { type"
            << " implicitPressure; ... } and viscosity { type"
            << " implicitViscosity; ... }"
            << exit(FatalIOError);
    }
    implicitness_ = checkedEntry::getOrDefault
    (
        dict, "implicitness", dimless, scalarMinMax(0.5, 1), 0.7
    );
    if (effects("XSPH") && dict.found("XSPH"))
    {
        FatalIOErrorInFunction(dict.subDict("XSPH"))
            << "The scheme incompressible moves particles by their velocities"
            << " alone: XSPH goes with the schemes leapFrog and semiImplicit"
            << exit(FatalIOError);
    }
}


Foam::word Foam::melt::incompressible::fault(const scalar deltaT)
{
    const particles& f = system_.fluid;
    const double maxA2 = parallelMax
    (
        f.size(),
        [&](const int i)
        {
            return f.ax[i]*f.ax[i] + f.ay[i]*f.ay[i] + f.az[i]*f.az[i];
        }
    );
    if (!std::isfinite(maxA2))
    {
        return "a velocity is not a number";
    }

    // Twice the limit: the step was chosen by the state before
    const timeStepControl& limits = equations_.limits();
    return deltaT > 2*limits.deltaT() ? limits.ruling() + " limit" : word();
}


void Foam::melt::incompressible::keepState()
{
    particles& f = system_.fluid;
    f.axOld = f.ax;
    f.ayOld = f.ay;
    f.azOld = f.az;
}


void Foam::melt::incompressible::restoreState()
{
    particles& f = system_.fluid;
    kick_.takeBack();
    f.ax = f.axOld;
    f.ay = f.ayOld;
    f.az = f.azOld;
}


void Foam::melt::incompressible::changeDensity(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();

    equations_.setDensityRate();
    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.rho[i] += dt*f.dRho[i];
    }
}


Foam::word Foam::melt::incompressible::kick(const scalar dt)
{
    keepState();
    equations_.evaluate();
    // What has just become part of a solid moves with it now
    kick_.begin();
    changeDensity(dt/2);
    // What pressure has not resisted: melt that has just met
    if (dt > 2*equations_.limits().deltaT("density"))
    {
        restoreState();
        return "density limit";
    }
    // Without a step before, the lead is not known
    const bool first = system_.stepBefore == 0 && implicitness_ < 1;
    system_.implicitness = first ? 0.5 : implicitness_;
    if (!kick_.solve(dt))
    {
        restoreState();
        return "no convergence";
    }
    changeDensity(dt/2);
    const word why(fault(dt));
    if (!why.empty())
    {
        restoreState();
        return why;
    }

    equations_.collide(dt);
    return word();
}


void Foam::melt::incompressible::drift(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const bool solids = !f.body.empty();

    const double fastest = std::sqrt
    (
        parallelMax
        (
            n,
            [&](const int i)
            {
                return f.u[i]*f.u[i] + f.v[i]*f.v[i] + f.w[i]*f.w[i];
            }
        )
    );

    // No further than a spacing at a time: nothing passes a wall unseen
    const double way = mag(dt)*fastest;
    const int pieces = max(1, int(std::ceil(way/system_.spacing)));
    const double part = dt/pieces;
    for (int piece = 0; piece < pieces; ++piece)
    {
        #pragma omp parallel for schedule(static)
        for (int i = 0; i < n; ++i)
        {
            if (!solids || f.body[i] < 0)
            {
                f.x[i] += part*f.u[i];
                f.y[i] += part*f.v[i];
                f.z[i] += part*f.w[i];
            }
        }
        equations_.moveSolids(part);
        wallContacts_ += keepInFrontOfWalls(system_.near, system_.walls, f);
        updateNeighbours(way/pieces);
    }
}


void Foam::melt::incompressible::shift(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = int(f.du.size());
    if (n == 0)
    {
        return;
    }

    double longest2 = 0;
    #pragma omp parallel for schedule(static) reduction(max:longest2)
    for (int i = 0; i < n; ++i)
    {
        const double dx = dt*f.du[i];
        const double dy = dt*f.dv[i];
        const double dz = dt*f.dw[i];
        longest2 = std::max(longest2, dx*dx + dy*dy + dz*dz);
        f.x[i] += dx;
        f.y[i] += dy;
        f.z[i] += dz;
    }
    wallContacts_ += keepInFrontOfWalls(system_.near, system_.walls, f);
    updateNeighbours(std::sqrt(longest2));
}


void Foam::melt::incompressible::heat(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = int(f.dH.size());

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.h[i] += dt*f.dH[i];
    }
    system_.heatReceived += dt*system_.heatFromWalls;
    equations_.advanceHeat(dt);
}


Foam::word Foam::melt::incompressible::step(const scalar dt)
{
    drift(dt/2);
    const word why(kick(dt));
    if (!why.empty())
    {
        drift(-dt/2);
        return why;
    }
    system_.stepBefore = dt;
    heat(dt);
    drift(dt/2);
    shift(dt);
    return word();
}


void Foam::melt::incompressible::advance(const scalar deltaT)
{
    const word why(step(deltaT));
    if (why.empty())
    {
        return;
    }

    ++halvedSteps_;
    Info<< "incompressible: a step of " << deltaT << " s is done again in two: "
        << why << endl;
    if (!(deltaT > VSMALL))
    {
        FatalErrorInFunction
            << "The step has shrunk to " << deltaT << " s: " << why
            << exit(FatalError);
    }
    advance(deltaT/2);
    advance(deltaT/2);
}


// ************************************************************************* //
