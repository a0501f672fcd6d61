/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hotPlate.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "Pair.H"

namespace Foam
{
namespace melt
{
    defineTypeName(hotPlate);
    addToRunTimeSelectionTable(heatSource, hotPlate, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::hotPlate::hotPlate(const word& name, const dictionary& dict)
:
    heatSource(name, dict),
    box_(box(dict)),
    temperature_(function("temperature")),
    h_
    (
        checkedEntry::get
        (
            dict,
            "h",
            dimPower/dimArea/dimTemperature,
            checkedEntry::notNegative()
        )
    )
{}


Foam::boundBox Foam::melt::hotPlate::box(const dictionary& dict)
{
    const Pair<point> corners(dict.get<Pair<point>>("box"));
    const boundBox result
    (
        min(corners.first(), corners.second()),
        max(corners.first(), corners.second())
    );
    if (!(mag(result.span()) > 0))
    {
        FatalIOErrorInFunction(dict.lookup("box"))
            << "Entry box = " << corners << " is empty. Accepted: two corners"
            << " that differ" << exit(FatalIOError);
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::hotPlate::heatSurface
(
    const scalar time,
    const surfaceElements& elements,
    const occlusion& shade,
    absorbedHeat& absorbed
) const
{
    const scalar Tp = notNegative(*temperature_, time);

    forAll(elements.position, i)
    {
        if (box_.contains(elements.position[i]))
        {
            const scalar hA = h_*elements.smoothArea[i];
            absorbed.power[i] += hA*(Tp - elements.T[i]);
            absorbed.slope[i] += hA;
        }
    }
}

// ************************************************************************* //
