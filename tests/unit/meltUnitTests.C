/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    meltUnitTests

Description
    Runs all unit tests of meltFoam. The tests need an argList and a Time, of
    which a program has one: they are made here, on a temporary empty case.

Usage
    \verbatim
    meltUnitTests [--gtest_filter=Kernel*]
    mpirun -np 2 meltUnitTests -parallel
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "argList.H"
#include "OSspecific.H"
#include "sigFpe.H"

#include <cstdlib>
#include <vector>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

Foam::Time* runTimePtr = nullptr;

} // End anonymous namespace


Foam::Time& Foam::melt::unitTest::runTime()
{
    return *runTimePtr;
}


int main(int argc, char* argv[])
{
    using namespace Foam;

    testing::InitGoogleTest(&argc, argv);

    char caseDir[] = "/tmp/meltUnitTests.XXXXXX";
    if (!mkdtemp(caseDir))
    {
        std::perror(caseDir);
        return EXIT_FAILURE;
    }

    std::vector<char*> arguments(argv, argv + argc);
    char caseOption[] = "-case";
    arguments.push_back(caseOption);
    arguments.push_back(caseDir);
    arguments.push_back(nullptr);
    int nArguments = arguments.size() - 1;
    char** argumentsPtr = arguments.data();

    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(nArguments, argumentsPtr);

    const dictionary controlDict
    (
        IStringStream
        (
            "startFrom startTime; startTime 0; stopAt endTime; endTime 1;"
            "deltaT 1; writeControl timeStep; writeInterval 1;"
            "writeFormat binary; timePrecision 12;"
        )()
    );

    int result = EXIT_FAILURE;
    {
        Time runTime
        (
            controlDict,
            args.rootPath(),
            args.caseName(),
            "system",
            "constant",
            false
        );
        runTimePtr = &runTime;

        // As in the solver: code compiled with -fno-trapping-math computes
        // what it does not use
        sigFpe::unset();

        mkDir(runTime.path());

        FatalError.throwExceptions();
        FatalIOError.throwExceptions();

        result = RUN_ALL_TESTS();
    }

    // Under mpirun the case is that of the master: a slave's own stayed empty
    rmDir(caseDir, true);

    // The destructor of argList ends the program with 0
    if (result != EXIT_SUCCESS)
    {
        std::exit(result);
    }
    return result;
}


// ************************************************************************* //
