/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "movingLaser.H"
#include "addToRunTimeSelectionTable.H"
#include "boundBox.H"
#include "checkedEntry.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace melt
{
    defineTypeName(movingLaser);
    addToRunTimeSelectionTable(heatSource, movingLaser, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // Beyond so many radii nothing is left: exp(-2*16) is 1e-14
    constexpr Foam::scalar reach = 4;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::movingLaser::movingLaser(const word& name, const dictionary& dict)
:
    heatSource(name, dict),
    position_(Function1<vector>::New("position", dict)),
    direction_(dict.get<vector>("direction")),
    power_(function("power")),
    radius_
    (
        checkedEntry::get(dict, "radius", dimLength, checkedEntry::positive())
    ),
    absorptivity_
    (
        checkedEntry::getOrDefault
        (
            dict, "absorptivity", dimless, scalarMinMax(0, 1), 1
        )
    )
{
    if (!(mag(direction_) > 0))
    {
        FatalIOErrorInFunction(dict.lookup("direction"))
            << "Entry direction is " << direction_
            << ". Accepted: a vector that is not zero" << exit(FatalIOError);
    }
    direction_.normalise();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::movingLaser::heatSurface
(
    const scalar time,
    const surfaceElements& elements,
    const occlusion& shade,
    absorbedHeat& absorbed
) const
{
    const scalar intensity =
        absorptivity_*notNegative(*power_, time)
       *2/(constant::mathematical::pi*sqr(radius_));
    const point axis(position_->value(time));
    const scalar far = 2*boundBox(elements.position, false).mag();

    DynamicList<label> lit;
    DynamicList<point> to;
    forAll(elements.position, i)
    {
        const vector away(elements.position[i] - axis);
        const scalar r2 = magSqr(away - (away & direction_)*direction_);
        if
        (
            elements.free[i]
         && (elements.normal[i] & direction_) < 0
         && r2 < sqr(reach*radius_)
        )
        {
            lit.append(i);
            to.append(elements.position[i] - far*direction_);
        }
    }

    const boolList blocked(shade.blocked(elements, lit, pointField(to)));
    forAll(lit, k)
    {
        if (!blocked[k])
        {
            const label i = lit[k];
            const vector away(elements.position[i] - axis);
            const scalar r2 = magSqr(away - (away & direction_)*direction_);
            absorbed.power[i] -=
                intensity*exp(-2*r2/sqr(radius_))
               *(elements.normal[i] & direction_)*elements.area[i];
        }
    }
}

// ************************************************************************* //
