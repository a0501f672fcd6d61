/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    meltCompare

Description
    Compares what methods make of the same case: overlap of the volumes and
    distance of the surfaces on a common grid, temperature, each column of the
    diagnostics, cost; beside the tolerances that the case gives.

Usage
    \verbatim
    meltCompare -case bunny -methods '(sph voxelAutomaton)'
    meltCompare -case bunny -methods '(sph voxelAutomaton)' -resolution 0.004
    meltCompare -cases '(coarse fine)'
    \endverbatim

    The first two clone the case, bunny.sph and bunny.voxelAutomaton, and run
    what has not run yet; the third takes cases that have run. What is compared
    is in system/meltCompareDict of the case, or of the first of the cases:

    \verbatim
    times           (0.05 0.1);
    gridSpacing     0.004;
    tolerances      { intersectionOverUnion 0.8; ... }
    pictures        { times (0 0.1); field T; representation surface; }
    \endverbatim

    \table
        Property    | Description                       | Unit | Required | Default
        times       | Times at which shapes are compared | s   | no | the last that all have
        gridSpacing | Edge of the cells of the common grid | m | no | the coarsest resolution
        tolerances  | See comparisonTolerances          |      | no | none
        pictures    | times: of the pictures, default those above; field, default
                      T; representation, default surface | | no |
    \endtable

    Report: postProcessing/meltCompare/ of the case with the dictionary, see
    comparisonReport. Exit code: 0 if the tolerances hold, 2 if not, 1 if they
    could not be compared.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "caseRun.H"
#include "caseSet.H"
#include "checkedEntry.H"
#include "comparisonReport.H"
#include "IOdictionary.H"
#include "IFstream.H"
#include "OSspecific.H"

using namespace Foam;
using namespace Foam::melt;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Path without . and ..
fileName absolute(const fileName& dir)
{
    fileName path(dir.isAbsolute() ? dir : cwd()/dir);
    path.clean();
    return path;
}


//- Clones of a case, run by each method
fileNameList runMethods
(
    const fileName& source,
    const wordList& methods,
    const scalar resolution
)
{
    Info<< "Running " << source.name() << " by " << methods << endl;

    fileNameList dirs;
    for (const word& method : methods)
    {
        const caseRun run(source, method, resolution);
        run.clone();
        run.run();
        dirs.append(run.dir());
    }
    return dirs;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::addNote("Compare what methods make of the same case");
    argList::noBanner();
    argList::noParallel();
    argList::addOption("methods", "names", "Clone and run the case by these");
    argList::addOption("cases", "dirs", "Cases that have run, in place of it");
    argList::addOption("resolution", "m", "Of the clones, as for meltFoam");
    argList::addOption("report", "dir", "Directory of the report");
    argList::addBoolOption("noPictures", "Do not draw the melt");
    const argList args(argc, argv);

    if (args.found("methods") == args.found("cases"))
    {
        FatalErrorInFunction
            << "Accepted: either -methods '(sph voxelAutomaton)', for the case"
            << " in -case, or -cases '(dir1 dir2)'" << exit(FatalError);
    }

    fileNameList dirs;
    if (args.found("methods"))
    {
        const scalar resolution = args.opt<scalar>("resolution", 0);
        if (args.found("resolution") && !(resolution > 0))
        {
            FatalErrorInFunction
                << "Option -resolution is " << resolution
                << ", accepted: a number > 0 [m]" << exit(FatalError);
        }
        dirs = runMethods
        (
            absolute(args.globalPath()),
            args.getList<word>("methods"),
            resolution
        );
    }
    else
    {
        for (const fileName& dir : args.getList<fileName>("cases"))
        {
            dirs.append(absolute(dir));
        }
    }
    caseSet cases(dirs);

    const fileName source
    (
        args.found("methods") ? absolute(args.globalPath()) : dirs[0]
    );
    const fileName dictFile(source/"system"/"meltCompareDict");
    dictionary dict;
    if (isFile(dictFile))
    {
        dict = dictionary(IFstream(dictFile)());
    }
    const comparisonTolerances tolerances
    (
        dict.subOrEmptyDict("tolerances"), cases[0].diagnostics().names()
    );

    scalarList times;
    if (!dict.readIfPresent("times", times))
    {
        times = scalarList(1, cases.lastCommonTime());
    }
    const scalar spacing = checkedEntry::getOrDefault
    (
        dict,
        "gridSpacing",
        dimLength,
        checkedEntry::positive(),
        cases.coarsestResolution()
    );

    Info<< "Comparing at " << times << " s on cells of " << spacing << " m"
        << endl;
    PtrList<pairComparison> pairs;
    forAll(cases, i)
    {
        for (label j = i + 1; j < cases.size(); ++j)
        {
            pairs.append
            (
                new pairComparison(cases[i], cases[j], times, spacing)
            );
        }
    }

    comparisonReport report
    (
        args.lookupOrDefault<fileName>
        (
            "report", source/"postProcessing"/"meltCompare"
        ),
        source.name(),
        cases,
        pairs,
        tolerances
    );
    report.writeCsv();
    report.writePlots();
    if (!args.found("noPictures"))
    {
        const dictionary pictures(dict.subOrEmptyDict("pictures"));
        report.writePictures
        (
            pictures.lookupOrDefault<scalarList>("times", times), pictures
        );
    }
    report.writeHtml();
    report.writeSummary(Info);

    if (!report.holds())
    {
        // A value returned from here is lost: the end of argList exits with 0
        UPstream::exit(2);
    }

    return 0;
}


// ************************************************************************* //
