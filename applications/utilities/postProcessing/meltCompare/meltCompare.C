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
    is in system/meltCompareDict of the case, or of the first of the cases: see
    comparisonSettings.

    Report: postProcessing/meltCompare/ of the case with the dictionary, see
    comparisonReport. Exit code: 0 if the tolerances hold, 2 if not, 1 if they
    could not be compared.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "casesToCompare.H"
#include "comparisonReport.H"
#include "comparisonSettings.H"

using namespace Foam;
using namespace Foam::melt;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::addNote("Compare what methods make of the same case");
    argList::noBanner();
    argList::noParallel();
    casesToCompare::addOptions();
    argList::addOption("report", "dir", "Directory of the report");
    argList::addBoolOption("noPictures", "Do not draw the melt");
    const argList args(argc, argv);

    const casesToCompare asked(args);
    caseSet cases(asked.dirs());
    const comparisonSettings settings(asked.source(), cases);

    PtrList<pairComparison> pairs(settings.compare(cases));
    comparisonReport report
    (
        args.lookupOrDefault<fileName>
        (
            "report", asked.source()/"postProcessing"/"meltCompare"
        ),
        asked.source().name(),
        cases,
        pairs,
        settings.tolerances()
    );
    report.writeCsv();
    report.writePlots();
    if (!args.found("noPictures"))
    {
        report.writePictures(settings.pictureTimes(), settings.pictures());
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
