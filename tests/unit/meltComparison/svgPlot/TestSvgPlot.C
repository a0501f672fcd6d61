/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "svgPlot.H"
#include "meltUnitTests.H"
#include "OSspecific.H"

#include <fstream>
#include <sstream>

using namespace Foam;
using namespace Foam::melt;

namespace
{

scalarField values(const scalarList& list)
{
    return scalarField(list);
}


//- What a plot writes
std::string written(const svgPlot& plot)
{
    const fileName file(unitTest::runTime().path()/"plot.svg");
    plot.write(file);
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    rm(file);
    return text.str();
}


label count(const std::string& text, const std::string& what)
{
    label n = 0;
    for
    (
        std::size_t at = text.find(what);
        at != std::string::npos;
        at = text.find(what, at + 1)
    )
    {
        ++n;
    }
    return n;
}

} // End anonymous namespace


TEST(SvgPlot, ticksAreRoundAndWithinTheRange)
{
    EXPECT_EQ(svgPlot::ticks({0, 2.5}, 5), scalarList({0, 0.5, 1, 1.5, 2, 2.5}));
    EXPECT_EQ(svgPlot::ticks({-3, 14}, 5), scalarList({0, 5, 10}));

    for (const scalar size : {1e-12, 3.7e-3, 1.0, 8.1e7})
    {
        const scalarList ticks(svgPlot::ticks({0.3*size, 1.1*size}, 5));
        EXPECT_GE(ticks.size(), 2);
        EXPECT_LE(ticks.size(), 6);
        EXPECT_GE(ticks.first(), 0.3*size*(1 - 1e-9));
        EXPECT_LE(ticks.last(), 1.1*size*(1 + 1e-9));
    }
}


TEST(SvgPlot, drawsALineAndALegendPerSeries)
{
    svgPlot plot("height [m]", "time [s]");
    plot.add("sph", values({0, 1, 2}), values({3, 4, 5}));
    plot.add("eulerian", values({0, 2}), values({3, 6}));
    const std::string text(written(plot));

    EXPECT_EQ(count(text, "<polyline"), 2);
    EXPECT_EQ(count(text, ">sph</text>"), 1);
    EXPECT_EQ(count(text, ">eulerian</text>"), 1);
    EXPECT_EQ(count(text, ">height [m]</text>"), 1);
    EXPECT_EQ(count(text, "nan"), 0);

    // First point of both at the left, 3 of 3 to 6 at the bottom
    EXPECT_EQ(count(text, "points=\"80,276 "), 2);
}


TEST(SvgPlot, levelLineAndWhatIsNotFinite)
{
    svgPlot level("mass [kg]", "time [s]");
    level.add("a", values({0, 1}), values({7, 7}));
    EXPECT_EQ(count(written(level), "nan"), 0);

    svgPlot gap("T [K]", "time [s]");
    gap.add("a", values({0, 1, 2}), values({1, NAN, 2}));
    EXPECT_EQ(count(written(gap), "nan"), 0);

    EXPECT_EQ(count(written(svgPlot("", "")), "nan"), 0);
}


TEST(SvgPlot, refusesAFileThatCannotBeWritten)
{
    EXPECT_THROW(svgPlot("", "").write("/nowhere/plot.svg"), Foam::error);
}


// ************************************************************************* //
