/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "linearEquationOfState.H"
#include "addToRunTimeSelectionTable.H"
#include "blockSum.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(linearEquationOfState, 0);
    addToRunTimeSelectionTable(rateTerm, linearEquationOfState, dictionary);
}
}


Foam::melt::linearEquationOfState::linearEquationOfState
(
    const dictionary& dict,
    sphSystem& system
)
:
    rateTerm(system),
    c_
    (
        checkedEntry::get
        (
            dict, "speedOfSound", dimVelocity, checkedEntry::positive()
        )
    ),
    tension_(dict.getOrDefault("tension", false)),
    background_
    (
        checkedEntry::getOrDefault
        (
            dict, "background", dimPressure, checkedEntry::notNegative(), 0
        )
    )
{
    system_.soundSpeed = c_;
    system_.pairs.pressure = true;
}


void Foam::melt::linearEquationOfState::prepare()
{
    particles& f = system_.fluid;
    const int n = f.size();
    const double rho0 = system_.thermo.rho();
    const double lowest = tension_ ? -GREAT : 0;
    const double background = background_;

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.p[i] = std::max(lowest, c_*c_*(f.rho[i] - rho0) + background);
    }
}


void Foam::melt::linearEquationOfState::limit(timeStepControl& control) const
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
    if (f.size())
    {
        control.limit
        (
            "acoustic",
            system_.near.kernel().h()/(c_ + std::sqrt(maxSpeed2))
        );
    }
}

// ************************************************************************* //
