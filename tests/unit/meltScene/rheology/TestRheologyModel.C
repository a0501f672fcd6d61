/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rheologyModel.H"
#include "meltUnitTests.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

autoPtr<rheologyModel> model(const char* text)
{
    return rheologyModel::New(dictionary(IStringStream(text)()));
}

} // End anonymous namespace


TEST(RheologyModel, unknownTypeListsTheValidOnes)
{
    try
    {
        model("type Newtonion; eta 1;");
        FAIL() << "nothing thrown";
    }
    catch (const IOerror& err)
    {
        const std::string message(err.message());
        EXPECT_NE(message.find("Newtonion"), std::string::npos);
        EXPECT_NE(message.find("Newtonian"), std::string::npos);
        EXPECT_NE(message.find("SouzaMendesDutra"), std::string::npos);
    }

    EXPECT_THROW(model("eta 1;"), IOerror);
}


TEST(RheologyModel, coefficientsMayBeInASubDictionary)
{
    const auto rheology = model("type Newtonian; NewtonianCoeffs { eta 7; }");

    EXPECT_EQ(rheology->etaMax(1, 2), 7);
}


TEST(RheologyModel, NewtonianIsItsTemperatureLaw)
{
    const auto rheology = model
    (
        "type Newtonian; eta { type Arrhenius;"
        "    reference 5; TReference 400; Ta 4000; TFloor 300; }"
    );

    const scalar shearRate[] = {0, 1e-300, 1, 1e300};
    const scalar T[] = {400, 400, 350, 350};
    scalar eta[4];
    rheology->eta(4, shearRate, T, eta);

    EXPECT_DOUBLE_EQ(eta[0], 5);
    EXPECT_EQ(eta[0], eta[1]);
    EXPECT_NEAR(eta[2], 5*std::exp(4000*(1/350. - 1/400.)), 1e-12);
    EXPECT_EQ(eta[2], eta[3]);

    EXPECT_NEAR(rheology->etaMax(350, 400), eta[2], 1e-12);
    EXPECT_FALSE(rheology->shearRateDependent());
    EXPECT_TRUE(rheology->jumpNumber(scalarField(3, 300.))().empty());
}


TEST(RheologyModel, NewtonianRejectsBadViscosity)
{
    for (const char* eta : {"0", "-1", "nan", "inf", "ten", ""})
    {
        const std::string text
        (
            std::string("type Newtonian; eta ") + eta + ";"
        );
        EXPECT_THROW(model(text.c_str()), IOerror) << text;
    }
}


// ************************************************************************* //
