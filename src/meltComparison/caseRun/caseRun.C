/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseRun.H"
#include "clockTime.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "Time.H"

#include <fstream>
#include <iterator>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Append the files in a directory, and below it unless flat, as paths
//  relative to the case
void appendFiles
(
    const fileName& caseDirectory,
    const fileName& directory,
    const bool flat,
    DynamicList<fileName>& files
)
{
    // With extensions that OpenFOAM would filter, and links followed
    const fileName path(caseDirectory/directory);
    for (const fileName& name : readDir(path, fileName::FILE, false))
    {
        files.append(directory/name);
    }
    for (const fileName& name : readDir(path, fileName::DIRECTORY, false))
    {
        if (!flat)
        {
            appendFiles(caseDirectory, directory/name, flat, files);
        }
    }
}


string contents(const fileName& file)
{
    std::ifstream is(file);
    return string
    (
        std::string
        (
            std::istreambuf_iterator<char>(is),
            std::istreambuf_iterator<char>()
        )
    );
}

//- What is asked of results, not how they come about
bool ofReport(const fileName& file)
{
    return
        file == "system/meltCompareDict" || file == "system/meltToPovDict";
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileNameList Foam::melt::caseRun::files() const
{
    DynamicList<fileName> all;
    appendFiles(source_, "0", true, all);
    appendFiles(source_, "system", false, all);
    appendFiles(source_, "constant", false, all);

    // A mesh that the solver makes depends on method and resolution
    DynamicList<fileName> cloned;
    const bool ownMesh = isFile(source_/"system"/"blockMeshDict");
    for (const fileName& file : all)
    {
        if (!(ownMesh && file.path().name() == "polyMesh"))
        {
            cloned.append(file);
        }
    }
    return fileNameList(cloned);
}


void Foam::melt::caseRun::checkClone() const
{
    for (const fileName& file : files())
    {
        if (ofReport(file))
        {
            continue;
        }
        if
        (
            !isFile(dir_/file)
         || contents(source_/file) != contents(dir_/file)
        )
        {
            FatalErrorInFunction
                << dir_/file << " differs from that of the case " << source_
                << nl << "Remove " << dir_ << " to have it made again"
                << exit(FatalError);
        }
    }
}


bool Foam::melt::caseRun::finished() const
{
    const instantList times(Time::findTimes(dir_));
    const dictionary controlDict
    (
        IFstream(dir_/"system"/Time::controlDictName)()
    );
    const scalar endTime = controlDict.get<scalar>("endTime");

    return
        times.size()
     && times.last().name() != "constant"
     && times.last().value() >= endTime*(1 - 1e-9)
     && isDir(dir_/"postProcessing"/"meltRun");
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::caseRun::caseRun
(
    const fileName& source,
    const word& method,
    const scalar resolution
)
:
    source_(source),
    method_(method),
    resolution_(resolution),
    dir_
    (
        source + '.' + method
      + (resolution > 0 ? '.' + Foam::name(resolution) : string())
    )
{
    if (!isFile(source_/"system"/Time::controlDictName))
    {
        FatalErrorInFunction
            << "There is no case " << source_ << nl
            << "Expected: a directory with system/" << Time::controlDictName
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::caseRun::clone() const
{
    const bool cloned = isDir(dir_);
    if (cloned)
    {
        checkClone();
    }

    for (const fileName& file : files())
    {
        if (cloned && !ofReport(file))
        {
            continue;
        }
        mkDir((dir_/file).path());
        // Scripts that make geometry stay executable
        if
        (
            !cp(source_/file, dir_/file)
         || !chMod(dir_/file, mode(source_/file))
        )
        {
            FatalErrorInFunction
                << "Cannot copy " << source_/file << " to " << dir_
                << exit(FatalError);
        }
    }
}


void Foam::melt::caseRun::run() const
{
    if (finished())
    {
        Info<< "    " << dir_.name() << ": has run already" << endl;
        return;
    }

    Info<< "    " << dir_.name() << ": " << flush;
    const clockTime timer;
    const fileName log(dir_/"log.meltFoam");
    const int status = Foam::system
    (
        "meltFoam -case '" + dir_ + "' -method " + method_
      + (
            resolution_ > 0
          ? " -resolution " + Foam::name(resolution_) : string()
        )
      + " > '" + log + "' 2>&1 < /dev/null"
    );

    if (status != 0)
    {
        const string text(contents(log));
        const std::string::size_type shown = 2000;
        Info<< "failed" << endl;
        FatalErrorInFunction
            << "meltFoam failed with status " << status << ", log " << log
            << ":" << nl
            << text.substr(max(text.size(), shown) - shown).c_str()
            << exit(FatalError);
    }
    Info<< timer.elapsedTime() << " s" << endl;
}


// ************************************************************************* //
