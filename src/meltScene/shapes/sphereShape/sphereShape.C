/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphereShape.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(sphereShape);
    addToRunTimeSelectionTable(shape, sphereShape, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::sphereShape::sphereShape
(
    const word& name,
    const dictionary& dict,
    const fileName&
)
:
    shape(name, dict),
    centre_(dict.get<point>("centre")),
    radius_
    (
        checkedEntry::get
        (
            dict,
            "radius",
            dimLength,
            checkedEntry::positive()
        )
    )
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::melt::sphereShape::ownVolume() const
{
    return 4.0/3.0*constant::mathematical::pi*pow3(radius_);
}


// ************************************************************************* //
