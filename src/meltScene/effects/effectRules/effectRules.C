/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectRules.H"
#include "effectNumbers.H"
#include "effectTimes.H"
#include "fvMesh.H"
#include "meltScene.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using melt::effectRules::rule;
using melt::effectRules::verdict;
using melt::meltScene;
using namespace melt::effectNumbers;

//- "name = value"
string number(const char* name, const scalar value)
{
    OStringStream os;
    os  << name << " = " << value;
    return os.str();
}


verdict artificialViscosity(const meltScene& scene)
{
    const scalar rate = shearRate(scene);
    return
    {
        true,
        "damps sound; the method has its coefficients",
        number
        (
            "Re",
            scene.thermo().rho()*rate*sqr(extent(scene))
           /hotViscosity(scene, rate)
        )
    };
}


verdict buoyancy(const meltScene& scene)
{
    const melt::meltThermo& thermo = scene.thermo();
    const scalarMinMax T(scene.TRange());
    const bool differ = T.max() > T.min() || nSources(scene);
    const bool falls = mag(scene.g()) > 0;
    const scalar H = extent(scene);
    return
    {
        differ && falls,
        !falls ? "no gravity"
      : differ ? "temperatures differ; the method has the expansion"
      : "one temperature, no source of heat",
        number
        (
            "Ra/(beta K)",
            mag(scene.g())*pow3(H)
           *max(T.max() - T.min(), scalar(differ ? 1 : 0))
           /(hotViscosity(scene, shearRate(scene))/thermo.rho())
           *thermo.rho()*thermo.enthalpy().CpLiquid
           /max(thermo.kappaLiquid(), VSMALL)
        )
    };
}


verdict generalisedNewtonian(const meltScene& scene)
{
    const bool needed = scene.rheology().shearRateDependent();
    return
    {
        needed,
        needed
      ? "the viscosity depends on the shear rate"
      : "the viscosity does not depend on the shear rate",
        number
        (
            "eta(0)/eta(g)",
            hotViscosity(scene, 0)/hotViscosity(scene, shearRate(scene))
        )
    };
}


verdict heatConduction(const meltScene& scene)
{
    const melt::meltThermo& thermo = scene.thermo();
    const scalarMinMax T(scene.TRange());
    const scalar diffusivity = max
    (
        thermo.kappaSolid()/thermo.enthalpy().CpSolid,
        thermo.kappaLiquid()/thermo.enthalpy().CpLiquid
    )/thermo.rho();

    return
    {
        T.max() > T.min() || nSources(scene),
        T.max() > T.min() ? "temperatures differ"
      : nSources(scene) ? "heat comes in"
      : "one temperature, no source of heat",
        number
        (
            "Fo",
            diffusivity*scene.mesh().time().endTime().value()
           /sqr(extent(scene))
        )
    };
}


verdict heatSources(const meltScene& scene)
{
    const label n = nSources(scene);
    return
    {
        n > 0,
        n ? "the scene has them" : "the scene has none",
        n ? number("sources", n) : "-"
    };
}


verdict latentHeat(const meltScene& scene)
{
    const melt::enthalpyCurve& curve = scene.thermo().enthalpy();
    const scalarMinMax T(scene.TRange());
    const bool needed = curve.latentHeat > 0;
    return
    {
        needed,
        needed ? "the material has it" : "the material has none",
        needed
      ? number("Ste", curve.CpSolid*(T.max() - T.min())/curve.latentHeat)
      : "-"
    };
}


verdict particleCollision(const meltScene&)
{
    return {true, "keeps particles apart; the method has its distance", "-"};
}


verdict particleShifting(const meltScene&)
{
    return
    {
        false,
        "on is for melt that strains for long; the method has its coefficients",
        "-"
    };
}


verdict phaseChange(const meltScene& scene)
{
    const melt::enthalpyCurve& curve = scene.thermo().enthalpy();
    const scalarMinMax T(scene.TRange());
    const bool solid = T.max() <= curve.solidus && !nSources(scene);

    // At a melting point, without a range, it starts solid
    const bool liquid =
        T.min() >= curve.liquidus && T.min() > curve.solidus
     && !nSources(scene);
    return
    {
        !solid && !liquid,
        liquid ? "all is liquid and stays so"
      : solid ? "all is solid and stays so"
      : "something can melt or freeze",
        T.max() > T.min()
      ? number("theta", (curve.solidus - T.min())/(T.max() - T.min()))
      : "-"
    };
}


verdict rigidSolids(const meltScene& scene)
{
    const melt::enthalpyCurve& curve = scene.thermo().enthalpy();
    const scalarMinMax T(scene.TRange());
    const bool never =
        T.min() > curve.liquidus && !nSources(scene)
     && !scene.dict().found("vents");
    return
    {
        !never,
        never ? "nothing is solid, nothing can freeze"
      : "something is, or can become, solid",
        T.max() > T.min()
      ? number("theta", (curve.solidus - T.min())/(T.max() - T.min()))
      : "-"
    };
}


verdict surfaceHeatLoss(const meltScene& scene)
{
    const label n = nLossy(scene);
    return
    {
        n > 0,
        n ? "the surface exchanges heat with an oven"
      : "the scene has no surroundings: source of type oven",
        n ? number("Bi", biot(scene)) : "-"
    };
}


verdict surfaceTension(const meltScene& scene)
{
    // Of the weight, as a pressure: sigma/H over rho |g| H
    const scalar negligible = 0.01;

    const scalar sigma = scene.thermo().surfaceTension();
    if (sigma == 0)
    {
        return {false, "the material has none", "-"};
    }
    const scalar bond =
        scene.thermo().rho()*mag(scene.g())*sqr(extent(scene))/sigma;
    const bool needed = bond*negligible < 1;
    return
    {
        needed,
        bond == 0 ? "no gravity"
      : needed ? "it is over 1 % of the weight"
      : "it is under 1 % of the weight",
        number("Bo", bond)
    };
}


verdict XSPH(const meltScene&)
{
    return {true, "keeps particles in order; the method has its coefficient", "-"};
}


rule rules[] =
{
    {"artificialViscosity", nullptr, artificialViscosity},
    {"buoyancy", melt::effectTimes::flow, buoyancy},
    {"generalisedNewtonian", melt::effectTimes::flow, generalisedNewtonian},
    {"heatConduction", nullptr, heatConduction},
    {"heatSources", nullptr, heatSources},
    {"latentHeat", "heatConduction", latentHeat},
    {"particleCollision", nullptr, particleCollision},
    {"particleShifting", nullptr, particleShifting},
    {"phaseChange", "heatConduction", phaseChange},
    {"rigidSolids", nullptr, rigidSolids},
    {"surfaceHeatLoss", "heatSources", surfaceHeatLoss},
    {"surfaceTension", nullptr, surfaceTension},
    {"XSPH", nullptr, XSPH}
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const Foam::UList<Foam::melt::effectRules::rule>&
Foam::melt::effectRules::all()
{
    static const UList<rule> list(rules, sizeof(rules)/sizeof(rule));
    return list;
}


// ************************************************************************* //
