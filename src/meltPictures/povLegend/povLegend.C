/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "povLegend.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::melt::povLegend::width = 0.18;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Height of the letters, in half heights of the picture
constexpr Foam::scalar letter = 0.07;

}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::povLegend::writePlane
(Ostream& os, const scalar scale) const
{
    // At distance 1 from the camera; x and y in half heights of the picture
    const scalar halfHeight = camera_.halfWidth()/camera_.aspect();
    const vector origin
    (
        (camera_.position() - camera_.target())*scale
      + camera_.direction()
    );
    os  << "#declare OnPicture = transform" << nl << '{' << nl
        << "    matrix" << nl << "    <" << nl;
    for
    (
        const vector& axis :
        {camera_.right(), camera_.top(), camera_.direction()}
    )
    {
        os  << "        " << halfHeight*axis.x() << ", "
            << halfHeight*axis.y() << ", " << halfHeight*axis.z() << ','
            << nl;
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
}


void Foam::melt::povLegend::writeBar(Ostream& os) const
{
    const scalar left = camera_.aspect() - 0.31;
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

Foam::melt::povLegend::povLegend
(
    const dictionary& dict,
    const camera& view,
    const colourScale& colours
)
:
    camera_(view),
    colours_(colours),
    bar_(dict.lookupOrDefault<Switch>("legend", true)),
    time_(dict.lookupOrDefault<Switch>("time", true))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::povLegend::write(Ostream& os, const scalar scale) const
{
    writePlane(os, scale);
    if (bar_)
    {
        writeBar(os);
    }
}


void Foam::melt::povLegend::writeTime
(
    Ostream& os,
    const word& timeName
) const
{
    if (time_)
    {
        os  << "Label(\"t = " << timeName << " s\", " << letter << ", "
            << letter - camera_.aspect() << ", " << letter - 1 << ", 0)"
            << nl;
    }
}


// ************************************************************************* //
