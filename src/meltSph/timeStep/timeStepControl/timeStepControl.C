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
    maxDeltaT_
    (
        checkedEntry::getOrDefault
        (
            dict, "maxDeltaT", dimTime, checkedEntry::positive(), GREAT
        )
    )
{
    for (const word& name : {"acoustic", "force", "viscous", "thermal"})
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
    coefficients_.insert
    (
        "advective",
        checkedEntry::getOrDefault
        (
            dict, "advective", dimless, checkedEntry::positive(), 0.4
        )
    );
    reset();
}


void Foam::melt::timeStepControl::reset()
{
    deltaT_ = maxDeltaT_;
    limit_ = "maxDeltaT";
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

    const scalar deltaT = coefficients_[name]*scale;

    if (deltaT < deltaT_)
    {
        deltaT_ = deltaT;
        limit_ = name;
    }
}

// ************************************************************************* //
