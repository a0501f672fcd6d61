/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writtenFiles.H"
#include "OSspecific.H"

#include <fstream>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::melt::writtenFiles::complete(const fileName& file)
{
    std::ifstream is(file, std::ios::binary | std::ios::ate);
    const std::streamoff size = is.tellg();

    if (!is || size <= 0)
    {
        return false;
    }

    // The banner at the begin and the divider at the end of OpenFOAM's files
    const std::string banner("/*-----");
    const std::string divider("***** //");

    std::string begin(banner.size(), ' ');
    is.seekg(0);
    is.read(&begin[0], begin.size());

    if (begin != banner)
    {
        return true;
    }

    std::string end(divider.size() + 1, ' ');
    is.clear();
    is.seekg(size - std::min<std::streamoff>(size, end.size()));
    is.read(&end[0], end.size());

    return end == divider + "\n";
}


Foam::scalar Foam::melt::writtenFiles::newest(const fileName& directory)
{
    scalar last = -1;

    for (const fileName& name : readDir(directory, fileName::FILE, false))
    {
        last = max(last, highResLastModified(directory/name));
    }

    for (const fileName& name : readDir(directory, fileName::DIRECTORY))
    {
        last = max(last, newest(directory/name));
    }

    return last;
}


Foam::fileName Foam::melt::writtenFiles::firstIncomplete
(
    const fileName& directory,
    const scalar after
)
{
    // Names with .gz
    for (const fileName& name : readDir(directory, fileName::FILE, false))
    {
        if
        (
            highResLastModified(directory/name) > after
         && !complete(directory/name)
        )
        {
            return directory/name;
        }
    }

    for (const fileName& name : readDir(directory, fileName::DIRECTORY))
    {
        const fileName found(firstIncomplete(directory/name, after));

        if (!found.empty())
        {
            return found;
        }
    }

    return fileName();
}


// ************************************************************************* //
