/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shapeTransformation.H"
#include "coordinateRotation.H"
#include "diagTensor.H"
#include "Pair.H"
#include "transform.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

//- Entry \c scale: one factor, or one for each axis
static vector readScale(const dictionary& dict)
{
    vector scale(vector::one);

    if (dict.found("scale"))
    {
        ITstream& is = dict.lookup("scale");
        const token first(is);
        is.putBack(first);

        if (first.isNumber())
        {
            scale *= readScalar(is);
        }
        else
        {
            is >> scale;
        }
        dict.checkITstream(is, "scale");
    }

    if (!(cmptMin(cmptMag(scale)) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'scale' is " << scale << "; accepted is a number or a"
            << " vector (x y z), without zeros" << exit(FatalIOError);
    }

    return scale;
}


//- Rotation of one unit vector into another
static tensor rotationBetween(const vector& from, const vector& to)
{
    // OpenFOAM's rotationTensor mirrors opposite vectors. Here they are turned
    // by 180 degrees about a perpendicular of theirs
    if ((from & to) < 0 && magSqr(from ^ to) < SMALL)
    {
        const vector other
        (
            mag(from.x()) < mag(from.y()) ? vector(1, 0, 0) : vector(0, 1, 0)
        );
        vector axis(from ^ other);
        axis.normalise();
        return 2*(axis*axis) - I;
    }

    return rotationTensor(from, to);
}


//- Entry \c rotate: two vectors, or a coordinateRotation
static tensor readRotation(const dictionary& dict)
{
    if (!dict.found("rotate"))
    {
        return I;
    }

    if (dict.isDict("rotate"))
    {
        return coordinateRotation::New(dict.subDict("rotate"))->R();
    }

    const auto directions = dict.get<Pair<vector>>("rotate");
    if (!(mag(directions[0]) > 0 && mag(directions[1]) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'rotate' is " << directions << "; accepted are two"
            << " vectors ((from) (to)) that are not zero, or a dictionary of"
            << " a coordinateRotation" << exit(FatalIOError);
    }

    return rotationBetween
    (
        normalised(directions[0]),
        normalised(directions[1])
    );
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::shapeTransformation::shapeTransformation(const dictionary& dict)
:
    linear_(Zero),
    inverse_(Zero),
    translation_(dict.lookupOrDefault<vector>("translate", Zero))
{
    const vector scale(readScale(dict));
    const tensor rotation(readRotation(dict));

    linear_ = rotation & diagTensor(scale.x(), scale.y(), scale.z());
    inverse_ =
        diagTensor(1/scale.x(), 1/scale.y(), 1/scale.z()) & rotation.T();
}


// ************************************************************************* //
