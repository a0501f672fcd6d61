/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "volumetricSource.H"
#include "addToRunTimeSelectionTable.H"
#include "hotPlate.H"

namespace Foam
{
namespace melt
{
    defineTypeName(volumetricSource);
    addToRunTimeSelectionTable(heatSource, volumetricSource, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::volumetricSource::volumetricSource
(
    const word& name,
    const dictionary& dict
)
:
    heatSource(name, dict),
    box_(hotPlate::box(dict)),
    powerDensity_(function("powerDensity"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::volumetricSource::heatVolume
(
    const scalar time,
    const pointField& positions,
    const scalarField& volumes,
    scalarField& power
) const
{
    const scalar density = notNegative(*powerDensity_, time);

    forAll(positions, i)
    {
        if (box_.contains(positions[i]))
        {
            power[i] += density*volumes[i];
        }
    }
}

// ************************************************************************* //
