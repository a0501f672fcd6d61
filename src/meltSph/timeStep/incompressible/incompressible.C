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
    sphScheme(dict, effects, system)
{
    if (!equations_.implicit() || system_.pairs.pressure)
    {
        FatalIOErrorInFunction(dict)
            << "The scheme incompressible takes pressure { type"
            << " implicitPressure; ... } and viscosity { type"
            << " implicitViscosity; ... }"
            << exit(FatalIOError);
    }
    system_.implicitness = checkedEntry::getOrDefault
    (
        dict, "implicitness", dimless, scalarMinMax(0.5, 1), 0.6
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
    rhoBefore_ = f.rho;
}


void Foam::melt::incompressible::restoreState()
{
    particles& f = system_.fluid;
    f.u = before_.x;
    f.v = before_.y;
    f.w = before_.z;
    f.ax = f.axOld;
    f.ay = f.ayOld;
    f.az = f.azOld;
    f.rho = rhoBefore_;
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


void Foam::melt::incompressible::setContact(const scalar dt)
{
    particles& f = system_.fluid;

    // As if forces were those of the step before
    contact_.assign(f.axOld, f.ayOld, f.azOld);
    contact_.scaleAndAdd(dt, before_);
    f.u = contact_.x;
    f.v = contact_.y;
    f.w = contact_.z;
    equations_.collideSolids(dt);

    const double theta = system_.implicitness;
    const int n = f.size();
    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        contact_.x[i] = theta*(f.u[i] - contact_.x[i]);
        contact_.y[i] = theta*(f.v[i] - contact_.y[i]);
        contact_.z[i] = theta*(f.w[i] - contact_.z[i]);
    }
}


void Foam::melt::incompressible::setPredicted(const scalar share)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const bool solids = equations_.solids();

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.u[i] = before_.x[i] + share*f.ax[i] + (solids ? contact_.x[i] : 0);
        f.v[i] = before_.y[i] + share*f.ay[i] + (solids ? contact_.y[i] : 0);
        f.w[i] = before_.z[i] + share*f.az[i] + (solids ? contact_.z[i] : 0);
    }
}


void Foam::melt::incompressible::setVelocities(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const bool solids = equations_.solids();
    const double share = system_.implicitness*dt;

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.ax[i] =
            (f.u[i] - before_.x[i] - (solids ? contact_.x[i] : 0))/share;
        f.ay[i] =
            (f.v[i] - before_.y[i] - (solids ? contact_.y[i] : 0))/share;
        f.az[i] =
            (f.w[i] - before_.z[i] - (solids ? contact_.z[i] : 0))/share;
        f.u[i] = before_.x[i] + dt*f.ax[i];
        f.v[i] = before_.y[i] + dt*f.ay[i];
        f.w[i] = before_.z[i] + dt*f.az[i];
    }
    equations_.collideSolids(dt);
}


bool Foam::melt::incompressible::endWithSolids(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const double theta = system_.implicitness;
    const double share = theta*dt;

    vectorArray solved, predicted, mean;
    solved.assign(f.u, f.v, f.w);
    setPredicted(share);
    predicted.assign(f.u, f.v, f.w);
    f.u = solved.x;
    f.v = solved.y;
    f.w = solved.z;

    setVelocities(dt);
    mean.assign(f.u, f.v, f.w);
    mean.add(-1, before_);
    mean.scaleAndAdd(theta, before_);
    if (!equations_.holdSolids(solved, mean, dt/theta))
    {
        return true;
    }

    // Velocities before the implicit forces, or what these make of them
    const auto addForces = [&](const double sources, const bool held)
    {
        vectorArray force(n);
        equations_.addImplicitForces(mean, sources, force);
        for (int i = 0; i < n; ++i)
        {
            if (equations_.held(i) == held)
            {
                f.u[i] = predicted.x[i] + share*force.x[i]/f.m[i];
                f.v[i] = predicted.y[i] + share*force.y[i]/f.m[i];
                f.w[i] = predicted.z[i] + share*force.z[i]/f.m[i];
            }
        }
    };

    // To the others those that are held are walls that move. The solver has
    // them at rest
    for (int i = 0; i < n; ++i)
    {
        if (!equations_.held(i))
        {
            mean.x[i] = mean.y[i] = mean.z[i] = 0;
        }
    }
    addForces(0, false);
    equations_.guess() = solved;
    if (!equations_.implicitUpdate(share))
    {
        equations_.releaseSolids();
        return false;
    }

    // They take up the forces of that liquid, and contact anew
    for (int i = 0; i < n; ++i)
    {
        if (!equations_.held(i))
        {
            mean.x[i] = f.u[i];
            mean.y[i] = f.v[i];
            mean.z[i] = f.w[i];
        }
    }
    addForces(1, true);
    equations_.releaseSolids();
    setVelocities(dt);
    return true;
}


Foam::word Foam::melt::incompressible::kick(const scalar dt)
{
    particles& f = system_.fluid;
    const bool solids = equations_.solids();

    keepState();
    equations_.evaluate();
    // What has just become part of a solid moves with it now
    before_.assign(f.u, f.v, f.w);
    changeDensity(dt/2);
    // What pressure has not resisted: melt that has just met
    if (dt > 2*equations_.limits().deltaT("density"))
    {
        restoreState();
        return "density limit";
    }
    if (solids)
    {
        setContact(dt);
    }

    // Solved for the mean velocity, over the implicit share of the step. The
    // first guess goes on as the step before did
    const double share = system_.implicitness*dt;
    vectorArray& guess = equations_.guess();
    guess.assign(f.axOld, f.ayOld, f.azOld);
    guess.scaleAndAdd(share, before_);
    if (solids)
    {
        guess.add(1, contact_);
    }
    for (label nSolved = 1; ; ++nSolved)
    {
        setPredicted(share);
        if (!equations_.implicitUpdate(share))
        {
            restoreState();
            return "no convergence";
        }
        if (equations_.couple(nSolved))
        {
            break;
        }
    }

    if (!solids)
    {
        setVelocities(dt);
    }
    else if (!endWithSolids(dt))
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
