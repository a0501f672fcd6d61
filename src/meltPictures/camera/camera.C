/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "camera.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Least distance, and offset along one axis of the picture, for slopes low
//  and high of the picture's two edges. Corners relative to the box's middle
struct fit
{
    scalar distance;
    scalar upperBound;
    scalar lowerBound;
    scalar low;
    scalar high;

    fit
    (
        const pointField& corners,
        const vector& axis,
        const vector& direction,
        const scalar lowSlope,
        const scalar highSlope
    )
    :
        low(lowSlope),
        high(highSlope)
    {
        const scalarField along(corners & axis);
        const scalarField depth(corners & direction);
        lowerBound = max(along - high*depth);
        upperBound = min(along + low*depth);
        distance = (lowerBound - upperBound)/(low + high);
    }

    scalar offset(const scalar chosenDistance) const
    {
        return
            (
                (lowerBound - high*chosenDistance)
              + (upperBound + low*chosenDistance)
            )/2;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::camera::frame
(
    const boundBox& box,
    scalar margin,
    scalar rightMargin
)
{
    target_ = box.midpoint();
    const pointField corners(box.points()() - target_);

    const scalar halfHeight = halfWidth_/aspect();
    const scalar edge = 1 - 2*margin;
    const fit x
    (
        corners, right_, direction_, halfWidth_*edge,
        halfWidth_*(1 - 2*rightMargin)
    );
    const fit y
    (
        corners, top_, direction_, halfHeight*edge, halfHeight*edge
    );

    const scalar distance = max(x.distance, y.distance);
    position_ =
        target_ - distance*direction_
      + x.offset(distance)*right_ + y.offset(distance)*top_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::camera::camera
(
    const dictionary& dict,
    const boundBox& box,
    const vector& up,
    const scalar legendWidth
)
:
    width_
    (
        dict.getCheckOrDefault<label>
        (
            "width", 800, [](const label n) { return n > 0 && n % 2 == 0; }
        )
    ),
    height_
    (
        dict.getCheckOrDefault<label>
        (
            "height", 600, [](const label n) { return n > 0 && n % 2 == 0; }
        )
    ),
    halfWidth_
    (
        tan
        (
            degToRad
            (
                dict.getCheckOrDefault<scalar>
                (
                    "angle", 30, scalarMinMax(1, 150)
                )
            )/2
        )
    ),
    vertical_
    (
        normalised
        (
            dict.getCheckOrDefault<vector>
            (
                "up", up, [](const vector& v) { return mag(v) > 0; }
            )
        )
    ),
    direction_
    (
       -bearing
        (
            vertical_,
            dict.getCheckOrDefault<scalar>
            (
                "azimuth", -20, scalarMinMax(-360, 360)
            ),
            // From straight above there is no upward direction
            dict.getCheckOrDefault<scalar>
            (
                "elevation", 15, scalarMinMax(-89, 89)
            )
        )
    ),
    right_(normalised(direction_ ^ vertical_)),
    top_(right_ ^ direction_)
{
    const scalar margin = dict.getCheckOrDefault<scalar>
    (
        "margin", 0.06, [](const scalar m) { return m >= 0 && m < 0.4; }
    );
    frame
    (
        dict.found("box") ? boundBox(dict.lookup("box")) : box,
        margin,
        max(margin, legendWidth)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::melt::camera::project(const point& p) const
{
    const vector toPoint(p - position_);
    const scalar depth = toPoint & direction_;
    return vector
    (
        (toPoint & right_)/(depth*halfWidth_),
        (toPoint & top_)/(depth*halfWidth_/aspect()),
        depth
    );
}


Foam::vector Foam::melt::camera::bearing
(
    const vector& up,
    const scalar azimuth,
    const scalar elevation
)
{
    const vector vertical(normalised(up));

    // The horizontal axis nearest to x, or to y where up is x
    vector side(1, 0, 0);
    if (mag(vertical & side) > 1/sqrt(scalar(2)))
    {
        side = vector(0, 1, 0);
    }
    side = normalised(side - (side & vertical)*vertical);
    const vector front(side ^ vertical);

    const scalar a = degToRad(azimuth);
    const scalar e = degToRad(elevation);
    return cos(e)*(cos(a)*front + sin(a)*side) + sin(e)*vertical;
}


// ************************************************************************* //
