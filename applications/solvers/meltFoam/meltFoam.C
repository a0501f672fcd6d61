/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    meltFoam

Description
    Melting and flowing of highly viscous materials: a case says what melts, a
    method says how it is computed, and this program walks through time.

    What the case lacks is made first: the mesh of its domain from
    system/blockMeshDict, its geometry as the shapes in constant/meltProperties
    say (entry make).

Usage
    \verbatim
    meltFoam -case bunny
    meltFoam -case bunny -method sph -resolution 0.002 -verbose
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "domainMesh.H"
#include "fvMesh.H"
#include "profiling.H"
#include "runLog.H"
#include "sigFpe.H"
#include "stepShares.H"

using namespace Foam;
using namespace Foam::melt;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::addNote("Melting and flowing of highly viscous materials");
    argList::addOption("method", "name", "Overrides method of controlDict");
    argList::addOption
    (
        "resolution", "m", "Overrides resolution of controlDict and nParticles"
    );
    argList::addBoolOption("verbose", "Log each step, not only write times");

    argList args(argc, argv);
    if (!args.checkRootCase())
    {
        FatalError.exit();
    }

    // Vectorised loops compute branches that are not taken: results are
    // checked to be finite, exceptions would be false alarms
    sigFpe::unset();

    meltTime runTime(args);
    domainMesh::makeIfMissing(runTime);

    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );

    const scalar resolution = args.opt<scalar>("resolution", 0);
    if (args.found("resolution") && !(resolution > 0))
    {
        FatalErrorInFunction
            << "Option -resolution is " << resolution
            << ", accepted: a number > 0 [m]" << exit(FatalError);
    }

    const meltScene scene(mesh, resolution);
    scene.effects().report(Info);

    autoPtr<meltMethod> method
    (
        meltMethod::New
        (
            args.found("method")
          ? args.opt<word>("method")
          : runTime.controlDict().get<word>("method"),
            mesh,
            scene
        )
    );

    runLog log(runTime, scene, *method, args.found("verbose"));

    const auto write = [&]() { method->write(); };

    if (runTime.value() == 0)
    {
        runTime.writeChecked(write);
    }

    while (runTime.run())
    {
        const scalar deltaT = runTime.advance(method->maxDeltaT());

        {
            addProfiling(advance, stepShares::step);
            method->advance(deltaT);
        }

        log.step();

        if (runTime.writeTime())
        {
            runTime.writeChecked(write);
        }
    }

    log.end();
    stepShares::print(Info);

    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
