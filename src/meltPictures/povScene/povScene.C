/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "povScene.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Colours that POV-Ray's maps and arrays may have
constexpr label nColours = 256;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::melt::povVector
Foam::melt::povScene::place(const point& p) const
{
    // A ten thousandth of the picture suffices
    return povVector((p - camera_.target())*scale_, 6);
}


void Foam::melt::povScene::writeCamera(Ostream& os) const
{
    const scalar width = 2*camera_.halfWidth();
    os  << "camera" << nl << '{' << nl
        << "    perspective" << nl
        << "    location "
        << povVector((camera_.position() - camera_.target())*scale_) << nl
        << "    direction " << povVector(camera_.direction()) << nl
        << "    right " << povVector(width*camera_.right()) << nl
        << "    up " << povVector(width/camera_.aspect()*camera_.top())
        << nl << '}' << nl << nl;
}


void Foam::melt::povScene::writeMaterial(Ostream& os) const
{
    os  << "#declare Wax = finish" << nl << '{' << nl
        << "    ambient 0 emission 0.22 diffuse 0.68" << nl
        << "    specular " << gloss_ << " roughness 0.05" << nl
        << "}" << nl
        << "#declare Colours = color_map" << nl << '{' << nl;
    for (label i = 0; i < nColours; ++i)
    {
        const scalar u = scalar(i)/(nColours - 1);
        os  << "    [" << u << " srgb " << povVector(colours_.colour(u))
            << ']' << nl;
    }
    os  << '}' << nl << nl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::povScene::povScene
(
    const dictionary& dict,
    const camera& view,
    const colourScale& colours,
    const boundBox& box,
    const boundBox& domain,
    const fileName& caseDirectory
)
:
    camera_(view),
    colours_(colours),
    scale_(10/max(box.mag(), VSMALL)),
    gloss_
    (
        dict.getCheckOrDefault<scalar>("gloss", 0.3, scalarMinMax(0, 1))
    ),
    lights_(dict, view, box, domain),
    legend_(dict, view, colours),
    scenery_(dict, caseDirectory)
{}


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
    lights_.writeLamps(os);
    lights_.writeFloor(os, scale_);
    writeMaterial(os);
    scenery_.write(os, camera_.target(), scale_);
    legend_.write(os, scale_);
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
        os  << "sphere{" << place(positions[i]) << ','
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
        os  << place(p) << nl;
    }
    os  << '}' << nl << "normal_vectors{" << normals.size() << nl;
    for (const vector& n : normals)
    {
        os  << povVector(n) << nl;
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


// ************************************************************************* //
