/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costRequest.H"
#include "error.H"
#include "meltUnitTests.H"

using namespace Foam::melt;


TEST(CostRequest, knowsItsUnits)
{
    EXPECT_TRUE(costRequest::budget("60s").isBudget);
    EXPECT_EQ(costRequest::budget("60s").limit, 60);
    EXPECT_EQ(costRequest::budget("60").limit, 60);
    EXPECT_EQ(costRequest::budget("1.5min").limit, 90);
    EXPECT_EQ(costRequest::budget("2h").limit, 7200);
    EXPECT_EQ(costRequest::budget("1d").limit, 86400);

    EXPECT_FALSE(costRequest::accuracy("0.03").isBudget);
    EXPECT_EQ(costRequest::accuracy("3e-2").limit, 0.03);
}


TEST(CostRequest, refusesBadInput)
{
    for (const char* text : {"", "s", "60x", "60 s", "-1s", "0s", "nan", "inf"})
    {
        EXPECT_THROW(costRequest::budget(text), Foam::error) << text;
    }
    for (const char* text : {"", "0", "1", "3%", "-0.1", "nan", "0.03s"})
    {
        EXPECT_THROW(costRequest::accuracy(text), Foam::error) << text;
    }
}


// ************************************************************************* //
