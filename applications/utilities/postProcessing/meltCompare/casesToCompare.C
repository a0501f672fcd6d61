/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "casesToCompare.H"
#include "caseRun.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Path without . and ..
fileName absolute(const fileName& dir)
{
    fileName path(dir.isAbsolute() ? dir : cwd()/dir);
    path.clean();
    return path;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::melt::casesToCompare::source(const argList& args)
{
    if (args.found("methods") == args.found("cases"))
    {
        FatalErrorInFunction
            << "Accepted: either -methods '(sph voxelAutomaton)', for the case"
            << " in -case, or -cases '(dir1 dir2)'" << exit(FatalError);
    }
    if (args.found("methods"))
    {
        return absolute(args.globalPath());
    }

    // None: caseSet says how many there have to be
    const fileNameList cases(args.getList<fileName>("cases"));
    return cases.empty() ? fileName() : absolute(cases[0]);
}


void Foam::melt::casesToCompare::runMethods
(
    const wordList& methods,
    const scalar resolution
)
{
    Info<< "Running " << source_.name() << " by " << methods << endl;

    for (const word& method : methods)
    {
        const caseRun run(source_, method, resolution);
        run.clone();
        run.run();
        dirs_.append(run.dir());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::casesToCompare::casesToCompare(const argList& args)
:
    source_(source(args))
{
    if (args.found("methods"))
    {
        const scalar resolution = args.opt<scalar>("resolution", 0);
        if (args.found("resolution") && !(resolution > 0))
        {
            FatalErrorInFunction
                << "Option -resolution is " << resolution
                << ", accepted: a number > 0 [m]" << exit(FatalError);
        }
        runMethods(args.getList<word>("methods"), resolution);
    }
    else
    {
        for (const fileName& dir : args.getList<fileName>("cases"))
        {
            dirs_.append(absolute(dir));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::casesToCompare::addOptions()
{
    argList::addOption("methods", "names", "Clone and run the case by these");
    argList::addOption("cases", "dirs", "Cases that have run, in place of it");
    argList::addOption("resolution", "m", "Of the clones, as for meltFoam");
}


// ************************************************************************* //
