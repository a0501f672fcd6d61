/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "IStringStream.H"
#include "meltUnitTests.H"
#include "timeStepControl.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;

namespace
{

timeStepControl control(const std::string& further = "")
{
    return timeStepControl
    (
        dictionary
        (
            IStringStream
            (
                "acoustic 0.25; force 0.5; viscous 0.125; thermal 0.1;"
              + further
            )()
        )
    );
}

} // End anonymous namespace


TEST(TimeStepControl, smallestLimitRules)
{
    timeStepControl limits = control();
    EXPECT_EQ(limits.ruling(), "maxDeltaT");
    EXPECT_GE(limits.deltaT(), 1e10);

    limits.limit("acoustic", 0.4);
    EXPECT_EQ(limits.ruling(), "acoustic");
    EXPECT_DOUBLE_EQ(limits.deltaT(), 0.1);
    limits.limit("thermal", 2);
    EXPECT_EQ(limits.ruling(), "acoustic");
    limits.limit("viscous", 0.4);
    EXPECT_EQ(limits.ruling(), "viscous");
    EXPECT_DOUBLE_EQ(limits.deltaT(), 0.05);
    EXPECT_DOUBLE_EQ(limits.deltaT("acoustic"), 0.1);

    limits.reset();
    EXPECT_EQ(limits.ruling(), "maxDeltaT");
    EXPECT_GE(limits.deltaT("acoustic"), 1e10);
    limits.limit("force", 1);
    EXPECT_DOUBLE_EQ(limits.deltaT(), 0.5);
}


TEST(TimeStepControl, maxDeltaT)
{
    timeStepControl limits = control("maxDeltaT 0.01;");
    limits.limit("force", 1);
    EXPECT_EQ(limits.ruling(), "maxDeltaT");
    EXPECT_DOUBLE_EQ(limits.deltaT(), 0.01);
}


TEST(TimeStepControl, scaleThatIsNoTimeIsAnError)
{
    timeStepControl limits = control();
    EXPECT_THROW(limits.limit("force", 0), Foam::error);
    EXPECT_THROW(limits.limit("force", -1), Foam::error);
    EXPECT_THROW(limits.limit("force", std::nan("")), Foam::error);
    EXPECT_THROW(limits.limit("capillary", 1), Foam::error);
}


TEST(TimeStepControl, badCoefficients)
{
    EXPECT_THROW(control("viscous 0;"), Foam::IOerror);
    EXPECT_THROW(control("viscous -0.1;"), Foam::IOerror);
    EXPECT_THROW(control("thermal nan;"), Foam::IOerror);
    EXPECT_THROW(control("maxDeltaT 0;"), Foam::IOerror);
    EXPECT_THROW(control("maxDeltaT word;"), Foam::IOerror);

    timeStepControl limits(dictionary(IStringStream("acoustic 0.25;")()));
    EXPECT_NO_THROW(limits.limit("acoustic", 1));
    EXPECT_THROW(limits.limit("force", 1), Foam::IOerror);
}

// ************************************************************************* //
