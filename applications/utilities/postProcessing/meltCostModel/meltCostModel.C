/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    meltCostModel

Description
    Writes the cost model by which meltFoam -budget and -accuracy choose, from
    the points that meltCost has measured (see costFit, costModel).

Usage
    \b meltCostModel [OPTION] \<directory\>

    The directory has a file \<case\>.csv for each case, cost.csv of meltCost:
    \verbatim
    meltCostModel tutorials/accuracyCost/figures -output etc/costModel
    \endverbatim

      - \par -output \<file\>
        Required

      - \par -machine \<text\>
        On which the times were measured; default: that of /proc/cpuinfo

      - \par -extrapolation \<factor\>
        How much finer than the finest point the model may be used; default 1.5

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "costFit.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "SortableList.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

string thisMachine()
{
    IFstream is("/proc/cpuinfo");
    string line;
    while (is.good())
    {
        is.getLine(line);
        if (line.compare(0, 10, "model name") == 0)
        {
            return line.substr(line.find(':') + 2);
        }
    }
    return "unknown machine";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Fit the cost model to the points of meltCost");
    argList::noBanner();
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addArgument("directory");
    argList::addOption("output", "file", "Where the model is written");
    argList::addOption("machine", "text", "On which times were measured");
    argList::addOption("extrapolation", "factor", "Beyond the finest point");
    const argList args(argc, argv, false, false);

    const fileName directory(args[1]);
    if (!args.found("output"))
    {
        FatalErrorInFunction
            << "Option -output is missing" << exit(FatalError);
    }

    melt::costFit fit;
    SortableList<fileName> files(readDir(directory, fileName::FILE));
    for (const fileName& file : files)
    {
        if (file.ext() == "csv")
        {
            IFstream is(directory/file);
            fit.add(file.nameLessExt(), is);
        }
    }
    if (!fit.size())
    {
        FatalErrorInFunction
            << "There is no point in " << directory/"*.csv"
            << exit(FatalError);
    }

    dictionary model;
    model.add("machine", args.opt<string>("machine", thisMachine()));
    model.add("extrapolation", args.opt<scalar>("extrapolation", 1.5));
    model.add("classes", fit.classes());

    OFstream os(args.opt<fileName>("output"));
    os  << "// Cost model of meltFoam, see costModel.H. Written by meltCostModel from "
        << fit.size() << nl << "// points of meltCost" << nl << nl;
    model.write(os, false);

    return 0;
}


// ************************************************************************* //
