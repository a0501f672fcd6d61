/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltDiagnosticsFile.H"
#include "fvMesh.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::meltDiagnosticsFile::meltDiagnosticsFile
(
    const fvMesh& mesh,
    const word& name
)
:
    // Digits enough for energies of which the difference matters
    writeFile
    (
        mesh,
        name,
        "meltDiagnostics",
        dictionary(IStringStream("writePrecision 12;")())
    )
{
    if (writeToFile_)
    {
        file() << "# time[s]" << tab << "steps[-]" << tab << "deltaT[s]";
        meltDiagnostics::writeHeader(file());
        file() << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::meltDiagnosticsFile::write(const meltDiagnostics& diagnostics)
{
    if (writeToFile_)
    {
        const Time& time = fileObr_.time();

        file()
            << time.value() << tab << time.timeIndex() << tab
            << time.deltaTValue();
        diagnostics.write(file());
        file() << endl;

        if (!file().good())
        {
            FatalIOErrorInFunction(file())
                << "Cannot write: is the disk full?" << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
