/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatSources.H"
#include "effectSwitches.H"
#include "oven.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::melt::heatSources::given() const
{
    const dictionary& effects = dict_.subOrEmptyDict("effects");

    if (effectSwitches::off(effects, "heatSources"))
    {
        return dictionary();
    }

    dictionary sources(dict_.subOrEmptyDict("heatSources"));
    if (effectSwitches::off(effects, "surfaceHeatLoss"))
    {
        for (const word& name : sources.toc())
        {
            if (exchangesHeat(*sources.findEntry(name)))
            {
                sources.remove(name);
            }
        }
    }
    return sources;
}


void Foam::melt::heatSources::make()
{
    const dictionary sources(given());
    const wordList names(sources.toc());

    clear();
    setSize(names.size());
    forAll(names, i)
    {
        set(i, heatSource::New(names[i], sources.subDict(names[i])));
    }
    digest_ = sources.digest();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::heatSources::heatSources(const dictionary& meltProperties)
:
    dict_(meltProperties)
{
    make();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::heatSources::exchangesHeat(const entry& source)
{
    return
        source.isDict()
     && source.dict().lookupOrDefault<word>("type", word::null)
     == oven::typeName;
}


bool Foam::melt::heatSources::update()
{
    if (given().digest() == digest_)
    {
        return false;
    }
    make();
    return true;
}


Foam::melt::absorbedHeat Foam::melt::heatSources::heatSurface
(
    const scalar time,
    const surfaceElements& elements,
    const occlusion& shade
) const
{
    absorbedHeat absorbed(elements.size());
    for (const heatSource& source : *this)
    {
        if (source.active())
        {
            source.heatSurface(time, elements, shade, absorbed);
        }
    }
    forAll(elements.resistance, i)
    {
        const scalar part = 1/(1 + elements.resistance[i]*absorbed.slope[i]);
        absorbed.power[i] *= part;
        absorbed.slope[i] *= part;
    }
    return absorbed;
}


bool Foam::melt::heatSources::inVolume() const
{
    for (const heatSource& source : *this)
    {
        if (source.active() && source.inVolume())
        {
            return true;
        }
    }
    return false;
}


Foam::scalarField Foam::melt::heatSources::heatVolume
(
    const scalar time,
    const pointField& positions,
    const scalarField& volumes
) const
{
    scalarField power(positions.size(), 0);
    for (const heatSource& source : *this)
    {
        if (source.active())
        {
            source.heatVolume(time, positions, volumes, power);
        }
    }
    return power;
}

// ************************************************************************* //
