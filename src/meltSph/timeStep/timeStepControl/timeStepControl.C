/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeStepControl.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "error.H"

Foam::melt::timeStepControl::timeStepControl(const dictionary& dict)
:
    dict_(dict),
    maxDeltaT_
    (
        checkedEntry::getOrDefault
        (
            dict, "maxDeltaT", dimTime, checkedEntry::positive(), GREAT
        )
    )
{
    for (const char* name : {"acoustic", "force", "viscous", "thermal"})
    {
        if (dict.found(name))
        {
            coefficients_.insert
            (
                name,
                checkedEntry::get
                (
                    dict, name, dimless, checkedEntry::positive()
                )
            );
        }
    }
    const auto insert = [&](const word& name, const scalar byDefault)
    {
        coefficients_.insert
        (
            name,
            checkedEntry::getOrDefault
            (
                dict, name, dimless, checkedEntry::positive(), byDefault
            )
        );
    };
    insert("advective", 0.4);
    insert("density", 0.5);
    insert("pressure", 0.6);
    reset();
}


void Foam::melt::timeStepControl::reset()
{
    deltaT_ = maxDeltaT_;
    limit_ = "maxDeltaT";
    limits_.clear();
}


void Foam::melt::timeStepControl::limit(const word& name, const scalar scale)
{
    if (!(scale > 0))
    {
        FatalErrorInFunction
            << "The scale of time of the " << name << " limit is " << scale
            << " s: the run has diverged, a velocity, acceleration or"
            << " viscosity is not a number" << nl
            << "Try a smaller coefficient in timeStep of system/sphSolution"
            << exit(FatalError);
    }

    const auto coefficient = coefficients_.cfind(name);
    if (!coefficient.found())
    {
        FatalIOErrorInFunction(dict_)
            << "The chosen scheme and terms have a limit " << name
            << ": its coefficient is missing, accepted: a number > 0"
            << exit(FatalIOError);
    }
    const scalar deltaT = coefficient.val()*scale;
    limits_.set(name, deltaT);

    if (deltaT < deltaT_)
    {
        deltaT_ = deltaT;
        limit_ = name;
    }
}

// ************************************************************************* //
