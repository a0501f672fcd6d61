/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "oven.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

namespace Foam
{
namespace melt
{
    defineTypeName(oven);
    addToRunTimeSelectionTable(heatSource, oven, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // Stefan-Boltzmann [W/(m2 K4)], CODATA 2018
    constexpr Foam::scalar sigma = 5.670374419e-8;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::oven::oven(const word& name, const dictionary& dict)
:
    heatSource(name, dict),
    temperature_(function("temperature")),
    h_
    (
        checkedEntry::getOrDefault
        (
            dict,
            "h",
            dimPower/dimArea/dimTemperature,
            checkedEntry::notNegative(),
            0
        )
    ),
    emissivity_
    (
        checkedEntry::getOrDefault
        (
            dict, "emissivity", dimless, scalarMinMax(0, 1), 0
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::oven::heatSurface
(
    const scalar time,
    const surfaceElements& elements,
    const occlusion& shade,
    absorbedHeat& absorbed
) const
{
    const scalar Ta = notNegative(*temperature_, time);

    forAll(elements.position, i)
    {
        if (elements.free[i])
        {
            const scalar T = elements.T[i];
            const scalar A = elements.smoothArea[i];
            const scalar radiation = emissivity_*sigma;
            absorbed.power[i] +=
                A*(h_*(Ta - T) + radiation*(pow4(Ta) - pow4(T)));
            absorbed.slope[i] += A*(h_ + 4*radiation*pow3(max(T, Ta)));
        }
    }
}

// ************************************************************************* //
