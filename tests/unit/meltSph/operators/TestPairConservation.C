/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "artificialViscosity.H"
#include "meltSph/particleCloud/cloudSums.H"
#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"
#include "pressureForce.H"
#include "stressDivergence.H"
#include "velocityGradient.H"
#include "xsphVelocity.H"

#include <cmath>
#include <tuple>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

//- What one of a pair gains the other loses, on free clouds of random masses,
//  densities, velocities, pressures and stresses: seed, layers in z, kernel
class PairConservation
:
    public testing::TestWithParam<std::tuple<unsigned, int, kernelType>>
{
protected:

    particleCloud cloud
    {
        lattice
        {
            {9, 8, std::get<1>(GetParam())}, 0.01, std::get<2>(GetParam()),
            1.3, 0.4
        },
        std::get<0>(GetParam())
    };

    particles& f = cloud.fluid;

    void SetUp() override
    {
        cloud.randomiseDensity(0.3);
        cloud.randomiseVelocity(1);
        cloud.randomise(f.p, -100, 500);
        for (particles::array& s : f.S)
        {
            cloud.randomise(s, -50, 50);
        }
        if (cloud.points().dimensions() == 2)
        {
            f.S[2].assign(f.size(), 0);
            f.S[4].assign(f.size(), 0);
        }
    }

    void expectNoNetForce(const char* what) const
    {
        const vector3 force = massSum(f, f.ax, f.ay, f.az);
        const double all = massSumMag(f, f.ax, f.ay, f.az);
        EXPECT_GT(all, 0) << what;
        for (const double component : force)
        {
            EXPECT_NEAR(component, 0, 1e-13*all) << what;
        }
    }

    void expectNoNetTorque(const char* what) const
    {
        const double all = 0.1*massSumMag(f, f.ax, f.ay, f.az);
        for (const double component : torque(f))
        {
            EXPECT_NEAR(component, 0, 1e-13*all) << what;
        }
    }
};

} // End anonymous namespace


TEST_P(PairConservation, pressureKeepsBothMomenta)
{
    addPressureForce(cloud.near, cloud.walls, f);
    expectNoNetForce("pressure");
    expectNoNetTorque("pressure");
}


TEST_P(PairConservation, stressKeepsLinearMomentum)
{
    addStressDivergence(cloud.near, cloud.walls, f);
    expectNoNetForce("stress");
}


TEST_P(PairConservation, artificialViscosityKeepsBothMomenta)
{
    addArtificialViscosity(cloud.near, 0.5, 1, 20, f);
    expectNoNetForce("artificial viscosity");
    expectNoNetTorque("artificial viscosity");
}


TEST_P(PairConservation, xsphKeepsCentreOfMass)
{
    xsphVelocity(cloud.near, 0.5, f);
    const vector3 sum = massSum(f, f.du, f.dv, f.dw);
    const double all = massSumMag(f, f.du, f.dv, f.dw);
    EXPECT_GT(all, 0);
    for (const double component : sum)
    {
        EXPECT_NEAR(component, 0, 1e-13*all);
    }
}


// d(kinetic) + d(elastic) = 0: sum m v.a + sum m p/rho^2 drho/dt
TEST_P(PairConservation, pressureAndContinuityExchangeEnergy)
{
    addPressureForce(cloud.near, cloud.walls, f);
    velocityGradient(cloud.near, cloud.walls, f, false);

    double sum = 0, all = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        const double kinetic =
            f.m[i]*(f.u[i]*f.ax[i] + f.v[i]*f.ay[i] + f.w[i]*f.az[i]);
        const double elastic =
            f.m[i]*f.p[i]/(f.rho[i]*f.rho[i])*f.dRho[i];
        sum += kinetic + elastic;
        all += std::abs(kinetic) + std::abs(elastic);
    }
    EXPECT_NEAR(sum, 0, 1e-14*all);
}


// Power of the stress S = 2 x shear x eta: sum m v.a = -sum V S:grad v
TEST_P(PairConservation, stressWorksOnTheGradient)
{
    const auto S = f.S;
    addStressDivergence(cloud.near, cloud.walls, f);
    velocityGradient(cloud.near, cloud.walls, f, true);

    // S:grad v = (S - tr S/d I):D/2 + tr(S)/d div v
    const int d = cloud.points().dimensions();
    double sum = 0, all = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        const double mean = (S[0][i] + S[3][i] + (d == 3 ? S[5][i] : 0))/d;
        const double dissipation =
            0.5*
            (
                S[0][i]*f.S[0][i] + S[3][i]*f.S[3][i] + S[5][i]*f.S[5][i]
            )
          + S[1][i]*f.S[1][i] + S[2][i]*f.S[2][i] + S[4][i]*f.S[4][i]
          - mean*f.dRho[i]/f.rho[i];
        const double work =
            f.m[i]*(f.u[i]*f.ax[i] + f.v[i]*f.ay[i] + f.w[i]*f.az[i]);
        sum += work + f.V[i]*dissipation;
        all += std::abs(work) + std::abs(f.V[i]*dissipation);
    }
    EXPECT_NEAR(sum, 0, 1e-14*all);
}


INSTANTIATE_TEST_SUITE_P
(
    clouds,
    PairConservation,
    testing::Combine
    (
        testing::Values(1u, 2u, 3u),
        testing::Values(1, 6),
        testing::Values(kernelType::wendlandC2, kernelType::quinticSpline)
    )
);

// ************************************************************************* //
