/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pictureDictionary.H"
#include "Enum.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const Enum<bool> representationNames
({
    { false, "spheres" },
    { true, "surface" }
});


//- What there is to set, per dictionary; that of the file itself first
const List<Tuple2<word, wordList>> knownEntries
({
    {
        word(),
        {
            "FoamFile", "cloud", "field", "representation", "spacing",
            "camera", "colours", "look", "surface"
        }
    },
    {
        "camera",
        {
            "azimuth", "elevation", "angle", "margin", "box", "up", "width",
            "height"
        }
    },
    { "colours", { "range", "scale", "map", "title" } },
    {
        "look",
        {
            "floor", "background", "lightAzimuth", "lightElevation",
            "lightSize", "gloss", "legend", "time", "scenery", "sceneryColour"
        }
    },
    { "surface", { "radius", "shading", "voxel", "level" } }
});


void checkEntries(const dictionary& dict, const wordList& known)
{
    for (const entry& e : dict)
    {
        if (!known.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown entry " << e.keyword() << " in " << dict.name()
                << nl << "Accepted: " << flatOutput(known)
                << exit(FatalIOError);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::pictureDictionary::pictureDictionary
(
    const Time& runTime,
    const argList& args,
    const wordList& options
)
:
    IOdictionary
    (
        IOobject
        (
            "meltToPovDict",
            runTime.system(),
            runTime,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    )
{
    // Defaults become entries, so that the digest tells what is drawn, not how
    // it was asked for
    lookupOrAddDefault<word>("cloud", "melt");
    lookupOrAddDefault<word>("field", "T");
    lookupOrAddDefault<word>("representation", representationNames[false]);
    for (const word& option : options)
    {
        if (args.found(option))
        {
            set(option, args.get<word>(option));
        }
    }

    for (const auto& known : knownEntries)
    {
        const word& name = known.first();
        const dictionary& dict = *this;
        checkEntries
        (
            name.empty() ? dict : dict.subOrEmptyDict(name),
            known.second()
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::pictureDictionary::surface() const
{
    return representationNames.get("representation", *this);
}


// ************************************************************************* //
