/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxShape.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(boxShape);
    addToRunTimeSelectionTable(shape, boxShape, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::boxShape::boxShape
(
    const word& name,
    const dictionary& dict,
    const fileName&
)
:
    shape(name, dict),
    box_(dict.get<point>("min"), dict.get<point>("max"))
{
    if (!(cmptMin(box_.span()) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'max' of box " << name << " is " << box_.max()
            << "; accepted are coordinates greater than those of 'min', "
            << box_.min() << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::melt::boxShape::support(const vector& n) const
{
    return
        (n & box_.midpoint()) + 0.5*(cmptMag(n) & box_.span());
}


// ************************************************************************* //
