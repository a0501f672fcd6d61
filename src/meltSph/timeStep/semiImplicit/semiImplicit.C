/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "semiImplicit.H"
#include "addToRunTimeSelectionTable.H"
#include "wallContact.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(semiImplicit, 0);
    addToRunTimeSelectionTable(sphScheme, semiImplicit, dictionary);
}
}


Foam::melt::semiImplicit::semiImplicit
(
    const dictionary& dict,
    const effectSwitches& effects,
    sphSystem& system
)
:
    sphScheme(dict, effects, system)
{
    if (equations_.solids())
    {
        FatalIOErrorInFunction(dict.subDict("solids"))
            << "Solids that are not viscous go with the scheme incompressible"
            << exit(FatalIOError);
    }
}


bool Foam::melt::semiImplicit::step(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const bool heat = !f.dH.empty();
    const bool xsph = !f.du.empty();

    before_.assign(f.u, f.v, f.w);
    equations_.guess() = before_;

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.u[i] += dt*f.ax[i];
        f.v[i] += dt*f.ay[i];
        f.w[i] += dt*f.az[i];
    }
    if (!equations_.implicitUpdate(dt))
    {
        f.u = before_.x;
        f.v = before_.y;
        f.w = before_.z;
        return false;
    }

    equations_.setDensityRate();
    equations_.collide(dt);

    double longest2 = 0;
    #pragma omp parallel for schedule(static) reduction(max:longest2)
    for (int i = 0; i < n; ++i)
    {
        f.rho[i] += dt*f.dRho[i];
        if (heat)
        {
            f.h[i] += dt*f.dH[i];
        }

        const double dx = dt*(f.u[i] + (xsph ? f.du[i] : 0));
        const double dy = dt*(f.v[i] + (xsph ? f.dv[i] : 0));
        const double dz = dt*(f.w[i] + (xsph ? f.dw[i] : 0));
        f.x[i] += dx;
        f.y[i] += dy;
        f.z[i] += dz;
        longest2 = std::max(longest2, dx*dx + dy*dy + dz*dz);
    }

    system_.heatReceived += dt*system_.heatFromWalls;

    wallContacts_ += keepInFrontOfWalls(system_.near, system_.walls, f);
    updateNeighbours(std::sqrt(longest2));
    equations_.advanceHeat(dt);
    equations_.evaluate();
    return true;
}


void Foam::melt::semiImplicit::resume()
{
    equations_.evaluate();
}


void Foam::melt::semiImplicit::advance(const scalar deltaT)
{
    if (step(deltaT))
    {
        return;
    }

    ++halvedSteps_;
    Info<< "semiImplicit: an implicit term does not converge in a step of "
        << deltaT << " s, done again in two" << endl;
    if (!(deltaT > SMALL*equations_.limits().deltaT()))
    {
        FatalErrorInFunction
            << "The step has shrunk to " << deltaT << " s without the implicit"
            << " terms converging" << exit(FatalError);
    }
    advance(deltaT/2);
    advance(deltaT/2);
}

// ************************************************************************* //
