/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutCells.H"
#include "meltUnitTests.H"
#include "Random.H"
#include "shapeTestTools.H"

#include <cmath>

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

//- Of the cell of edges 0.1, 0.2, 0.3 m around the origin
scalar shareOf(const shape& body, const label axis)
{
    return cutCells::shares
    (
        body, pointField(1, Zero), labelList(1, axis), vector(0.1, 0.2, 0.3)
    )[0];
}


//- Box from far below to a height along z
std::string slab(const scalar top)
{
    return "type box; min (-9 -9 -9); max (9 9 " + std::to_string(top) + ");";
}

} // End anonymous namespace


TEST(CutCells, planeAcrossTheColumns)
{
    Random random(3);
    for (label i = 0; i < 20; ++i)
    {
        const scalar share = random.sample01<scalar>();
        EXPECT_NEAR
        (
            shareOf(*shapeOf(slab(0.3*(share - 0.5))), 2), share, 1.0/512
        );
    }
}


TEST(CutCells, halvesAndSidesAreExact)
{
    EXPECT_EQ(shareOf(*shapeOf(slab(-0.15)), 2), 0);
    EXPECT_EQ(shareOf(*shapeOf(slab(0)), 2), 0.5);
    EXPECT_EQ(shareOf(*shapeOf(slab(0.15)), 2), 1);

    // Along it: by the places of the columns
    EXPECT_EQ(shareOf(*shapeOf(slab(0)), 0), 0.5);
    EXPECT_EQ(shareOf(*shapeOf(slab(-0.076)), 1), 0.25);
}


// The columns' mean is the height in the middle
TEST(CutCells, planeAslantThatCrossesAllColumns)
{
    for (const char* turn : {"(0 -0.5 1)", "(1 0.3 1)", "(-0.4 0.2 1)"})
    {
        for (const scalar top : {-0.03, 0.0, 0.02})
        {
            const autoPtr<shape> body
            (
                shapeOf(slab(0) + "rotate ((0 0 1) " + turn + ");"
                    "translate (0 0 " + std::to_string(top) + ");")
            );
            EXPECT_NEAR(shareOf(*body, 2), 0.5 + top/0.3, 1.0/512) << turn;
        }
    }
}

// ************************************************************************* //
