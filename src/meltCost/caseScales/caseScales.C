/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseScales.H"
#include "checkedEntry.H"
#include "volFields.H"
#include "meltScene.H"
#include "shape.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using melt::meltScene;

//- Kinematic viscosity at the highest temperature and shear rate [m2/s]
scalar viscosity(const meltScene& scene, const scalar shearRate)
{
    const scalar T = scene.TRange().max();
    scalar eta = 0;
    scene.rheology().eta(1, &shearRate, &T, &eta);
    return max(eta/scene.thermo().rho(), VSMALL);
}


//- Thermal diffusivity [m2/s]
scalar diffusivity(const meltScene& scene)
{
    const melt::meltThermo& thermo = scene.thermo();
    return max
    (
        thermo.kappaSolid()/thermo.enthalpy().CpSolid,
        thermo.kappaLiquid()/thermo.enthalpy().CpLiquid
    )/thermo.rho();
}


bool staysSolid(const meltScene& scene)
{
    return
        !scene.effects()("heatSources")
     && scene.TRange().max() <= scene.thermo().enthalpy().solidus;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::caseScales::caseScales(const meltScene& scene)
:
    extent(GREAT),
    meltVolume(0),
    domainVolume(gSum(scene.mesh().V()))
{
    for (const shape& s : scene.shapes())
    {
        extent = min(extent, cmptMin(s.bounds().span()));
        meltVolume += s.volume();
    }

    const Time& time = scene.mesh().time();
    const scalar t = time.endTime().value() - time.value();
    const scalar g = mag(scene.g());

    leastSteps = t/checkedEntry::get
    (
        time.controlDict(), "deltaT", dimTime, checkedEntry::positive()
    );

    if (g > 0 && !staysSolid(scene))
    {
        const scalar nu = viscosity(scene, std::sqrt(g/extent));
        const bool late = t > max(sqr(extent)/nu, nu/(g*extent));

        caseClass =
            !late ? "viscousFlow"
          : scene.effects()("generalisedNewtonian") ? "viscoplastic"
          : "spreading";
        duration = t/(late ? nu/(g*extent) : std::sqrt(extent/g));
    }
    else if (scene.effects()("heatConduction"))
    {
        caseClass =
            scene.effects()("phaseChange") ? "phaseChange" : "conduction";
        duration = t*diffusivity(scene)/sqr(extent);
    }
    else
    {
        caseClass = "rest";
        duration = t;
    }
}


// ************************************************************************* //
