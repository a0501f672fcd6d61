/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "SouzaMendesDutra.H"
#include "meltUnitTests.H"

#include <cmath>
#include <random>
#include <vector>

using namespace Foam;
using namespace Foam::melt;

namespace
{

autoPtr<rheologyModel> model(const std::string& entries)
{
    const dictionary dict
    (
        IStringStream("type SouzaMendesDutra; " + entries)()
    );
    return rheologyModel::New(dict);
}


//- The paper's dimensionless form
autoPtr<rheologyModel> dimensionless(const double J, const double n)
{
    std::ostringstream os;
    os.precision(17);
    os  << "tau0 1; gamma1 1; n " << n << "; jumpNumber " << J << ';';
    return model(os.str());
}


double eta(const rheologyModel& rheology, const double shearRate, double T = 300)
{
    double result;
    rheology.eta(1, &shearRate, &T, &result);
    return result;
}


//- (1 - exp(-(J+1)D)) (D^(n-1) + 1/D)
long double exact(const long double D, const long double J, const long double n)
{
    return -std::expm1(-(J + 1)*D)*(std::pow(D, n - 1) + 1/D);
}


const double jumpNumbers[] = {0, 1, 10, 1e3, 1e6, 1e8};

const double indices[] = {0.2, 0.5, 0.9, 1};

} // End anonymous namespace


TEST(SouzaMendesDutra, isTheClosedFormFrom1em300To1e300)
{
    for (const double n : indices)
    {
        for (const double J : jumpNumbers)
        {
            const auto rheology = dimensionless(J, n);

            std::vector<double> D;
            for (double lgD = -300; lgD <= 300; lgD += 0.37)
            {
                D.push_back(std::pow(10, lgD));
            }
            const std::vector<double> T(D.size(), 300);
            std::vector<double> eta(D.size());
            rheology->eta(D.size(), D.data(), T.data(), eta.data());

            for (size_t i = 0; i < D.size(); ++i)
            {
                ASSERT_TRUE(std::isfinite(eta[i]))
                    << D[i] << ' ' << J << ' ' << n;
                ASSERT_NEAR(double(eta[i]/exact(D[i], J, n)), 1, 1e-12)
                    << D[i] << ' ' << J << ' ' << n;
            }
        }
    }
}


TEST(SouzaMendesDutra, isJPlus1AtRest)
{
    for (const double J : jumpNumbers)
    {
        const auto rheology = dimensionless(J, 1);

        EXPECT_EQ(eta(*rheology, 0), J + 1);
        EXPECT_EQ(eta(*dimensionless(J, 0.5), 0), J + 1);

        for (const double D : {1e-300, 1e-100, 1e-30, 1e-22})
        {
            EXPECT_NEAR(eta(*rheology, D)/(J + 1), 1, 1e-12) << J << ' ' << D;
        }
    }
}


TEST(SouzaMendesDutra, isThePowerLawAtLargeShearRate)
{
    for (const double n : indices)
    {
        const auto rheology = dimensionless(1e3, n);

        for (const double D : {1e20, 1e50})
        {
            const double ratio = eta(*rheology, 100*D)/eta(*rheology, D);
            const double expected = std::pow(100, n - 1);

            EXPECT_NEAR(ratio/expected, 1, 2/std::pow(D, n) + 1e-12);
        }
    }
}


TEST(SouzaMendesDutra, stressIncreasesWithShearRate)
{
    for (const double n : indices)
    {
        for (const double J : jumpNumbers)
        {
            const auto rheology = dimensionless(J, n);
            double previous = 0;

            for (double lgD = -30; lgD < 30; lgD += 0.01)
            {
                const double D = std::pow(10, lgD);
                const double stress = D*eta(*rheology, D);

                ASSERT_GT(stress, previous*(1 - 1e-15)) << D << ' ' << J;
                previous = stress;
            }
        }
    }
}


TEST(SouzaMendesDutra, etaMaxBoundsAndIsReached)
{
    // Known maxima for n = 1/2: 1 + 0.35, and J + 1.5 for large J
    EXPECT_NEAR(dimensionless(0, 0.5)->etaMax(300, 300), 1.35, 0.01);
    EXPECT_NEAR(dimensionless(1e4, 0.5)->etaMax(300, 300), 1e4 + 1.5, 0.01);

    for (const double n : indices)
    {
        for (const double J : jumpNumbers)
        {
            const auto rheology = dimensionless(J, n);
            const double bound = rheology->etaMax(300, 300);
            double highest = J + 1;

            for (double lgD = -30; lgD < 3; lgD += 0.001)
            {
                highest = max(highest, eta(*rheology, std::pow(10, lgD)));
            }

            EXPECT_LE(highest, bound*(1 + 1e-14)) << J << ' ' << n;
            EXPECT_GE(highest, bound*(1 - 1e-4)) << J << ' ' << n;
        }
    }
}


TEST(SouzaMendesDutra, KAndGamma1SayTheSame)
{
    // gamma1 = (tau0/K)^(1/n) = 16
    const auto byK = model("tau0 20; K 5; n 0.5; jumpNumber 100;");
    const auto byGamma1 = model("tau0 20; gamma1 16; n 0.5; jumpNumber 100;");

    for (const double D : {0., 1e-3, 1., 100., 1e5})
    {
        EXPECT_DOUBLE_EQ(eta(*byK, D), eta(*byGamma1, D));
    }

    // In SI units: eta0 = (J+1) tau0/gamma1; stress tau0 + K D^n when yielded
    EXPECT_DOUBLE_EQ(eta(*byK, 0), 101*20/16.);
    EXPECT_DOUBLE_EQ(eta(*byK, 1e4)*1e4, 20 + 5*std::sqrt(1e4));
}


TEST(SouzaMendesDutra, factorsScaleYieldStressAndConsistency)
{
    const auto scaled = model
    (
        "tau0 20; K 5; n 0.5; jumpNumber 100; tau0Factor 0.1; KFactor 3;"
    );
    const auto direct = model("tau0 2; K 15; n 0.5; jumpNumber 100;");

    for (const double D : {0., 1e-3, 1., 100., 1e5})
    {
        EXPECT_NEAR(eta(*scaled, D)/eta(*direct, D), 1, 1e-13);
    }

    EXPECT_NEAR
    (
        scaled->etaMax(300, 400)/direct->etaMax(300, 400), 1, 1e-13
    );
}


TEST(SouzaMendesDutra, etaMaxBoundsWithFactorsOfTemperature)
{
    const auto rheology = model
    (
        "tau0 20; K 5; n 0.5;"
        "jumpNumber { type jumpNumberLogarithmic;"
        "    TMin 300; TMax 350; atTMin 1e4; atTMax 0; }"
        "tau0Factor { type jumpNumberLinear;"
        "    TMin 300; TMax 350; atTMin 1; atTMax 0.01; }"
        "KFactor { type Arrhenius;"
        "    reference 1; TReference 300; Ta 2000; TFloor 200; }"
    );
    const double bound = rheology->etaMax(290, 360);

    std::mt19937 generator(2);
    std::uniform_real_distribution<double> temperature(290, 360);
    std::uniform_real_distribution<double> lgD(-10, 5);

    for (int i = 0; i < 10000; ++i)
    {
        const double D = std::pow(10, lgD(generator));
        ASSERT_LE(eta(*rheology, D, temperature(generator)), bound);
    }
}


TEST(SouzaMendesDutra, etaInfIsTheLeast)
{
    const auto rheology =
        model("tau0 1; gamma1 1; n 0.5; jumpNumber 10; etaInf 0.25;");

    EXPECT_EQ(eta(*rheology, 1e12), 0.25);
    EXPECT_EQ(eta(*rheology, 0), 11);
}


TEST(SouzaMendesDutra, arraysGiveWhatSingleValuesGive)
{
    const auto rheology = model
    (
        "tau0 20; K 5; n 0.5; jumpNumber { type jumpNumberLogarithmic;"
        "    TMin 300; TMax 350; atTMin 1e6; atTMax 0; }"
    );

    // More than a block, and no whole number of vectors
    const int n = 1003;
    std::vector<double> D(n), T(n), result(n);
    for (int i = 0; i < n; ++i)
    {
        D[i] = i % 17 ? std::pow(10, -20 + 0.03*i) : 0;
        T[i] = 290 + 0.07*i;
    }
    rheology->eta(n, D.data(), T.data(), result.data());

    const scalarField J(rheology->jumpNumber(scalarField(UList<scalar>(T.data(), n))));

    for (int i = 0; i < n; ++i)
    {
        const double one = eta(*rheology, D[i], T[i]);
        ASSERT_NEAR(result[i]/one, 1, 1e-13) << i;

        if (D[i] == 0)
        {
            ASSERT_NEAR(result[i]*16/20/(J[i] + 1), 1, 1e-13) << i;
        }
    }
}


TEST(SouzaMendesDutra, NaNStaysNaN)
{
    const auto rheology = model
    (
        "tau0 20; K 5; n 0.5; jumpNumber { type jumpNumberLinear;"
        "    TMin 300; TMax 350; atTMin 1e6; atTMax 0; }"
    );

    EXPECT_TRUE(std::isnan(eta(*rheology, std::nan(""))));
    EXPECT_TRUE(std::isnan(eta(*rheology, 1, std::nan(""))));
}


TEST(SouzaMendesDutra, badInputIsRejected)
{
    for
    (
        const char* text
      : {
            "",
            "tau0 0; K 5; n 0.5; jumpNumber 1;",
            "tau0 -1; K 5; n 0.5; jumpNumber 1;",
            "tau0 nan; K 5; n 0.5; jumpNumber 1;",
            "tau0 1; K 0; n 0.5; jumpNumber 1;",
            "tau0 1; gamma1 -1; n 0.5; jumpNumber 1;",
            "tau0 1; K 5; gamma1 1; n 0.5; jumpNumber 1;",
            "tau0 1; n 0.5; jumpNumber 1;",
            "tau0 1; K 5; n 0; jumpNumber 1;",
            "tau0 1; K 5; n 1.1; jumpNumber 1;",
            "tau0 1; K 5; n 0.5; jumpNumber -1;",
            "tau0 1; K 5; n 0.5;",
            "tau0 1; K 5; n 0.5; jumpNumber 1; etaInf -1;",
            "tau0 1; K 5; n 0.5; jumpNumber 1; KFactor 0;"
        }
    )
    {
        EXPECT_THROW(model(text), IOerror) << text;
    }
}


// ************************************************************************* //
