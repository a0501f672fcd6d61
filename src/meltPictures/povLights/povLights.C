/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "povLights.H"
#include "DynamicList.H"
#include "povVector.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- From the middle of the scene, in picture units: far
constexpr scalar lampDistance = 40;

//- The lamp without shadows: direction [deg], brightness over the other's
constexpr scalar fillAzimuth = 50;
constexpr scalar fillElevation = 20;
constexpr scalar fillBrightness = 0.3;

//- Brightness of the floor in full shadow, relative to the background
constexpr scalar shadowBrightness = 0.45;


//- Height of the floor, far below for "none"
scalar readFloor
(
    const dictionary& dict,
    const vector& vertical,
    const boundBox& domain
)
{
    const entry* floor = dict.findEntry("floor");
    if (floor && floor->stream().first().isNumber())
    {
        return readScalar(floor->stream());
    }

    const word name(dict.lookupOrDefault<word>("floor", "automatic"));
    if (name == "automatic")
    {
        return min(domain.points()() & vertical);
    }
    if (name != "none")
    {
        FatalIOErrorInFunction(dict)
            << "Entry floor of " << dict.name() << " is " << name << nl
            << "Accepted: automatic, none or a height [m]"
            << exit(FatalIOError);
    }
    return -GREAT;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::melt::povLights::towards
(
    const scalar azimuth,
    const scalar elevation
) const
{
    const vector& up = camera_.vertical();
    const vector front(normalised(camera_.right() ^ up));
    const scalar a = degToRad(azimuth);
    const scalar e = degToRad(elevation);
    return cos(e)*(cos(a)*front + sin(a)*camera_.right()) + sin(e)*up;
}


Foam::pointField Foam::melt::povLights::shadow() const
{
    const vector& up = camera_.vertical();
    DynamicList<point> points;
    const pointField corners(box_.points());
    for (const point& corner : corners)
    {
        const scalar height = max((corner & up) - floorHeight_, scalar(0));
        for (const scalar i : {-1, 1})
        {
            for (const scalar j : {-1, 1})
            {
                const vector ray
                (
                    key_
                  + i/2*lampAxes_.first() + j/2*lampAxes_.second()
                );

                // A lamp at the horizon has a shadow without end
                const scalar slope = max(ray & up, 0.05);
                const point p(corner - height/slope*ray);
                points.append(p + (floorHeight_ - (p & up))*up);
            }
        }
    }
    return pointField(std::move(points));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::povLights::povLights
(
    const dictionary& dict,
    const camera& view,
    const boundBox& box,
    const boundBox& domain
)
:
    camera_(view),
    box_(box),
    background_(dict.lookupOrDefault("background", vector(1, 1, 1))),
    key_
    (
        towards
        (
            dict.getCheckOrDefault<scalar>
            (
                "lightAzimuth", -45, scalarMinMax(-180, 180)
            ),
            dict.getCheckOrDefault<scalar>
            (
                "lightElevation", 50, scalarMinMax(1, 90)
            )
        )
    ),
    fill_(towards(fillAzimuth, fillElevation)),
    floorHeight_(readFloor(dict, view.vertical(), domain))
{
    const scalar size = dict.getCheckOrDefault<scalar>
    (
        "lightSize", 0.4, scalarMinMax(0, 2)
    );
    const vector& notAlong =
        mag(key_ & view.right()) < mag(key_ & view.top())
      ? view.right()
      : view.top();
    const vector across(normalised(key_ ^ notAlong));
    lampAxes_ = Pair<vector>(size*across, size*(key_ ^ across));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::povLights::writeLamps(Ostream& os) const
{
    os  << "// The lamp, and a weaker one without shadows" << nl
        << "light_source" << nl << '{' << nl
        << "    " << povVector(lampDistance*key_) << " rgb 1.0" << nl
        << "    area_light " << povVector(lampDistance*lampAxes_.first())
        << ' ' << povVector(lampDistance*lampAxes_.second())
        << " 5 5 adaptive 0 jitter" << nl
        << "    parallel point_at 0" << nl
        << '}' << nl
        << "light_source" << nl << '{' << nl
        << "    " << povVector(lampDistance*fill_) << " rgb "
        << fillBrightness << nl
        << "    shadowless parallel point_at 0" << nl
        << '}' << nl << nl;
}


void Foam::melt::povLights::writeFloor
(
    Ostream& os,
    const scalar scale
) const
{
    const povVector colour(background_);
    os  << "background { srgb " << colour << " }" << nl << nl;

    if (floorHeight_ > -GREAT)
    {
        // Where lit, the floor is exactly as bright as the background: it
        // needs to reach no farther than the shadow
        const pointField points(shadow());
        const point centre(boundBox(points, false).midpoint());
        const scalar radius = 1.1*max(mag(points - centre));
        const scalar light =
            (key_ + fillBrightness*fill_) & camera_.vertical();
        os  << "disc" << nl << '{' << nl
            << "    " << povVector((centre - camera_.target())*scale)
            << ", " << povVector(camera_.vertical()) << ", "
            << radius*scale << nl
            << "    pigment { srgb " << colour << " }" << nl
            << "    finish { ambient 0 emission " << shadowBrightness
            << " diffuse " << (1 - shadowBrightness)/light << " }" << nl
            << "    no_shadow" << nl
            << '}' << nl << nl;
    }
}


// ************************************************************************* //
