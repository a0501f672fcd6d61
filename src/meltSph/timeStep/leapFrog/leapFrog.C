/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "leapFrog.H"
#include "addToRunTimeSelectionTable.H"
#include "wallContact.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(leapFrog, 0);
    addToRunTimeSelectionTable(sphScheme, leapFrog, dictionary);
}
}


Foam::melt::leapFrog::leapFrog
(
    const dictionary& dict,
    const effectSwitches& effects,
    sphSystem& system
)
:
    sphScheme(dict, effects, system)
{
    if (equations_.implicit())
    {
        FatalIOErrorInFunction(dict)
            << "The scheme leapFrog is explicit, but a term of this dictionary"
            << " is implicit: choose the scheme semiImplicit"
            << exit(FatalIOError);
    }
}


void Foam::melt::leapFrog::allocate()
{
    sphScheme::allocate();

    particles& f = system_.fluid;
    f.require({&f.axOld, &f.ayOld, &f.azOld, &f.dRhoOld});
    if (!f.dH.empty())
    {
        f.require({&f.dHOld});
    }
}


Foam::scalar Foam::melt::leapFrog::predict(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const bool heat = !f.dH.empty();
    const bool xsph = !f.du.empty();
    double longest2 = 0;

    f.axOld.swap(f.ax);
    f.ayOld.swap(f.ay);
    f.azOld.swap(f.az);
    f.dRhoOld.swap(f.dRho);
    f.dHOld.swap(f.dH);

    #pragma omp parallel for schedule(static) reduction(max:longest2)
    for (int i = 0; i < n; ++i)
    {
        double dx = dt*(f.u[i] + 0.5*dt*f.axOld[i]);
        double dy = dt*(f.v[i] + 0.5*dt*f.ayOld[i]);
        double dz = dt*(f.w[i] + 0.5*dt*f.azOld[i]);
        if (xsph)
        {
            dx += dt*f.du[i];
            dy += dt*f.dv[i];
            dz += dt*f.dw[i];
        }
        longest2 = std::max(longest2, dx*dx + dy*dy + dz*dz);

        f.x[i] += dx;
        f.y[i] += dy;
        f.z[i] += dz;
        f.u[i] += dt*f.axOld[i];
        f.v[i] += dt*f.ayOld[i];
        f.w[i] += dt*f.azOld[i];
        f.rho[i] += dt*f.dRhoOld[i];
        if (heat)
        {
            f.h[i] += dt*f.dHOld[i];
        }
    }
    return std::sqrt(longest2);
}


void Foam::melt::leapFrog::correct(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const bool heat = !f.dH.empty();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.u[i] += 0.5*dt*(f.ax[i] - f.axOld[i]);
        f.v[i] += 0.5*dt*(f.ay[i] - f.ayOld[i]);
        f.w[i] += 0.5*dt*(f.az[i] - f.azOld[i]);
        f.rho[i] += 0.5*dt*(f.dRho[i] - f.dRhoOld[i]);
        if (heat)
        {
            f.h[i] += 0.5*dt*(f.dH[i] - f.dHOld[i]);
        }
    }
}


void Foam::melt::leapFrog::advance(const scalar dt)
{
    const double heatBefore = system_.heatFromWalls;
    const scalar longestWay = predict(dt);
    wallContacts_ += keepInFrontOfWalls
    (
        system_.near, system_.walls, system_.fluid
    );
    updateNeighbours(longestWay);
    equations_.advanceHeat(dt);
    equations_.evaluate();
    correct(dt);
    equations_.collide(dt);
    system_.heatReceived += 0.5*dt*(heatBefore + system_.heatFromWalls);
}

// ************************************************************************* //
