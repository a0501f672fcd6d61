/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointSource.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace melt
{
    defineTypeName(pointSource);
    addToRunTimeSelectionTable(heatSource, pointSource, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::pointSource::pointSource(const word& name, const dictionary& dict)
:
    heatSource(name, dict),
    position_(dict.get<point>("position")),
    power_(function("power")),
    absorptivity_
    (
        checkedEntry::getOrDefault
        (
            dict, "absorptivity", dimless, scalarMinMax(0, 1), 1
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::pointSource::heatSurface
(
    const scalar time,
    const surfaceElements& elements,
    const occlusion& shade,
    absorbedHeat& absorbed
) const
{
    const scalar power =
        absorptivity_*notNegative(*power_, time);

    DynamicList<label> facing(elements.size());
    forAll(elements.position, i)
    {
        const vector way(position_ - elements.position[i]);
        if (elements.free[i] && (elements.normal[i] & way) > 0)
        {
            facing.append(i);
        }
    }

    const boolList blocked
    (
        shade.blocked(elements, facing, pointField(facing.size(), position_))
    );
    forAll(facing, k)
    {
        if (!blocked[k])
        {
            const label i = facing[k];
            const vector way(position_ - elements.position[i]);
            const scalar d2 = max(magSqr(way), VSMALL);
            const scalar share =
                (elements.normal[i] & way)*elements.area[i]
               /(4*constant::mathematical::pi*d2*sqrt(d2));
            absorbed.power[i] += power*min(share, scalar(1));
        }
    }
}

// ************************************************************************* //
