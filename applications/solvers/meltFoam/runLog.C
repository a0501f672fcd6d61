/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runLog.H"
#include "checkedEntry.H"
#include "clockValue.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::melt::runLog::progress Foam::melt::runLog::now() const
{
    return
    {
        clockValue::now(),
        time_.value(),
        time_.timeIndex(),
        method_.particleSteps()
    };
}


Foam::scalar Foam::melt::runLog::timeLeft(const progress& present) const
{
    const scalar clock = present.clock - start_.clock;

    const scalar share = max
    (
        (present.time - start_.time)
       /(time_.endTime().value() - start_.time),
        scalar(present.timeIndex - start_.timeIndex)
       /scalar(time_.maxSteps() - start_.timeIndex)
    );

    return clock*(1 - share)/share;
}


void Foam::melt::runLog::print(const meltDiagnostics& figures)
{
    Info<< "Time = " << time_.timeName() << nl << nl
        << "step " << time_.timeIndex();

    if (time_.timeIndex() > start_.timeIndex)
    {
        Info<< ", deltaT = " << time_.deltaTValue() << " s, limit: "
            << method_.deltaTLimit();
    }

    Info<< nl
        << method_.particleName() << ": " << method_.nParticles() << ", effects:";

    for (const word& effect : scene_.effects().active())
    {
        Info<< ' ' << effect;
    }

    Info<< nl
        << "mass: " << figures.mass
        << " kg, melted: " << 100*figures.meltedFraction << " %" << nl
        << "energy: kinetic " << figures.kineticEnergy
        << " J, potential " << figures.potentialEnergy
        << " J, thermal " << figures.thermalEnergy << " J" << nl
        << "max |U| = " << figures.maxU
        << " m/s, T = " << figures.minT << " .. " << figures.maxT << " K" << nl;

    method_.report(Info);

    Info<< "ExecutionTime = " << time_.elapsedCpuTime() << " s"
        << "  ClockTime = " << time_.elapsedClockTime() << " s" << nl;

    const progress present(now());

    if (present.clock > last_.clock && present.time > start_.time)
    {
        Info<< "particle-steps/s: "
            << (present.particleSteps - last_.particleSteps)
              /(present.clock - last_.clock)
            << ", estimated time left: " << label(timeLeft(present) + 1)
            << " s" << nl;
    }

    Info<< endl;
    last_ = present;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::runLog::runLog
(
    const meltTime& time,
    const meltScene& scene,
    const meltMethod& method,
    const bool verbose
)
:
    time_(time),
    scene_(scene),
    method_(method),
    verbose_(verbose),
    interval_
    (
        label
        (
            checkedEntry::getOrDefault
            (
                time.controlDict(),
                "diagnosticsInterval",
                dimless,
                scalarMinMax(1, labelMax),
                10
            )
        )
    ),
    file_(scene.mesh()),
    record_(scene, method),
    start_(now()),
    last_(start_)
{
    const meltDiagnostics figures(method_.diagnostics());
    print(figures);
    file_.write(figures);
    record_.write();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::runLog::step()
{
    const bool block = verbose_ || time_.writeTime();

    if (!block && time_.timeIndex() % interval_)
    {
        return;
    }

    const meltDiagnostics figures(method_.diagnostics());

    if (!figures.finite())
    {
        FatalErrorInFunction
            << "The state is infinite or not a number at time "
            << time_.timeName() << " s, step " << time_.timeIndex() << '.'
            << nl << "Results written before are as they were."
            << exit(FatalError);
    }

    if (block)
    {
        print(figures);
    }

    file_.write(figures);

    if (time_.writeTime())
    {
        record_.write();
    }
}


void Foam::melt::runLog::end()
{
    if (!time_.writeTime())
    {
        record_.write();
    }
    record_.print();
}


// ************************************************************************* //
