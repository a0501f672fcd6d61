/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    meltSurface

Description
    Writes the surface of the particles of a cloud, the isosurface of the
    characteristic function chi, per time, for other programs: with the colour
    field's values in the formats that hold values (vtk, ensight, raw), the
    geometry alone in the others (obj, stl, ply).

Usage
    \b meltSurface [OPTION]

      - \par -format \<name\>
        vtk (default), obj, stl, ... as OpenFOAM's surface writers

      - \par -field \<name\>
        Field on the surface, in place of the dictionary's

      - \par -time, -latestTime, -noZero
        Times to write; all by default

    Entries cloud, field, spacing and surface of system/meltToPovDict, see
    meltToPov.

    Results: postProcessing/meltSurface/<time>/<cloud>.<format>

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "timeSelector.H"
#include "polyMesh.H"
#include "cloudSnapshot.H"
#include "particleSurface.H"
#include "pictureDictionary.H"
#include "surfaceWriter.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Write the surface of the particles of a cloud per time"
    );
    argList::noParallel();
    timeSelector::addOptions(false, false);
    argList::addOption("format", "name", "Surface format (default: vtk)");
    argList::addOption("field", "name", "Field on the surface");
    #include "setRootCase.H"
    #include "createTime.H"
    const instantList times(timeSelector::select0(runTime, args));
    #include "createPolyMesh.H"

    const melt::pictureDictionary dict(runTime, args, {"field"});
    const word cloudName(dict.cloudName());
    const word fieldName(dict.fieldName());

    autoPtr<surfaceWriter> writer
    (
        surfaceWriter::New(args.lookupOrDefault<word>("format", "vtk"))
    );
    writer->useTimeDir() = true;
    writer->isPointData() = true;

    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        if (!melt::cloudSnapshot::found(mesh, cloudName))
        {
            continue;
        }

        const melt::cloudSnapshot particles(mesh, cloudName);
        const autoPtr<melt::particleSurface> tsurface
        (
            melt::particleSurface::New
            (
                dict.subOrEmptyDict("surface"),
                mesh,
                particles.positions(),
                particles.volumes(dict)
            )
        );
        const melt::particleSurface& surface = *tsurface;

        const pointField points(surface.points());
        const faceList faces(surface.faces());
        writer->open
        (
            points,
            faces,
            runTime.globalPath()/"postProcessing"/"meltSurface"/cloudName,
            false
        );
        writer->beginTime(runTime);
        const fileName file
        (
            writer->write
            (
                fieldName,
                surface.interpolate(particles.field(fieldName))
            )
        );
        writer->endTime();
        writer->clear();

        Info<< "Time " << runTime.timeName() << ": " << faces.size()
            << " triangles around " << surface.mesh().volume()
            << " m3, outside it " << surface.lonely().size()
            << " particles: " << runTime.relativePath(file) << endl;
    }

    Info<< nl << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
