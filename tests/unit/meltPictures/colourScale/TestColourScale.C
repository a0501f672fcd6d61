/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "colourScale.H"
#include "meltUnitTests.H"
#include "StringStream.H"

using namespace Foam;
using melt::colourScale;

namespace
{

dictionary dictionaryOf(const std::string& text)
{
    return dictionary(IStringStream(text)());
}

//- Texts of the ticks in one line
std::string ticks(const std::string& text, const label maxTicks)
{
    const colourScale scale(dictionaryOf(text), "T", scalarMinMax(0, 1));
    std::string result;
    for (const colourScale::tick& t : scale.ticks(maxTicks))
    {
        result += (result.empty() ? "" : " ") + t.second();
    }
    return result;
}

}

TEST(colourScale, positionIsLinearAndClipped)
{
    const colourScale scale
    (
        dictionaryOf("range (300 400);"), "T", scalarMinMax(0, 1)
    );
    EXPECT_DOUBLE_EQ(scale.position(325), 0.25);
    EXPECT_EQ(scale.position(-1), 0);
    EXPECT_EQ(scale.position(1000), 1);
}

TEST(colourScale, logarithmicPosition)
{
    const colourScale scale
    (
        dictionaryOf("scale logarithmic;"), "eta", scalarMinMax(1, 1e4)
    );
    EXPECT_NEAR(scale.position(10), 0.25, 1e-12);
    EXPECT_NEAR(scale.position(1e3), 0.75, 1e-12);
    EXPECT_EQ(scale.position(0), 0);
}

TEST(colourScale, uniformFieldHasTheMiddleColour)
{
    const colourScale scale(dictionary(), "T", scalarMinMax(5, 5));
    EXPECT_DOUBLE_EQ(scale.position(5), 0.5);
}

TEST(colourScale, ticksAreRound)
{
    EXPECT_EQ(ticks("range (290 350);", 6), "290 300 310 320 330 340 350");
    EXPECT_EQ(ticks("range (0 1);", 6), "0 0.2 0.4 0.6 0.8 1");
    EXPECT_EQ(ticks("range (-0.3 0.3);", 6), "-0.3 -0.2 -0.1 0 0.1 0.2 0.3");
    EXPECT_EQ(ticks("range (0.0013 0.0021);", 4), "0.0014 0.0016 0.0018 0.002");
    EXPECT_EQ(ticks("range (1013 98765);", 5), "20000 40000 60000 80000");
}

TEST(colourScale, logarithmicTicksArePowersOfTen)
{
    EXPECT_EQ
    (
        ticks("range (0.5 2e4); scale logarithmic;", 6),
        "1 10 100 1000 10000"
    );
    EXPECT_EQ
    (
        ticks("range (1 1e8); scale logarithmic;", 4),
        "1 100 10000 1e+06 1e+08"
    );
    EXPECT_EQ(ticks("range (1 3); scale logarithmic;", 4), "1 1.5 2 2.5 3");
}

TEST(colourScale, coloursAtTheEndsAreTheTables)
{
    const colourScale scale
    (
        dictionaryOf("map { table ((0 (1 0 0)) (1 (0 0 1))); }"),
        "T",
        scalarMinMax(0, 1)
    );
    EXPECT_EQ(scale.colour(0), vector(1, 0, 0));
    EXPECT_EQ(scale.colour(1), vector(0, 0, 1));
    EXPECT_EQ(scale.colour(0.5), vector(0.5, 0, 0.5));
}

TEST(colourScale, titleHasTheUnit)
{
    const scalarMinMax range(0, 1);
    EXPECT_EQ(colourScale(dictionary(), "T", range).title(), "T [K]");
    EXPECT_EQ
    (
        colourScale(dictionary(), "mag(U)", range).title(), "|U| [m/s]"
    );
    EXPECT_EQ(colourScale(dictionary(), "foo", range).title(), "foo");
    EXPECT_EQ
    (
        colourScale(dictionaryOf("title \"a b\";"), "T", range).title(), "a b"
    );
}

TEST(colourScale, refusesBadEntries)
{
    for
    (
        const char* text :
        {
            "range (2 1);", "range (nan 1);", "map noSuchMap;",
            "scale logarithmic;", "scale cubic;"
        }
    )
    {
        EXPECT_THROW
        (
            colourScale(dictionaryOf(text), "T", scalarMinMax(0, 1)),
            Foam::IOerror
        ) << text;
    }
}
