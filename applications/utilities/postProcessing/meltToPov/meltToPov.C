/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    meltToPov

Description
    Writes a scene for the ray tracer POV-Ray per time: the particles of a
    cloud as spheres or as a surface, coloured by a field, with a legend. The
    script meltFilm renders the scenes and makes a film of them.

    Camera and colours are the same at all times: unless given, they follow
    from the particles at all times of the case. A scene that would not change
    is not touched.

Usage
    \b meltToPov [OPTION]

      - \par -field \<name\>
        Field for the colours, in place of the dictionary's

      - \par -representation spheres|surface
        In place of the dictionary's

      - \par -time, -latestTime, -noZero
        Times to write; all by default

    Dictionary system/meltToPovDict, all entries optional, annotated in
    etc/caseDicts/meltFoam/meltToPovDict:
    \verbatim
    cloud           melt;
    field           T;
    representation  spheres;
    camera  { azimuth -20; }
    colours { range (293 343); }
    \endverbatim
    See pictureDictionary, camera, colourScale, povScene, particleSurface and
    cloudSnapshot for all entries.

    Results: postProcessing/meltToPov/<cloud>_<representation>_<field>/<time>.pov

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "timeSelector.H"
#include "polyMesh.H"
#include "pictureDictionary.H"
#include "pictureSeries.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Write a POV-Ray scene per time from the particles of a cloud"
    );
    argList::noParallel();
    timeSelector::addOptions(false, false);
    argList::addOption("field", "name", "Field for the colours");
    argList::addOption
    (
        "representation",
        "word",
        "Draw particles as 'spheres' or their 'surface'"
    );
    #include "setRootCase.H"
    #include "createTime.H"
    const instantList times(timeSelector::select0(runTime, args));
    #include "createPolyMesh.H"

    const melt::pictureDictionary dict
    (
        runTime, args, {"field", "representation"}
    );
    const melt::pictureSeries pictures(dict, runTime, mesh);
    pictures.writeOptions();
    Info<< "Directory: " << pictures.dir() << nl << endl;

    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        pictures.write();
    }

    Info<< nl << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
