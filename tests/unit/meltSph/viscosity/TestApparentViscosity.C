/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "apparentViscosity.H"
#include "IStringStream.H"
#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

autoPtr<rheologyModel> rheology(const std::string& entries)
{
    return rheologyModel::New(dictionary(IStringStream(entries)()));
}

const std::string viscoplastic
(
    "type SouzaMendesDutra; tau0 20; gamma1 3; n 0.5;"
    "jumpNumber { type jumpNumberLinear; TMin 300; TMax 350;"
    " atTMin 1000; atTMax 10; }"
);


//- More than two blocks of particles with random deformation
particleCloud deformed()
{
    particleCloud cloud
    (
        lattice
        {
            {15, 14, 13}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.2
        }
    );
    for (int i = 0; i < cloud.size(); ++i)
    {
        const double size = std::pow(10, cloud.random(-6, 4));
        for (particles::array& s : cloud.fluid.S)
        {
            s[i] = size*cloud.random(-1, 1);
        }
    }
    cloud.randomise(cloud.fluid.T, 300, 350);
    return cloud;
}


double shearRate(const std::array<particles::array, 6>& D, const int i)
{
    // All nine components
    return std::sqrt
    (
        0.5
       *(
            D[0][i]*D[0][i] + D[3][i]*D[3][i] + D[5][i]*D[5][i]
          + 2*(D[1][i]*D[1][i] + D[2][i]*D[2][i] + D[4][i]*D[4][i])
        )
    );
}

} // End anonymous namespace


TEST(ApparentViscosity, isThatOfTheLawForEveryParticle)
{
    const auto law = rheology(viscoplastic);
    particleCloud cloud = deformed();
    particles& f = cloud.fluid;
    const auto D = f.S;
    ASSERT_GT(cloud.size(), 2*1024 + 100);
    setViscosityAndStress(*law, f);

    for (int i = 0; i < cloud.size(); ++i)
    {
        const scalar rate = shearRate(D, i);
        scalar eta = 0;
        law->eta(1, &rate, &f.T[i], &eta);
        ASSERT_NEAR(f.eta[i]/eta, 1, 1e-12);
        ASSERT_NEAR(shearRateOf(f, i)/rate, 1, 1e-12);
        for (int c = 0; c < 6; ++c)
        {
            ASSERT_EQ(f.S[c][i], f.eta[i]*D[c][i]);
        }
    }
}


// Shear rate of simple shear gamma is gamma, of uniaxial extension e sqrt(3) e
TEST(ApparentViscosity, shearRateOfKnownFlows)
{
    const auto law = rheology("type Newtonian; eta 50;");
    particleCloud cloud(lattice{{2, 1, 1}});
    particles& f = cloud.fluid;
    f.S[2] = {7, 0};
    f.S[0] = {0, 2*0.3};
    f.S[3] = {0, -0.3};
    f.S[5] = {0, -0.3};
    setViscosityAndStress(*law, f);
    EXPECT_DOUBLE_EQ(shearRateOf(f, 0), 7);
    EXPECT_DOUBLE_EQ(f.S[2][0], 350);
    EXPECT_DOUBLE_EQ(shearRateOf(f, 1), std::sqrt(3)*0.3);
    EXPECT_DOUBLE_EQ(f.eta[1], 50);
}


TEST(ApparentViscosity, withoutShearRatesIsThatAtRest)
{
    const auto law = rheology(viscoplastic);
    particleCloud cloud = deformed();
    const scalar rest = 0;
    setViscosityAndStress(*law, cloud.fluid, false);
    for (int i = 0; i < cloud.size(); ++i)
    {
        scalar eta = 0;
        law->eta(1, &rest, &cloud.fluid.T[i], &eta);
        ASSERT_NEAR(cloud.fluid.eta[i]/eta, 1, 1e-12);
    }
}


// The gain changes the shear rate alone: the stress keeps D as it is
TEST(ApparentViscosity, shearRatesAreDividedByTheGain)
{
    const auto law = rheology(viscoplastic);
    particleCloud cloud = deformed();
    particles& f = cloud.fluid;
    const auto D = f.S;
    const double gain = 0.8;
    setViscosityAndStress(*law, f, true, gain);

    for (int i = 0; i < cloud.size(); ++i)
    {
        const scalar rate = shearRate(D, i)/gain;
        scalar eta = 0;
        law->eta(1, &rate, &f.T[i], &eta);
        ASSERT_NEAR(f.eta[i]/eta, 1, 1e-12);
        ASSERT_EQ(f.S[1][i], f.eta[i]*D[1][i]);
    }
}


// Where there is no more of D than the shear rate, the same viscosities
TEST(ApparentViscosity, takesShearRatesAlone)
{
    const auto law = rheology(viscoplastic);
    particleCloud cloud = deformed();
    particles& f = cloud.fluid;
    const auto D = f.S;
    setViscosityAndStress(*law, f, true, 0.8);
    const auto eta = f.eta;

    f.S = {};
    for (int i = 0; i < cloud.size(); ++i)
    {
        f.shearRate[i] = shearRate(D, i);
    }
    setViscosityAndStress(*law, f, true, 0.8);
    for (int i = 0; i < cloud.size(); ++i)
    {
        ASSERT_NEAR(f.eta[i]/eta[i], 1, 1e-12);
        ASSERT_EQ(shearRateOf(f, i), f.shearRate[i]);
    }
}


TEST(ApparentViscosity, meltAtRestHasNoStress)
{
    const auto law = rheology(viscoplastic);
    particleCloud cloud(lattice{{5, 5, 1}});
    setViscosityAndStress(*law, cloud.fluid);
    for (int i = 0; i < cloud.size(); ++i)
    {
        EXPECT_NEAR(cloud.fluid.eta[i], 1001*20.0/3, 1e-9);
        EXPECT_EQ(cloud.fluid.S[0][i], 0);
        EXPECT_EQ(shearRateOf(cloud.fluid, i), 0);
    }
}

// ************************************************************************* //
