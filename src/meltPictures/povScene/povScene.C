/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "povScene.H"
#include "StringStream.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::melt::povScene::legendWidth = 0.17;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Colours that POV-Ray's maps and arrays may have
constexpr label nColours = 256;


//- From the middle of the scene, in picture units: far
constexpr scalar lampDistance = 40;

//- Of the lamp without shadows, relative to the other
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

Foam::string Foam::melt::povScene::text(const vector& v, const int digits)
{
    OStringStream os;
    os.precision(digits);
    os << '<' << v.x() << ',' << v.y() << ',' << v.z() << '>';
    return os.str();
}


Foam::string Foam::melt::povScene::place(const point& p) const
{
    // A ten thousandth of the picture suffices
    return text((p - camera_.target())*scale_, 6);
}


void Foam::melt::povScene::writeCamera(Ostream& os) const
{
    const scalar width = 2*camera_.halfWidth();
    os  << "camera" << nl << '{' << nl
        << "    perspective" << nl
        << "    location "
        << text((camera_.position() - camera_.target())*scale_).c_str() << nl
        << "    direction " << text(camera_.direction()).c_str() << nl
        << "    right " << text(width*camera_.right()).c_str() << nl
        << "    up " << text(width/camera_.aspect()*camera_.top()).c_str()
        << nl << '}' << nl << nl;
}


Foam::vector Foam::melt::povScene::towards
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


void Foam::melt::povScene::writeLights(Ostream& os) const
{
    os  << "// The lamp, and a weaker one without shadows" << nl
        << "light_source" << nl << '{' << nl
        << "    " << text(lampDistance*key_).c_str() << " rgb 1.0" << nl
        << "    area_light " << text(lampDistance*lampAxes_.first()).c_str()
        << ' ' << text(lampDistance*lampAxes_.second()).c_str()
        << " 5 5 adaptive 0 jitter" << nl
        << "    parallel point_at 0" << nl
        << '}' << nl
        << "light_source" << nl << '{' << nl
        << "    " << text(lampDistance*fill_).c_str() << " rgb "
        << fillBrightness << nl
        << "    shadowless parallel point_at 0" << nl
        << '}' << nl << nl;
}


Foam::pointField Foam::melt::povScene::shadow() const
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


void Foam::melt::povScene::writeFloor(Ostream& os) const
{
    const vector colour
    (
        dict_.lookupOrDefault("background", vector(1, 1, 1))
    );
    os  << "background { srgb " << text(colour).c_str() << " }" << nl << nl;

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
            << "    " << text((centre - camera_.target())*scale_).c_str()
            << ", " << text(camera_.vertical()).c_str() << ", "
            << radius*scale_ << nl
            << "    pigment { srgb " << text(colour).c_str() << " }" << nl
            << "    finish { ambient 0 emission " << shadowBrightness
            << " diffuse " << (1 - shadowBrightness)/light << " }" << nl
            << "    no_shadow" << nl
            << '}' << nl << nl;
    }
}


void Foam::melt::povScene::writeMaterial(Ostream& os) const
{
    os  << "#declare Wax = finish" << nl << '{' << nl
        << "    ambient 0 emission 0.22 diffuse 0.68" << nl
        << "    specular "
        << dict_.getCheckOrDefault<scalar>
           (
               "gloss", 0.3, scalarMinMax(0, 1)
           )
        << " roughness 0.05" << nl
        << "}" << nl
        << "#declare Colours = color_map" << nl << '{' << nl;
    for (label i = 0; i < nColours; ++i)
    {
        const scalar u = scalar(i)/(nColours - 1);
        os  << "    [" << u << " srgb " << text(colours_.colour(u)).c_str()
            << ']' << nl;
    }
    os  << '}' << nl << nl;
}


void Foam::melt::povScene::writeLegend(Ostream& os) const
{
    // Picture plane close to the camera: x and y in half heights
    const scalar halfHeight = camera_.halfWidth()/camera_.aspect();
    const scalar distance = 1;
    const scalar unit = distance*halfHeight;
    const vector origin
    (
        (camera_.position() - camera_.target())*scale_
      + distance*camera_.direction()
    );
    os  << "#declare OnPicture = transform" << nl << '{' << nl
        << "    matrix" << nl << "    <" << nl;
    for
    (
        const vector& axis :
        {unit*camera_.right(), unit*camera_.top(), unit*camera_.direction()}
    )
    {
        os  << "        " << axis.x() << ", " << axis.y() << ", " << axis.z()
            << ',' << nl;
    }
    os  << "        " << origin.x() << ", " << origin.y() << ", "
        << origin.z() << nl << "    >" << nl << '}' << nl
        << "#declare Ink = texture { pigment { srgb 0.15 }"
        << " finish { ambient 0 diffuse 0 emission 1 } }" << nl
        << "#macro Label(Text, Height, X, Y, Align)" << nl
        << "    #local Letters = text { internal 2 Text 0.001 0"
        << " scale <Height, Height, 1> }" << nl
        << "    #local Shift = Align*max_extent(Letters).x;" << nl
        << "    object { Letters translate <X - Shift, Y, 0>"
        << " texture { Ink } no_shadow transform { OnPicture } }" << nl
        << "#end" << nl << nl;

    if (!dict_.lookupOrDefault("legend", true))
    {
        return;
    }

    const scalar letter = 0.07;
    const scalar left = camera_.aspect() - 0.27;
    const scalar right = left + 0.06;
    const scalar bottom = -0.6;
    const scalar height = 1.2;
    const scalar frame = 0.005;
    os  << "box" << nl << '{' << nl
        << "    <" << left << ", 0, 0>, <" << right << ", 1, 0.001>" << nl
        << "    texture { pigment { gradient y color_map { Colours } }"
        << " finish { ambient 0 diffuse 0 emission 1 } }" << nl
        << "    scale <1, " << height << ", 1> translate " << bottom << "*y"
        << nl
        << "    no_shadow transform { OnPicture }" << nl
        << '}' << nl
        << "box" << nl << '{' << nl
        << "    <" << left - frame << ", " << bottom - frame << ", 0.002>, <"
        << right + frame << ", " << bottom + height + frame << ", 0.003>"
        << nl
        << "    texture { Ink } no_shadow transform { OnPicture }" << nl
        << '}' << nl
        << "Label(\"" << colours_.title().c_str() << "\", " << letter << ", "
        << camera_.aspect() - letter << ", " << bottom + height + letter
        << ", 1)" << nl;
    for (const colourScale::tick& t : colours_.ticks(6))
    {
        const scalar y = bottom + height*colours_.position(t.first());
        os  << "box" << nl << '{' << nl
            << "    <" << right << ", " << y - frame/2 << ", 0>, <"
            << right + letter/3 << ", " << y + frame/2 << ", 0.001>" << nl
            << "    texture { Ink } no_shadow transform { OnPicture }" << nl
            << '}' << nl
            << "Label(\"" << t.second().c_str() << "\", " << letter << ", "
            << right + letter/2 << ", " << y - letter/3 << ", 0)" << nl;
    }
    os  << nl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::povScene::povScene
(
    const dictionary& dict,
    const camera& view,
    const colourScale& colours,
    const boundBox& box,
    const boundBox& domain
)
:
    dict_(dict),
    camera_(view),
    colours_(colours),
    box_(box),
    scale_(10/max(box.mag(), VSMALL)),
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
    fill_(towards(50, 20)),
    floorHeight_(readFloor(dict, view.vertical(), domain))
{
    const scalar size = dict.getCheckOrDefault<scalar>
    (
        "lightSize", 0.4, scalarMinMax(0, 2)
    );
    const vector across
    (
        normalised
        (
            key_
          ^ (mag(key_ & view.right()) < mag(key_ & view.top())
          ? view.right() : view.top())
        )
    );
    lampAxes_ = Pair<vector>(size*across, size*(key_ ^ across));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::povScene::writeOptions(Ostream& os) const
{
    os  << "Width=" << camera_.width() << nl
        << "Height=" << camera_.height() << nl
        << "Display=Off" << nl
        << "Output_File_Type=N" << nl
        << "Antialias=On" << nl
        << "Antialias_Threshold=0.2" << nl
        << "Antialias_Depth=2" << nl
        << "Sampling_Method=2" << nl;
}


void Foam::melt::povScene::writeStage(Ostream& os) const
{
    os  << "// " << camera_.width() << " x " << camera_.height() << " pixels"
        << nl
        << "#version 3.7;" << nl
        << "global_settings { assumed_gamma 1 max_trace_level 3 }" << nl << nl;
    writeCamera(os);
    writeLights(os);
    writeFloor(os);
    writeMaterial(os);
    writeLegend(os);
}


void Foam::melt::povScene::writeSpheres
(
    Ostream& os,
    const pointField& positions,
    const scalarField& volumes,
    const scalarField& values
) const
{
    os  << "#declare C = array[" << nColours << ']' << nl
        << "#for (I, 0, " << nColours - 1 << ')' << nl
        << "    #declare C[I] = texture { pigment { gradient x"
        << " color_map { Colours } translate -(I + 0.5)/" << nColours
        << "*x scale 1e6 } finish { Wax } }" << nl
        << "#end" << nl;
    forAll(positions, i)
    {
        const scalar radius =
            Foam::cbrt(3*volumes[i]/(4*constant::mathematical::pi));
        const label colour = min
        (
            label(colours_.position(values[i])*nColours), nColours - 1
        );
        os  << "sphere{" << place(positions[i]).c_str() << ','
            << radius*scale_ << " texture{C[" << colour << "]}}" << nl;
    }
    os  << nl;
}


void Foam::melt::povScene::writeSurface
(
    Ostream& os,
    const particleSurface& surface,
    const scalarField& values
) const
{
    const pointField points(surface.points());
    const vectorField normals(surface.normals());
    const faceList triangles(surface.faces());
    if (triangles.empty())
    {
        return;
    }

    os  << "mesh2" << nl << '{' << nl
        << "vertex_vectors{" << points.size() << nl;
    for (const point& p : points)
    {
        os  << place(p).c_str() << nl;
    }
    os  << '}' << nl << "normal_vectors{" << normals.size() << nl;
    for (const vector& n : normals)
    {
        os  << text(n).c_str() << nl;
    }
    os  << '}' << nl << "uv_vectors{" << values.size() << nl;

    // Clear of the ends: the gradient pattern is periodic
    const scalar end = 0.5/nColours;
    for (const scalar value : values)
    {
        os  << '<' << end + (1 - 2*end)*colours_.position(value) << ",0>"
            << nl;
    }
    os  << '}' << nl << "face_indices{" << triangles.size() << nl;
    for (const face& t : triangles)
    {
        os  << '<' << t[0] << ',' << t[1] << ',' << t[2] << '>' << nl;
    }
    os  << '}' << nl
        << "texture { uv_mapping pigment { gradient x color_map { Colours } }"
        << " finish { Wax } }" << nl
        << '}' << nl << nl;
}


void Foam::melt::povScene::writeTime(Ostream& os, const word& timeName) const
{
    if (dict_.lookupOrDefault("time", true))
    {
        const scalar letter = 0.07;
        os  << "Label(\"t = " << timeName << " s\", " << letter << ", "
            << letter - camera_.aspect() << ", " << letter - 1 << ", 0)"
            << nl;
    }
}


// ************************************************************************* //
