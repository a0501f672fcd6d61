/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectTimes.H"
#include "meltScene.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"
#include "StringStream.H"

#include <chrono>
#include <iterator>
#include <sstream>

using namespace Foam;
using namespace Foam::melt;

namespace
{

using steadyClock = std::chrono::steady_clock;

double since(const steadyClock::time_point start)
{
    return std::chrono::duration<double>(steadyClock::now() - start).count();
}


void spend(const double seconds)
{
    const auto start = steadyClock::now();
    while (since(start) < seconds)
    {}
}


class EffectTimes
:
    public ::testing::Test
{
protected:

    EffectTimes()
    {
        effectTimes::clear();
    }

    ~EffectTimes()
    {
        effectTimes::clear();
    }
};

} // End anonymous namespace


TEST_F(EffectTimes, aPartWithinCountsOnce)
{
    const auto start = steadyClock::now();
    {
        const effectTimes::part outer(effectTimes::flow, "step");
        spend(0.002);
        for (int i = 0; i < 3; ++i)
        {
            const effectTimes::part inner("heatConduction", "conduction");
            spend(0.004);
        }
    }
    const double all = since(start);
    spend(0.001);

    const auto& parts = effectTimes::parts();
    ASSERT_EQ(parts.size(), 2);
    EXPECT_EQ(parts[0].calls, 1);
    EXPECT_EQ(parts[1].calls, 3);
    EXPECT_GE(effectTimes::seconds("flow"), 0.002);
    EXPECT_GE(effectTimes::seconds("heatConduction"), 0.012);
    EXPECT_EQ(effectTimes::seconds("XSPH"), 0);

    // Nothing is lost, nothing counts twice, nothing outside counts
    EXPECT_LE(effectTimes::seconds(), all);
    EXPECT_NEAR
    (
        effectTimes::seconds(),
        effectTimes::seconds("flow") + effectTimes::seconds("heatConduction"),
        1e-12
    );
}


TEST_F(EffectTimes, theSameNameOfTwoEffectsIsTwoParts)
{
    {
        const effectTimes::part a("flow", "pass");
    }
    {
        const effectTimes::part b("XSPH", "pass");
    }
    EXPECT_EQ(effectTimes::parts().size(), 2);
}


TEST_F(EffectTimes, divisionKeepsTheSum)
{
    {
        const effectTimes::part pass(effectTimes::flow, "pairs");
        spend(0.002);
    }
    const scalar before = effectTimes::seconds();
    effectTimes::divide
    (
        "pairs",
        List<Tuple2<word, scalar>>{{"XSPH", 0.25}, {"heatConduction", 0.5}}
    );
    EXPECT_DOUBLE_EQ(effectTimes::seconds(), before);
    EXPECT_DOUBLE_EQ(effectTimes::seconds("XSPH"), 0.25*before);
    EXPECT_DOUBLE_EQ(effectTimes::seconds("heatConduction"), 0.5*before);
    EXPECT_DOUBLE_EQ(effectTimes::seconds("flow"), 0.25*before);

    effectTimes::divide("none", List<Tuple2<word, scalar>>{{"XSPH", 1}});
    EXPECT_DOUBLE_EQ(effectTimes::seconds(), before);
}


TEST_F(EffectTimes, tableAfterTheRun)
{
    unitTest::sceneCase files;
    files.setMaterial
    (
        unitTest::sceneCase::material() + "effects { heatConduction on; }"
    );
    const meltScene scene(files.mesh(), 0.1);
    const auto table = [&]()
    {
        OStringStream os;
        scene.effects().reportTimes(os);
        return std::string(os.str());
    };
    EXPECT_EQ(table(), "");

    {
        const effectTimes::part step(effectTimes::flow, "rest");
        spend(0.001);
        const effectTimes::part heat("heatConduction", "conduction");
        spend(0.003);
    }
    const std::string text = table();
    const auto row = [&](const std::string& name)
    {
        const auto start = text.find("    " + name + ' ');
        EXPECT_NE(start, std::string::npos) << name;
        std::istringstream line(text.substr(start, text.find('\n', start) - start));
        return std::vector<std::string>
        {
            std::istream_iterator<std::string>(line), {}
        };
    };
    EXPECT_EQ(row("heatConduction")[1], "on");
    EXPECT_NEAR
    (
        std::stod(row("heatConduction")[2]),
        100*effectTimes::seconds("heatConduction")/effectTimes::seconds(),
        0.051
    );
    EXPECT_EQ(row("heatSources"), (std::vector<std::string>{"heatSources", "off", "0.0", "%"}));
    EXPECT_EQ(row("conduction")[4], "1");
}
