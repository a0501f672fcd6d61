/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicPeriods.H"
#include "meltScene/scene/sceneCase.H"
#include "meltSph/mesh/hexMesh.H"
#include "meltUnitTests.H"
#include "wallConditions.H"

using namespace Foam;
using namespace Foam::melt;
using unitTest::boxMesh;
using unitTest::hexMesh;

namespace
{

const labelVector cells(2, 3, 2);
const vector size(1, 2, 3);

const wordList cyclicXZ
(
    {"cyclic", "cyclic", "wall", "patch", "cyclic", "cyclic"}
);


template<class Action>
std::string messageOf(const Action& action)
{
    try
    {
        action();
    }
    catch (const error& err)
    {
        return err.message();
    }
    return "accepted";
}

} // End anonymous namespace


TEST(CyclicPeriods, noneWithoutCyclicPatches)
{
    const auto mesh(boxMesh(cells, size));
    const cyclicPeriods periods(mesh());

    EXPECT_FALSE(periods.any());
    EXPECT_EQ(periods.period(), vector::zero);
    EXPECT_NO_THROW(periods.refuse("abacus"));
}


TEST(CyclicPeriods, areTheLengthsOfTheDomain)
{
    const auto mesh(boxMesh(cells, size, cyclicXZ));
    const cyclicPeriods periods(mesh());

    EXPECT_TRUE(periods.any());
    EXPECT_DOUBLE_EQ(periods.period().x(), 1);
    EXPECT_EQ(periods.period().y(), 0);
    EXPECT_DOUBLE_EQ(periods.period().z(), 3);
}


TEST(CyclicPeriods, refusalNamesFilePatchAndMethod)
{
    const auto mesh(boxMesh(cells, size, cyclicXZ));
    const std::string message
    (
        messageOf([&]() { cyclicPeriods(mesh()).refuse("abacus"); })
    );

    EXPECT_NE(message.find("abacus"), std::string::npos) << message;
    EXPECT_NE(message.find("xMin"), std::string::npos) << message;
}


TEST(CyclicPeriods, patchOffTheBoxIsRejected)
{
    // Sheared: xMin and xMax stay parallel, but leave the sides of the box
    const auto mesh
    (
        hexMesh
        (
            cells,
            [](const point& p) { return p + vector(0.5*p.y(), 0, 0); },
            {"cyclic", "cyclic", "wall", "wall", "wall", "wall"}
        )
    );
    const std::string message
    (
        messageOf([&]() { cyclicPeriods periods(mesh()); })
    );

    EXPECT_NE(message.find("xMin"), std::string::npos) << message;
    EXPECT_NE(message.find("faces"), std::string::npos) << message;
}


TEST(CyclicPeriods, patchThatIsNoWholeSideIsRejected)
{
    // A notch in the edge between yMin and zMin takes of xMin and xMax alike
    const auto mesh
    (
        hexMesh
        (
            cells,
            [](const point& p) { return p; },
            {"cyclic", "cyclic", "wall", "wall", "wall", "wall"},
            [](label, label j, label k) { return j == 0 && k == 0; }
        )
    );

    EXPECT_NE
    (
        messageOf([&]() { cyclicPeriods periods(mesh()); }).find("whole side"),
        std::string::npos
    );
}


TEST(CyclicPeriods, cyclicPatchIsNeitherWallNorOpen)
{
    unitTest::sceneCase files(cyclicXZ);
    const wallConditions walls(files.mesh());

    EXPECT_EQ(walls[0].velocity, wallCondition::velocityType::cyclic);
    EXPECT_FALSE(walls[0].isWall());
    EXPECT_TRUE(walls[2].isWall());
    EXPECT_EQ(walls[3].velocity, wallCondition::velocityType::open);
}

// ************************************************************************* //
