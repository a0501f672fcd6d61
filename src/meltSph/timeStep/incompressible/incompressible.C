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
}


Foam::word Foam::melt::incompressible::step(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();

    keepState();
    equations_.evaluate();
    equations_.startStep();

    // The first guess goes on as the step before did
    guess_ = before_;
    guess_.add(dt, lastA_);

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.u[i] += dt*f.ax[i];
        f.v[i] += dt*f.ay[i];
        f.w[i] += dt*f.az[i];
    }
    predicted_.x = f.u;
    predicted_.y = f.v;
    predicted_.z = f.w;
    for (label nSolved = 1; ; ++nSolved)
    {
        if (!equations_.implicitUpdate(dt, guess_))
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
        f.rho[i] += dt*f.dRho[i];
    }
    const word why(fault(dt));
    if (!why.empty())
    {
        restoreState();
        return why;
    }

    move(dt);
    return word();
}


void Foam::melt::incompressible::move(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const bool heat = !f.dH.empty();
    const bool xsph = !f.du.empty();

    const auto velocity = [&](const int i, double& u, double& v, double& w)
    {
        u = f.u[i] + (xsph ? f.du[i] : 0);
        v = f.v[i] + (xsph ? f.dv[i] : 0);
        w = f.w[i] + (xsph ? f.dw[i] : 0);
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


// ************************************************************************* //
