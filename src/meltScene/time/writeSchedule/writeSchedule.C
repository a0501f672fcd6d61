/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeSchedule.H"
#include "checkedEntry.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::writeSchedule::writeSchedule(const dictionary& controlDict)
{
    using namespace checkedEntry;

    maxDeltaT_ = get(controlDict, "deltaT", dimTime, positive());

    const word control
    (
        controlDict.lookupOrDefault<word>("writeControl", "timeStep")
    );
    bySteps_ = control == "timeStep";

    if (!bySteps_ && control != "runTime" && control != "adjustableRunTime")
    {
        FatalIOErrorInFunction(controlDict.lookup("writeControl"))
            << "writeControl " << control << " is not supported." << nl
            << "Accepted: runTime, adjustableRunTime, timeStep"
            << exit(FatalIOError);
    }

    interval_ = get
    (
        controlDict,
        "writeInterval",
        bySteps_ ? dimless : dimTime,
        bySteps_ ? scalarMinMax(1, labelMax) : positive()
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::writeSchedule::nextWriteTime(const scalar time) const
{
    // A time within round-off of a write time counts as that write time
    const scalar k = std::floor(time/interval_ + ROOTSMALL) + 1;
    const scalar exact = k*interval_;

    // A restart reads the time from the name of its directory: where that is
    // the same number but for round-off (3*0.1 and 0.3), take that
    const scalar named = readScalar(Time::timeName(exact));

    return mag(named - exact) < SMALL*exact ? named : exact;
}


Foam::melt::writeSchedule::step Foam::melt::writeSchedule::next
(
    const scalar time,
    const label timeIndex,
    const scalar endTime,
    const scalar maxDeltaT
) const
{
    bool toWrite = false;
    scalar target = endTime;

    if (!bySteps_)
    {
        const scalar writeTime = nextWriteTime(time);
        toWrite = writeTime < endTime + ROOTSMALL*interval_;
        target = toWrite ? writeTime : endTime;
    }

    const scalar remaining = target - time;
    const scalar nSteps = std::ceil(remaining/min(maxDeltaT, maxDeltaT_));

    if (!(nSteps > 1))
    {
        return
        {
            remaining,
            target,
            bySteps_ ? (timeIndex + 1) % label(interval_) == 0 : toWrite
        };
    }

    const scalar deltaT = remaining/nSteps;

    return
    {
        deltaT,
        time + deltaT,
        bySteps_ && (timeIndex + 1) % label(interval_) == 0
    };
}


// ************************************************************************* //
