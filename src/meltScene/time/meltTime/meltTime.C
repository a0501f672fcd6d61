/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltTime.H"
#include "checkedEntry.H"
#include "argList.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "writtenFiles.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::meltTime::restoreTime()
{
    const IOdictionary timeDict
    (
        IOobject
        (
            "time",
            timeName(),
            "uniform",
            *this,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );

    scalar exact = 0;
    if
    (
        timeDict.readIfPresent("value", exact)
     && timeName(exact) == timeName()
    )
    {
        value() = exact;
    }

    // Time::run ends half a step before endTime
    setDeltaT(min(deltaTValue(), mag(endTime().value() - value())), false);
}


void Foam::melt::meltTime::readSchedule()
{
    schedule_ = writeSchedule(controlDict());
    maxSteps_ = label
    (
        checkedEntry::getOrDefault
        (
            controlDict(),
            "maxSteps",
            dimless,
            scalarMinMax(1, labelMax),
            labelMax
        )
    );

    writeControl_ = wcNone;

    if (timeIndex() >= maxSteps_)
    {
        setEndTime(value());
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::melt::meltTime::readDict()
{
    Time::readDict();
    readSchedule();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::meltTime::meltTime(const argList& args)
:
    Time(controlDictName, args),
    schedule_(controlDict())
{
    restoreTime();
    readSchedule();
}


Foam::melt::meltTime::meltTime(const fileName& caseDirectory)
:
    Time
    (
        controlDictName,
        caseDirectory.path(),
        caseDirectory.name(),
        "system",
        "constant",
        false,
        false
    ),
    schedule_(controlDict())
{
    restoreTime();
    readSchedule();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::meltTime::advance(const scalar maxDeltaT)
{
    if (!(maxDeltaT > 0))
    {
        FatalErrorInFunction
            << "The method allows a time step of " << maxDeltaT
            << " s at time " << timeName() << " s, step " << timeIndex()
            << ": its state has become infinite or not a number."
            << exit(FatalError);
    }

    const writeSchedule::step next = schedule_.next
    (
        value(),
        timeIndex(),
        endTime().value(),
        maxDeltaT
    );

    if (!(next.end > value()))
    {
        FatalErrorInFunction
            << "A time step of " << next.deltaT << " s is lost in round-off "
            << "at time " << value() << " s." << exit(FatalError);
    }

    if (next.write)
    {
        writeOnce();
    }

    if (timeIndex() + 1 >= maxSteps_)
    {
        stopAt(saWriteNow);
    }

    setDeltaT(next.deltaT, false);
    operator++();

    // Without the round-off of the sum
    value() = next.end;

    return next.deltaT;
}


void Foam::melt::meltTime::writeChecked(const std::function<void()>& prepare)
{
    const bool existed = isDir(timePath());

    // The user's own files in time 0 may end as they like
    const scalar before = writtenFiles::newest(timePath());
    fileName incomplete;

    // A stream that fails ends the program, if it is not caught
    const bool throwing = FatalIOError.throwExceptions();

    try
    {
        prepare();

        incomplete =
            writeNow()
          ? writtenFiles::firstIncomplete(timePath(), before)
          : timePath();
    }
    catch (const IOerror& err)
    {
        incomplete = err.ioFileName();
    }

    FatalIOError.throwExceptions(throwing);

    if (returnReduce(!incomplete.empty(), orOp<bool>()))
    {
        if (!existed)
        {
            rmDir(timePath());
        }

        FatalErrorInFunction
            << "Cannot write time " << timeName() << ": "
            << incomplete << " is incomplete." << nl
            << "Is the disk full? Earlier times are as they were"
            << (existed ? "." : ", this one has been removed.")
            << exit(FatalError);
    }
}


// ************************************************************************* //
