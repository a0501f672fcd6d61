/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleShifting.H"
#include "addToRunTimeSelectionTable.H"
#include "blockSum.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "shiftingLaws.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(particleShifting, 0);
    addToRunTimeSelectionTable(rateTerm, particleShifting, dictionary);
}
}


Foam::melt::particleShifting::particleShifting
(
    const dictionary& dict,
    sphSystem& system
)
:
    rateTerm(system),
    coefficient_
    (
        checkedEntry::getOrDefault
        (
            dict, "coefficient", dimless, checkedEntry::positive(), 24
        )
    ),
    maxSpeed_
    (
        checkedEntry::getOrDefault
        (
            dict, "maxSpeed", dimless, checkedEntry::positiveUpTo(1), 0.5
        )
    ),
    surface_
    (
        checkedEntry::getOrDefault
        (
            dict, "surface", dimless, scalarMinMax(0, 1), 0.75
        )
    )
{}


void Foam::melt::particleShifting::allocate()
{
    particles& f = system_.fluid;
    f.require({&f.du, &f.dv, &f.dw});
}


void Foam::melt::particleShifting::alongSurface()
{
    particles& f = system_.fluid;
    const int n = f.size();

    const double least = -parallelMax
    (
        n,
        [&](const int i) { return -completeness_[i]; }
    );
    if (!(least < surface_))
    {
        return;
    }

    normal_.resize(n);
    leastCompleteness_.resize(n);
    pairPass
    (
        system_.near, system_.walls, f,
        surfaceLaw(f, completeness_, normal_, leastCompleteness_)
    );

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        if (leastCompleteness_[i] < surface_)
        {
            const double nx = normal_.x[i];
            const double ny = normal_.y[i];
            const double nz = normal_.z[i];
            const double n2 = nx*nx + ny*ny + nz*nz;
            const double share =
                n2 > 0 ? (f.du[i]*nx + f.dv[i]*ny + f.dw[i]*nz)/n2 : 0;
            f.du[i] -= share*nx;
            f.dv[i] -= share*ny;
            f.dw[i] -= share*nz;
        }
    }
}


void Foam::melt::particleShifting::addRates()
{
    particles& f = system_.fluid;
    const int n = f.size();
    const smoothingKernel& kernel = system_.near.kernel();

    completeness_.resize(n);
    approach_.resize(n);
    pairPass
    (
        system_.near, system_.walls, f,
        concentrationLaw(f, completeness_, approach_, kernel.dimensions())
    );
    alongSurface();

    const double mobility = coefficient_*kernel.h();
    const bool solids = !f.body.empty();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const double gradient = std::sqrt
        (
            f.du[i]*f.du[i] + f.dv[i]*f.dv[i] + f.dw[i]*f.dw[i]
        );
        double factor = -mobility*approach_[i];
        if (mobility*gradient > maxSpeed_)
        {
            factor *= maxSpeed_/(mobility*gradient);
        }
        if (solids && f.body[i] >= 0)
        {
            factor = 0;
        }
        f.du[i] *= factor;
        f.dv[i] *= factor;
        f.dw[i] *= factor;
    }
}

// ************************************************************************* //
