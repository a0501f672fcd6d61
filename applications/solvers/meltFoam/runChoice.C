/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runChoice.H"
#include "IFstream.H"
#include "meltScene.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::runChoice::set(const word& method)
{
    const auto colon = method.find(':');
    method_ = method.substr(0, colon);
    preset_ = colon == word::npos ? "" : method.substr(colon + 1);
}


void Foam::melt::runChoice::choose
(
    const costRequest& request,
    const fvMesh& mesh,
    bool fixed
)
{
    const fileName file(getEnv("MELTFOAM_DIR")/"etc"/"costModel");
    if (!isFile(file))
    {
        FatalErrorInFunction
            << "There is no cost model " << file << nl
            << "Source etc/bashrc of meltFoam" << exit(FatalError);
    }
    const costModel model{dictionary(IFstream(file)())};

    const Time& time = mesh.time();
    const auto usable = [&](const word& method)
    {
        const auto colon = method.find(':');
        const word name(method.substr(0, colon));
        return
            (!fixed || name == method_)
         && (
                colon == word::npos
             || isFile
                (
                    time.globalPath()/time.system()
                   /name + "Solution." + method.substr(colon + 1)
                )
            );
    };

    const caseScales scales(meltScene(mesh, 0));
    chosen_.reset
    (
        new costModel::choice
        (
            model.choose
            (
                request, scales, usable
            )
        )
    );
    set(chosen_->method);
    resolution_ = chosen_->guess.resolution;

    Info<< "Chosen: " << *chosen_ << nl
        << "    as the "
        << (request.isBudget ? "most accurate" : "cheapest") << " of which "
        << (request.isBudget ? "CPU time" : "error") << " stays below "
        << request.limit << (request.isBudget ? " s" : "")
        << ", by what was measured in cases of class " << scales.caseClass
        << ' ' << flatOutput(chosen_->cases) << nl
        << "    on " << model.machine().c_str()
        << ", one thread. Ranges hold for such cases; the error of another one"
        << " is not known" << nl
        << "    " << scales.extent/resolution_
        << " elements across the least extent, duration " << scales.duration
        << nl << endl;
}


// * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * * //

void Foam::melt::runChoice::addOptions()
{
    argList::addOption
    (
        "method", "name", "Overrides method of controlDict; name or name:preset"
    );
    argList::addOption
    (
        "resolution", "m", "Overrides resolution of controlDict and nParticles"
    );
    argList::addOption
    (
        "budget",
        "time",
        "Choose method and resolution: the most accurate within this CPU time,"
        " as 60s, 5min, 2h"
    );
    argList::addOption
    (
        "accuracy",
        "error",
        "Choose method and resolution: the cheapest with this relative error,"
        " as 0.03"
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::runChoice::runChoice(const argList& args, const fvMesh& mesh)
:
    resolution_(args.opt<scalar>("resolution", 0))
{
    const bool given = args.found("resolution");
    const bool budget = args.found("budget");
    const bool accuracy = args.found("accuracy");

    if (given && !(resolution_ > 0))
    {
        FatalErrorInFunction
            << "Option -resolution is " << resolution_
            << ", accepted: a number > 0 [m]" << exit(FatalError);
    }
    if (budget + accuracy + given > 1)
    {
        FatalErrorInFunction
            << "Options -budget, -accuracy, -resolution: accepted is one of"
            << " them, for each decides the resolution" << exit(FatalError);
    }

    set
    (
        args.found("method")
      ? args.opt<word>("method")
      : mesh.time().controlDict().get<word>("method")
    );

    if (budget || accuracy)
    {
        choose
        (
            budget
          ? costRequest::budget(args.opt<string>("budget"))
          : costRequest::accuracy(args.opt<string>("accuracy")),
            mesh,
            args.found("method")
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::runChoice::reportStart
(
    const scalar maxDeltaT,
    const Time& time
) const
{
    if (!chosen_)
    {
        return;
    }

    const costCurve::guess& guess = chosen_->guess;
    const scalar steps =
        (time.endTime().value() - time.value())
       /min(maxDeltaT, time.controlDict().get<scalar>("deltaT"));

    Info<< "Steps: " << guess.steps << " expected, " << steps
        << " if all are as long as the first may be: CPU time "
        << guess.cpuTime*steps/guess.steps << " s" << nl << endl;
}


void Foam::melt::runChoice::reportEnd
(
    const scalar cpuTime,
    const label steps
) const
{
    if (!chosen_)
    {
        return;
    }

    const costCurve::guess& guess = chosen_->guess;

    Info<< "Predicted: CPU time " << guess.cpuTime << " s (up to "
        << guess.worstCpuTime() << " s), " << guess.steps << " steps" << nl
        << "Actual:    CPU time " << cpuTime << " s, " << steps << " steps; "
        << cpuTime/guess.cpuTime << " of what was predicted" << nl
        << "           error: predicted " << guess.error << " (up to "
        << guess.worstError()
        << "), actual not known without a reference" << nl << endl;
}


// ************************************************************************* //
