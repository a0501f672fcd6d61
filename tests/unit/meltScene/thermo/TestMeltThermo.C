/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltThermo.H"
#include "meltUnitTests.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

//- A valid dictionary, with further entries that overrule
meltThermo thermo(const std::string& entries)
{
    const std::string valid
    (
        "rho 1000; Cp 2000; kappa 0.2; solidus 330; TMin 280; TMax 400;"
    );
    return meltThermo(dictionary(IStringStream(valid + entries)()));
}

} // End anonymous namespace


TEST(MeltThermo, liquidIsAsSolidUnlessGiven)
{
    const meltThermo simple(thermo(""));

    EXPECT_EQ(simple.rho(), 1000);
    EXPECT_EQ(simple.kappaLiquid(), 0.2);
    EXPECT_EQ(simple.enthalpy().CpLiquid, 2000);
    EXPECT_EQ(simple.enthalpy().liquidus, 330);
    EXPECT_EQ(simple.enthalpy().latentHeat, 0);

    const meltThermo full
    (
        thermo("CpLiquid 2500; kappaLiquid 0.3; liquidus 340; latentHeat 1e5;")
    );

    EXPECT_EQ(full.kappaLiquid(), 0.3);
    EXPECT_EQ(full.enthalpy().CpLiquid, 2500);
    EXPECT_EQ(full.enthalpy().liquidus, 340);
    EXPECT_EQ(full.enthalpy().latentHeat, 1e5);
}


TEST(MeltThermo, badInputIsRejected)
{
    for
    (
        const char* text
      : {
            "rho 0;", "rho -1;", "rho nan;",
            "Cp 0;", "Cp -3;", "CpLiquid 0;",
            "kappa -1;", "kappaLiquid -1;",
            "solidus -300;", "liquidus 329;", "latentHeat -1;",
            "TMin -1;", "TMax 279;", "TMax nan;"
        }
    )
    {
        EXPECT_THROW(thermo(text), IOerror) << text;
    }

    for (const char* entry : {"rho", "Cp", "kappa", "solidus", "TMin", "TMax"})
    {
        dictionary dict
        (
            IStringStream
            (
                "rho 1; Cp 2; kappa 1; solidus 3; TMin 2; TMax 4;"
            )()
        );
        dict.remove(entry);
        EXPECT_THROW(meltThermo{dict}, IOerror) << entry;
    }
}


// ************************************************************************* //
