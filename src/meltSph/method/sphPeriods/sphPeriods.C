/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphPeriods.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- What a mesh's file may be off by: relative to the spacing, and of normals
constexpr scalar lengthTolerance = 0.01, normalTolerance = 1e-3;


void checkLength
(
    const scalar period,
    const direction axis,
    const melt::sphSystem& system
)
{
    const scalar n = period/system.spacing;
    const scalar least = 2*system.near.radius();

    if (mag(n - round(n)) > lengthTolerance || period < least)
    {
        FatalErrorInFunction
            << "The domain repeats itself after " << period
            << " m in direction " << label(axis) << ", which is " << n
            << " times the resolution of " << system.spacing << " m." << nl
            << "Accepted by the method sph: a whole number of times, and at"
            << " least " << least << " m, twice the reach of its neighbour"
            << " lists" << exit(FatalError);
    }
}


void checkWalls(const direction axis, const melt::sphSystem& system)
{
    const std::vector<double>* const normals[] =
        {&system.walls.nx, &system.walls.ny, &system.walls.nz};

    for (const double n : *normals[axis])
    {
        if (mag(n) > normalTolerance)
        {
            FatalErrorInFunction
                << "The domain repeats itself in direction " << label(axis)
                << ", and there is a wall across that direction." << nl
                << "Accepted by the method sph: walls parallel to it"
                << exit(FatalError);
        }
    }
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::melt::periodicBox Foam::melt::periodsOf(const meltScene& scene)
{
    const vector& low = scene.mesh().bounds().min();
    const vector& period = scene.periods().period();

    return periodicBox
    (
        {low.x(), low.y(), low.z()}, {period.x(), period.y(), period.z()}
    );
}


void Foam::melt::checkPeriods(const meltScene& scene, const sphSystem& system)
{
    const vector& period = scene.periods().period();

    for (direction axis = 0; axis < vector::nComponents; ++axis)
    {
        if (period[axis] > 0)
        {
            checkLength(period[axis], axis, system);
            checkWalls(axis, system);
        }
    }

    if (scene.periods().any() && scene.effects()("heatSources"))
    {
        FatalIOErrorInFunction(scene.dict())
            << "The method sph has no heat sources in a domain with cyclic"
            << " patches." << nl << "Accepted: effects { heatSources off; }"
            << exit(FatalIOError);
    }
}

// ************************************************************************* //
