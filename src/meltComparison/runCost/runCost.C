/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runCost.H"
#include "diagnosticsTable.H"
#include "dictionary.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::runCost::runCost(const fileName& caseDirectory)
{
    const diagnosticsTable table(caseDirectory, "meltRun");

    const dictionary what(IStringStream(table.comment())());
    method = what.get<word>("method");
    resolution = what.get<scalar>("resolution");
    threads = what.get<label>("threads");
    ranks = what.get<label>("ranks");

    steps = label(table["steps"].last());
    particles = label(table["particles"].last());
    peakMemory = max(table["peakMemory"]);

    // These begin at zero in each part of the run
    const auto sum = [&](const word& name)
    {
        const scalarField& values = table[name];
        scalar total = values.last();
        for (label i = 1; i < values.size(); ++i)
        {
            if (values[i] < values[i - 1])
            {
                total += values[i - 1];
            }
        }
        return total;
    };
    particleSteps = sum("particleSteps");
    wallTime = sum("wallTime");
    cpuTime = sum("cpuTime");
}


// ************************************************************************* //
