/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "geometryFile.H"
#include "dynamicCode.H"
#include "OSspecific.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

//- Where a file of this name may be
static fileNameList candidates(const fileName& file, const fileName& directory)
{
    if (file.isAbsolute())
    {
        return fileNameList({file});
    }

    return fileNameList
    ({
        directory/"constant/triSurface"/file,
        directory/"constant/geometry"/file,
        directory/file
    });
}


//- The first of the files that exists, as the master sees it; empty if none
static fileName firstExisting(const fileNameList& files)
{
    fileName found;
    for (const fileName& file : files)
    {
        if (found.empty() && isFile(file))
        {
            found = file;
        }
    }
    Pstream::scatter(found);

    return found;
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::melt::geometryFile::find
(
    const dictionary& dict,
    const fileName& caseDirectory
)
{
    const auto file = fileName(dict.get<fileName>("file")).expand();
    const fileNameList files(candidates(file, caseDirectory));

    const fileName found(firstExisting(files));
    if (!found.empty())
    {
        return found;
    }

    if (!dict.found("make"))
    {
        FatalIOErrorInFunction(dict.lookup("file"))
            << "Entry 'file' is " << file << ", which is not there." << nl
            << "It was searched as" << nl;
        for (const fileName& candidate : files)
        {
            FatalIOError << "    " << candidate << nl;
        }
        FatalIOError << exit(FatalIOError);
    }

    // The case directory is an argument, as it may contain any character
    const auto command = dict.get<string>("make");
    run
    (
        {"sh", "-c", "cd \"$0\" && " + command, caseDirectory},
        "run it there by hand to see what is wrong",
        dict
    );

    const fileName made(firstExisting(files));
    if (made.empty())
    {
        FatalIOErrorInFunction(dict.lookup("make"))
            << "The command of entry 'make', " << command << ", has not made "
            << file << exit(FatalIOError);
    }

    return made;
}


void Foam::melt::geometryFile::run
(
    const stringList& command,
    const string& remedy,
    const dictionary& dict,
    const fileName& unfinished
)
{
    if (!dynamicCode::allowSystemOperations)
    {
        FatalIOErrorInFunction(dict)
            << "The file of entry 'file' has to be made by" << nl
            << "    " << flatOutput(command) << nl
            << "but allowSystemOperations is off: run it by hand"
            << exit(FatalIOError);
    }

    label status = 0;
    if (Pstream::master())
    {
        status = Foam::system(command);
        if (status != 0)
        {
            rm(unfinished);
        }
    }
    Pstream::scatter(status);

    if (status != 0)
    {
        FatalIOErrorInFunction(dict)
            << "The file of entry 'file' could not be made by" << nl
            << "    " << flatOutput(command) << nl
            << "which returned " << status << ": " << remedy.c_str()
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
