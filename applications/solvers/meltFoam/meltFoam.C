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
    meltFoam -case bunny -budget 60s
    meltFoam -case bunny -accuracy 0.03
    \endverbatim

    What -budget and -accuracy choose, and which option overrules which: see
    runChoice.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "domainMesh.H"
#include "effectTimes.H"
#include "fvMesh.H"
#include "runChoice.H"
#include "runLog.H"
#include "sigFpe.H"

using namespace Foam;
using namespace Foam::melt;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::addNote("Melting and flowing of highly viscous materials");
    runChoice::addOptions();
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

    const runChoice choice(args, mesh);
    const meltScene scene(mesh, choice.resolution(), choice.preset());
    scene.effects().report(Info);

    autoPtr<meltMethod> method(meltMethod::New(choice.method(), mesh, scene));
    choice.reportStart(method->maxDeltaT(), runTime);

    runLog log(runTime, scene, *method, args.found("verbose"));

    const auto write = [&]() { method->write(); };

    if (runTime.value() == 0)
    {
        runTime.writeChecked(write);
    }

    effectTimes::clear();
    while (runTime.run())
    {
        const scalar deltaT = runTime.advance(method->maxDeltaT());

        {
            const effectTimes::part timing(effectTimes::flow, "rest");
            method->advance(deltaT);
        }

        log.step();

        if (runTime.writeTime())
        {
            runTime.writeChecked(write);
        }
    }

    log.end();
    choice.reportEnd(log.cpuTime(), log.steps());
    method->divideTimes();
    scene.effects().reportTimes(Info);

    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
