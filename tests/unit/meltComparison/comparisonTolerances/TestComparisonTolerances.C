/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "comparisonTolerances.H"
#include "IStringStream.H"
#include "meltUnitTests.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

const wordList columns({"time", "height", "mass"});

comparisonTolerances read(const std::string& text)
{
    return comparisonTolerances
    (
        dictionary(IStringStream(text)()), columns
    );
}

} // End anonymous namespace


TEST(ComparisonTolerances, greatestDifferenceAndLeastOverlap)
{
    const comparisonTolerances tolerances
    (
        read("intersectionOverUnion 0.8; height 0.1;")
    );
    const Pair<word> methods("sph", "eulerian");

    EXPECT_TRUE(tolerances.holds("intersectionOverUnion", 0.8, methods));
    EXPECT_FALSE(tolerances.holds("intersectionOverUnion", 0.79, methods));
    EXPECT_TRUE(tolerances.holds("height", 0.1, methods));
    EXPECT_FALSE(tolerances.holds("height", 0.11, methods));
    EXPECT_FALSE(tolerances.holds("height", std::nan(""), methods));

    EXPECT_FALSE(tolerances.found("mass", methods));
    EXPECT_TRUE(tolerances.holds("mass", 1e9, methods));
}


TEST(ComparisonTolerances, thoseOfAMethodStandForTheGeneralOnes)
{
    const comparisonTolerances tolerances
    (
        read
        (
            "intersectionOverUnion 0.8; height 0.1;"
            " voxelAutomaton { intersectionOverUnion 0.5; height 0.3; mass 1; }"
            " sph { height 0.2; }"
        )
    );

    EXPECT_EQ(tolerances.value("height", {"eulerian", "eulerian"}), 0.1);
    EXPECT_EQ(tolerances.value("height", {"sph", "eulerian"}), 0.2);
    EXPECT_EQ(tolerances.value("height", {"sph", "voxelAutomaton"}), 0.3);
    EXPECT_EQ(tolerances.value("height", {"voxelAutomaton", "sph"}), 0.3);
    EXPECT_EQ
    (
        tolerances.value("intersectionOverUnion", {"sph", "voxelAutomaton"}),
        0.5
    );
    EXPECT_TRUE(tolerances.found("mass", {"sph", "voxelAutomaton"}));
    EXPECT_FALSE(tolerances.found("mass", {"sph", "eulerian"}));
}


TEST(ComparisonTolerances, refusesWhatIsNotKnownOrNoNumber)
{
    EXPECT_THROW(read("hight 0.1;"), Foam::IOerror);
    EXPECT_THROW(read("height -0.1;"), Foam::IOerror);
    EXPECT_THROW(read("height much;"), Foam::IOerror);
    EXPECT_THROW(read("sph { hight 0.1; }"), Foam::IOerror);
    EXPECT_NO_THROW(read(""));
}


// ************************************************************************* //
