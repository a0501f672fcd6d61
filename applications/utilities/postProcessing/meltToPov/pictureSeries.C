/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pictureSeries.H"
#include "particleSurface.H"
#include "Fstream.H"
#include "OSspecific.H"
#include "StringStream.H"
#include "Time.H"
#include "UIndirectList.H"
#include "clockTime.H"
#include "cloud.H"
#include "uniformDimensionedFields.H"

#include <fstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::melt::pictureSeries::extent Foam::melt::pictureSeries::findExtent
(
    Time& runTime,
    const polyMesh& mesh,
    const word& cloudName,
    const word& fieldName
)
{
    extent result;

    const instant now(runTime.value(), runTime.timeName());
    const label nowIndex = runTime.timeIndex();
    for (const instant& time : runTime.times())
    {
        runTime.setTime(time, 0);
        if (cloudSnapshot::found(mesh, cloudName))
        {
            const cloudSnapshot particles(mesh, cloudName);
            result.box.add(particles.positions());
            result.range += scalarMinMax(particles.field(fieldName)());
            result.fieldTitle = particles.fieldTitle(fieldName);
        }
    }
    runTime.setTime(now, nowIndex);

    if (result.box.empty())
    {
        FatalErrorInFunction
            << "No particles of cloud " << cloudName << " at any time in "
            << runTime.path() << nl
            << "Expected: <time>/" << cloud::prefix << '/' << cloudName
            << "/positions or coordinates" << exit(FatalError);
    }
    return result;
}


Foam::vector Foam::melt::pictureSeries::upward(const polyMesh& mesh)
{
    IOobject io
    (
        "g",
        mesh.time().constant(),
        mesh.time(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (io.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        const vector g(uniformDimensionedVectorField(io).value());
        if (mag(g) > 0)
        {
            return -g;
        }
    }
    return vector(0, 1, 0);
}


bool Foam::melt::pictureSeries::upToDate(const fileName& scene) const
{
    const fileName data
    (
        mesh_.time().timePath()/mesh_.dbDir()/cloud::prefix/cloudName_
    );
    const double written = highResLastModified(scene);
    for (const fileName& file : readDir(data, fileName::FILE, false))
    {
        if (!(written > highResLastModified(data/file)))
        {
            return false;
        }
    }

    std::ifstream is(scene);
    string begin(stage_.size(), '\0');
    is.read(&begin[0], begin.size());
    return is.good() && begin == stage_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::pictureSeries::pictureSeries
(
    const pictureDictionary& dict,
    Time& runTime,
    const polyMesh& mesh
)
:
    mesh_(mesh),
    dict_(dict),
    cloudName_(dict.cloudName()),
    fieldName_(dict.fieldName()),
    surface_(dict.surface()),
    extent_(findExtent(runTime, mesh, cloudName_, fieldName_)),
    camera_
    (
        dict_.subOrEmptyDict("camera"),
        extent_.box,
        upward(mesh),
        povLegend::width
    ),
    colours_
    (
        dict_.subOrEmptyDict("colours"),
        extent_.fieldTitle,
        extent_.range
    ),
    scene_
    (
        dict_.subOrEmptyDict("look"),
        camera_,
        colours_,
        extent_.box,
        mesh.bounds(),
        runTime.globalPath()
    ),
    dir_
    (
        runTime.globalPath()/"postProcessing"/"meltToPov"
       /cloudName_ + '_' + (surface_ ? "surface" : "spheres") + '_' + fieldName_
    )
{
    OStringStream os;
    os  << "// meltToPov, settings " << dict_.digest() << nl;
    scene_.writeStage(os);
    stage_ = os.str();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::pictureSeries::writeOptions() const
{
    mkDir(dir_);
    OFstream os(dir_/"povray.ini");
    scene_.writeOptions(os);
}


void Foam::melt::pictureSeries::write() const
{
    const word& timeName = mesh_.time().timeName();
    if (!cloudSnapshot::found(mesh_, cloudName_))
    {
        return;
    }

    const fileName scene(dir_/timeName + ".pov");
    Info<< "Scene " << scene.name() << ": ";
    if (upToDate(scene))
    {
        Info<< "up to date" << endl;
        return;
    }

    const clockTime timer;
    const cloudSnapshot particles(mesh_, cloudName_);
    const scalarField volumes(particles.volumes(dict_));
    const scalarField values(particles.field(fieldName_));

    // Complete or not there at all
    const fileName unfinished(scene + ".part");
    {
        OFstream os(unfinished);
        os.writeRaw(stage_.data(), stage_.size());
        if (surface_)
        {
            const autoPtr<particleSurface> tsurface
            (
                particleSurface::New
                (
                    dict_.subOrEmptyDict("surface"),
                    mesh_,
                    particles.positions(),
                    volumes
                )
            );
            const particleSurface& surface = *tsurface;
            scene_.writeSurface(os, surface, surface.interpolate(values));
            const labelList& lonely = surface.lonely();
            scene_.writeSpheres
            (
                os,
                pointField(particles.positions(), lonely),
                scalarField(volumes, lonely),
                scalarField(values, lonely)
            );
            Info<< surface.mesh().nTriangles() << " triangles, "
                << lonely.size() << " spheres";
        }
        else
        {
            scene_.writeSpheres(os, particles.positions(), volumes, values);
            Info<< values.size() << " spheres";
        }
        scene_.writeTime(os, timeName);
        if (!os.good())
        {
            FatalErrorInFunction
                << "Cannot write " << unfinished << exit(FatalError);
        }
    }
    mv(unfinished, scene);
    Info<< ", " << timer.elapsedTime() << " s" << endl;
}


// ************************************************************************* //
