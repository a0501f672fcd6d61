/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "initialTemperature.H"
#include "meltUnitTests.H"
#include "../shapes/shapeTestTools.H"

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

//- In a box of 2 x 3 x 4 m from the origin
scalarField temperatures(const std::string& text, const pointField& points)
{
    const auto body = shapeOf("type box; min (0 0 0); max (2 3 4);");
    return initialTemperature::New(dictOf(text), *body)->value(points);
}


scalar temperature(const std::string& text, const point& p)
{
    return temperatures(text, pointField({p}))[0];
}


void expectMessage(const std::string& text, const std::string& entry)
{
    const std::string message
    (
        messageOf([&] { temperature(text, point(1, 1, 1)); })
    );
    EXPECT_NE(message.find(entry), std::string::npos)
        << text << " gives: " << message;
}

} // End anonymous namespace


TEST(InitialTemperature, uniformIsTheSameEverywhere)
{
    for
    (
        const scalar T
      : temperatures
        (
            "type uniform; value 300;",
            randomPoints(100, boundBox(point::zero, point::one))
        )
    )
    {
        EXPECT_EQ(T, 300);
    }
}


TEST(InitialTemperature, linearGoesFromEndToEndOfTheShape)
{
    const std::string law("type linear; direction (0 2 0); T1 290; T2 350;");
    EXPECT_EQ(temperature(law, point(1, 0, 1)), 290);
    EXPECT_EQ(temperature(law, point(1, 3, 1)), 350);
    EXPECT_NEAR(temperature(law, point(7, 1, -9)), 310, 1e-10);

    // From corner to corner
    const std::string diagonal
    (
        "type linear; direction (-1 0 -1); T1 290; T2 350;"
    );
    EXPECT_NEAR(temperature(diagonal, point(2, 1, 4)), 290, 1e-10);
    EXPECT_NEAR(temperature(diagonal, point(1, 1, 2)), 320, 1e-10);
    EXPECT_NEAR(temperature(diagonal, point(0, 1, 0)), 350, 1e-10);
}


TEST(InitialTemperature, linearIsConstantBeyondItsPoints)
{
    const std::string law
    (
        "type linear; point1 (0 1 0); point2 (0 2 0); T1 350; T2 290;"
    );
    EXPECT_EQ(temperature(law, point(1, 0.5, 1)), 350);
    EXPECT_NEAR(temperature(law, point(1, 1.25, 1)), 335, 1e-10);
    EXPECT_EQ(temperature(law, point(1, 2.5, 1)), 290);
}


TEST(InitialTemperature, function1IsOfTheCoordinate)
{
    const std::string law
    (
        "type function1; direction (0 0 3); origin (0 0 1);"
        "value table ((0 290) (1 300) (3 350));"
    );
    EXPECT_NEAR(temperature(law, point(5, 5, 1)), 290, 1e-10);
    EXPECT_NEAR(temperature(law, point(5, 5, 1.5)), 295, 1e-10);
    EXPECT_NEAR(temperature(law, point(5, 5, 3)), 325, 1e-10);
}


TEST(InitialTemperature, refusesBadInputAndNamesTheEntry)
{
    expectMessage("type hot;", "uniform");
    expectMessage("value 300;", "type");
    expectMessage("type uniform;", "value");
    expectMessage("type uniform; value -1;", "value");
    EXPECT_EQ(temperature("type uniform; value 0;", point::zero), 0);
    expectMessage("type uniform; value nan;", "value");
    expectMessage("type linear; direction (0 1 0); T1 290;", "T2");
    expectMessage("type linear; T1 290; T2 300;", "point1");
    expectMessage("type linear; direction (0 0 0); T1 290; T2 300;", "direction");
    expectMessage
    (
        "type linear; direction (0 1 0); point1 (0 0 0); T1 290; T2 300;",
        "point1"
    );
    expectMessage
    (
        "type linear; point1 (0 1 0); point2 (0 1 0); T1 290; T2 300;",
        "point2"
    );
    expectMessage("type function1; direction (0 0 1);", "value");
    expectMessage
    (
        "type function1; direction (0 0 0); value constant 300;",
        "direction"
    );
    expectMessage
    (
        "type function1; direction (0 0 1); value constant -300;",
        "value"
    );
}


// ************************************************************************* //
