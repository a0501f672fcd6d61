/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompressible.H"
#include "addToRunTimeSelectionTable.H"
#include "blockSum.H"
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
    const particles& f = system_.fluid;
    before_.x = f.u;
    before_.y = f.v;
    before_.z = f.w;
    lastA_.x = f.ax;
    lastA_.y = f.ay;
    lastA_.z = f.az;
    rhoBefore_ = f.rho;
    lastDRho_ = f.dRho;
}


void Foam::melt::incompressible::restoreState()
{
    particles& f = system_.fluid;
    f.u = before_.x;
    f.v = before_.y;
    f.w = before_.z;
    f.ax = lastA_.x;
    f.ay = lastA_.y;
    f.az = lastA_.z;
    f.rho = rhoBefore_;
    f.dRho = lastDRho_;
}


Foam::word Foam::melt::incompressible::step(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();

    keepState();
    equations_.evaluate();
    equations_.startStep();

    // Without a step before, or after a much shorter one: backward Euler
    const scalar ratio = lastDeltaT_ > 0 ? dt/lastDeltaT_ : GREAT;
    const scalar gamma = ratio <= 2 ? ratio/(1 + 2*ratio) : 0;
    const scalar fromBefore = gamma*dt;
    const scalar now = dt - fromBefore;

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.u[i] += fromBefore*lastA_.x[i] + now*f.ax[i];
        f.v[i] += fromBefore*lastA_.y[i] + now*f.ay[i];
        f.w[i] += fromBefore*lastA_.z[i] + now*f.az[i];
        f.rho[i] += fromBefore*lastDRho_[i];
    }
    // The first guess goes on as the step before did
    guess_ = before_;
    if (gamma > 0)
    {
        guess_.add(dt, lastA_);
    }
    predicted_.x = f.u;
    predicted_.y = f.v;
    predicted_.z = f.w;
    for (label nSolved = 1; ; ++nSolved)
    {
        if (!equations_.implicitUpdate(now, guess_))
        {
            restoreState();
            return "no convergence";
        }
        if (equations_.couple(nSolved))
        {
            break;
        }
        guess_.x = f.u;
        guess_.y = f.v;
        guess_.z = f.w;
        f.u = predicted_.x;
        f.v = predicted_.y;
        f.w = predicted_.z;
    }

    equations_.setDensityRate();
    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.ax[i] = (f.u[i] - before_.x[i])/dt;
        f.ay[i] = (f.v[i] - before_.y[i])/dt;
        f.az[i] = (f.w[i] - before_.z[i])/dt;
        f.rho[i] += now*f.dRho[i];
        f.dRho[i] = (f.rho[i] - rhoBefore_[i])/dt;
    }
    const word why(fault(dt));
    if (!why.empty())
    {
        restoreState();
        return why;
    }

    move(dt);
    lastDeltaT_ = dt;
    return word();
}


void Foam::melt::incompressible::move(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const bool heat = !f.dH.empty();
    const bool xsph = !f.du.empty();

    // The mean of the velocities at both ends, from what goes with the
    // particles when they are sorted anew
    const auto velocity = [&](const int i, double& u, double& v, double& w)
    {
        u = f.u[i] - 0.5*dt*f.ax[i] + (xsph ? f.du[i] : 0);
        v = f.v[i] - 0.5*dt*f.ay[i] + (xsph ? f.dv[i] : 0);
        w = f.w[i] - 0.5*dt*f.az[i] + (xsph ? f.dw[i] : 0);
    };

    const double fastest = std::sqrt
    (
        parallelMax
        (
            n,
            [&](const int i)
            {
                double u, v, w;
                velocity(i, u, v, w);
                return u*u + v*v + w*w;
            }
        )
    );

    // No further than a spacing at a time: nothing passes a wall unseen. Solids
    // move over the whole step
    const int pieces =
        equations_.solids()
      ? 1
      : max(1, int(std::ceil(dt*fastest/system_.spacing)));
    const double part = dt/pieces;
    for (int piece = 0; piece < pieces; ++piece)
    {
        #pragma omp parallel for schedule(static)
        for (int i = 0; i < n; ++i)
        {
            double u, v, w;
            velocity(i, u, v, w);
            f.x[i] += part*u;
            f.y[i] += part*v;
            f.z[i] += part*w;
            if (heat)
            {
                f.h[i] += part*f.dH[i];
            }
        }

        equations_.moveSolids(dt);
        wallContacts_ += keepInFrontOfWalls(system_.near, system_.walls, f);
        updateNeighbours(part*fastest);
    }

    system_.heatReceived += dt*system_.heatFromWalls;
    equations_.advanceHeat(dt);
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


void Foam::melt::incompressible::write(dictionary& dict) const
{
    dict.set("lastDeltaT", lastDeltaT_);
}


void Foam::melt::incompressible::read(const dictionary& dict)
{
    dict.readIfPresent("lastDeltaT", lastDeltaT_);
}

// ************************************************************************* //
