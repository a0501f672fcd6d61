/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "implicitPressure.H"
#include "addToRunTimeSelectionTable.H"
#include "blockSum.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(implicitPressure, 0);
    addToRunTimeSelectionTable(rateTerm, implicitPressure, dictionary);
}
}


Foam::melt::implicitPressure::implicitPressure
(
    const dictionary& dict,
    sphSystem& system
)
:
    rateTerm(system),
    dict_(dict),
    densityError_
    (
        checkedEntry::getOrDefault
        (
            dict, "densityError", dimless, checkedEntry::positiveUpTo(1), 0.01
        )
    ),
    background_
    (
        checkedEntry::getOrDefault
        (
            dict, "background", dimPressure, checkedEntry::notNegative(), 0
        )
    ),
    operator_
    (
        system,
        dict.getOrDefault("tension", true),
        checkedEntry::getOrDefault
        (
            dict, "maxCondition", dimless, checkedEntry::positive(), 8
        ),
        background_
    )
{
    if (dict.found("speedOfSound"))
    {
        system_.soundSpeed = checkedEntry::get
        (
            dict, "speedOfSound", dimVelocity, checkedEntry::positive()
        );
    }
}


Foam::scalar Foam::melt::implicitPressure::speedOfSound() const
{
    // Of |g| times height, and of the speed
    const particles& f = system_.fluid;
    const wallState& w = system_.walls;
    const std::array<double, 3>& g = system_.g;
    double highest = -GREAT, lowest = GREAT, maxSpeed2 = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        const double potential = -g[0]*f.x[i] - g[1]*f.y[i] - g[2]*f.z[i];
        highest = std::max(highest, potential);
        lowest = std::min(lowest, potential);
        maxSpeed2 = std::max
        (
            maxSpeed2,
            f.u[i]*f.u[i] + f.v[i]*f.v[i] + f.w[i]*f.w[i]
        );
    }
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        lowest = std::min(lowest, -g[0]*w.x[i] - g[1]*w.y[i] - g[2]*w.z[i]);
    }

    const double speed2 = std::max(2*(highest - lowest), maxSpeed2);
    if (!(speed2 > 0))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry speedOfSound is missing: without gravity and motion it"
            << " does not follow from densityError, accepted: a number > 0 [m/s]"
            << exit(FatalIOError);
    }
    return std::sqrt(speed2/densityError_);
}


void Foam::melt::implicitPressure::allocate()
{
    // Once, from the melt at time 0: a restart comes here a second time, with
    // the melt of its own time
    if (system_.soundSpeed == 0 && system_.fluid.size())
    {
        system_.soundSpeed = speedOfSound();
    }
}


void Foam::melt::implicitPressure::prepare()
{
    particles& f = system_.fluid;
    const int n = f.size();
    const double rho0 = system_.thermo.rho();
    const double c = system_.soundSpeed;
    const double background = background_;

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.p[i] = c*c*(f.rho[i] - rho0) + background;
    }

    // For the density of the velocities that lead here
    operator_.update(0);
}


bool Foam::melt::implicitPressure::setDensityRate()
{
    particles& f = system_.fluid;
    const int n = f.size();

    operator_.divergence(f.dRho);

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.dRho[i] *= -f.rho[i];
    }
    return true;
}


void Foam::melt::implicitPressure::limit(timeStepControl& control) const
{
    const particles& f = system_.fluid;
    const double maxSpeed2 = parallelMax
    (
        f.size(),
        [&](const int i)
        {
            return f.u[i]*f.u[i] + f.v[i]*f.v[i] + f.w[i]*f.w[i];
        }
    );
    // Also if it is not a number, for the control to say so
    if (!(maxSpeed2 <= 0))
    {
        control.limit("advective", system_.spacing/std::sqrt(maxSpeed2));
    }

    const double rate = parallelMax
    (
        f.size(),
        [&](const int i) { return std::abs(f.dRho[i]/f.rho[i]); }
    );
    if (!(rate <= 0))
    {
        control.limit("density", std::sqrt(densityError_)/rate);
    }

    // Where the melt presses, how its particles lie is stiff too, and that is
    // explicit; viscosity damps it
    const double h = system_.near.kernel().h();
    const double c2 = sqr(system_.soundSpeed);
    const double rho0 = system_.thermo.rho();
    const std::vector<double>& eta = f.eta;
    const auto* const solid =
        system_.solid.empty() ? nullptr : system_.solid.data();
    const double stiffness = parallelMax
    (
        f.size(),
        [&](const int i)
        {
            const double p =
                solid && solid[i] ? 0
              : std::max(c2*(f.rho[i] - rho0) + background_, 0.0);
            const double pressing = std::sqrt(p/f.rho[i])/h;
            return eta.empty() ? pressing : std::min(pressing, 2*p/eta[i]);
        }
    );
    if (!(stiffness <= 0))
    {
        control.limit("pressure", 1/stiffness);
    }
}

// ************************************************************************* //
