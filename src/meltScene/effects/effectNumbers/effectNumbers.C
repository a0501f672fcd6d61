/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectNumbers.H"
#include "heatSources.H"
#include "meltScene.H"
#include "physicoChemicalConstants.H"
#include "shape.H"

#include <cmath>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::effectNumbers::extent(const meltScene& scene)
{
    scalar H = GREAT;
    for (const shape& s : scene.shapes())
    {
        H = min(H, cmptMin(s.bounds().span()));
    }
    return max(H, VSMALL);
}


Foam::scalar Foam::melt::effectNumbers::shearRate(const meltScene& scene)
{
    return std::sqrt(mag(scene.g())/extent(scene));
}


Foam::scalar Foam::melt::effectNumbers::hotViscosity
(
    const meltScene& scene,
    const scalar shearRate
)
{
    const scalar T = scene.TRange().max();
    scalar eta = 0;
    scene.rheology().eta(1, &shearRate, &T, &eta);
    return max(eta, VSMALL);
}


Foam::label Foam::melt::effectNumbers::nSources(const meltScene& scene)
{
    return scene.dict().subOrEmptyDict("heatSources").size();
}


Foam::label Foam::melt::effectNumbers::nLossy(const meltScene& scene)
{
    label n = 0;
    for (const entry& e : scene.dict().subOrEmptyDict("heatSources"))
    {
        n += heatSources::exchangesHeat(e);
    }
    return n;
}


Foam::scalar Foam::melt::effectNumbers::biot(const meltScene& scene)
{
    scalar h = 0;
    for (const entry& e : scene.dict().subOrEmptyDict("heatSources"))
    {
        if (heatSources::exchangesHeat(e))
        {
            const dictionary& dict = e.dict();
            h += dict.lookupOrDefault<scalar>("h", 0)
               + 4*dict.lookupOrDefault<scalar>("emissivity", 0)
                *constant::physicoChemical::sigma.value()
                *pow3(scene.TRange().max());
        }
    }
    return h*extent(scene)/max(scene.thermo().kappaSolid(), VSMALL);
}


// ************************************************************************* //
