/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cylinderShape.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(cylinderShape);
    addToRunTimeSelectionTable(shape, cylinderShape, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::cylinderShape::cylinderShape
(
    const word& name,
    const dictionary& dict,
    const fileName&
)
:
    shape(name, dict),
    point1_(dict.get<point>("point1")),
    point2_(dict.get<point>("point2")),
    radius_
    (
        checkedEntry::get
        (
            dict,
            "radius",
            dimLength,
            checkedEntry::positive()
        )
    ),
    length_(mag(point2_ - point1_)),
    axis_(normalised(point2_ - point1_))
{
    if (!(length_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'point2' of cylinder " << name << " is " << point2_
            << "; accepted is a point other than 'point1'"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

bool Foam::melt::cylinderShape::contains(const point& x) const
{
    const vector r(x - point1_);
    const scalar along = r & axis_;

    return
        along >= 0
     && along <= length_
     && magSqr(r - along*axis_) <= sqr(radius_);
}


Foam::scalar Foam::melt::cylinderShape::support(const vector& n) const
{
    return
        max(n & point1_, n & point2_)
      + radius_*mag(n - (n & axis_)*axis_);
}


Foam::scalar Foam::melt::cylinderShape::ownVolume() const
{
    return constant::mathematical::pi*sqr(radius_)*length_;
}


// ************************************************************************* //
