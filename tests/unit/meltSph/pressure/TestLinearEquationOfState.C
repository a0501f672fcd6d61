/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "IStringStream.H"
#include "meltSph/timeStep/schemeCase.H"
#include "meltUnitTests.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

//- Pressures of three particles of density 990, 1000 and 1020 kg/m3
particles::array pressures(const std::string& further)
{
    particleCloud cloud(lattice{{3, 1, 1}});
    cloud.fluid.rho = {990, 1000, 1020};
    schemeCase scheme
    (
        cloud,
        "pressure { type linearEquationOfState; speedOfSound 15; " + further
      + "} viscosity { type explicitStress; }"
    );
    EXPECT_EQ(scheme.system.soundSpeed, 15);
    scheme.scheme->start();
    particles::array p(3);
    for (int id = 0; id < 3; ++id)
    {
        p[id] = scheme.system.fluid.p[scheme.indexOf(id)];
    }
    return p;
}

} // End anonymous namespace


TEST(LinearEquationOfState, pressureOfDensity)
{
    EXPECT_EQ
    (
        pressures("tension yes;"),
        (particles::array{-10*225.0, 0, 20*225.0})
    );
}


TEST(LinearEquationOfState, noTensionByDefault)
{
    const particles::array expected{0, 0, 20*225.0};
    EXPECT_EQ(pressures(""), expected);
    EXPECT_EQ(pressures("tension no;"), expected);
}


// Raises tension beyond zero too
TEST(LinearEquationOfState, backgroundPressure)
{
    EXPECT_EQ
    (
        pressures("background 1000;"),
        (particles::array{0, 1000, 20*225.0 + 1000})
    );
    EXPECT_THROW(pressures("background -1;"), Foam::IOerror);
}


TEST(LinearEquationOfState, badSpeedOfSound)
{
    for (const char* entry : {"speedOfSound 0;", "speedOfSound nan;"})
    {
        EXPECT_THROW(pressures(entry), Foam::IOerror) << entry;
    }
}

// ************************************************************************* //
