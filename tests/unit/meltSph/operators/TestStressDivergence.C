/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeSymbol.H"
#include "meltUnitTests.H"
#include "stressDivergence.H"
#include "velocityGradient.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const double eta = 40;

//- Deformation tensor, Newtonian stress and its divergence
void addViscousForce(particleCloud& cloud)
{
    particles& f = cloud.fluid;
    velocityGradient(cloud.near, cloud.walls, f, true);
    for (particles::array& s : f.S)
    {
        for (double& value : s)
        {
            value *= eta;
        }
    }
    addStressDivergence(cloud.near, cloud.walls, f);
}


//- Acceleration over -eta k^2/rho u of a wave of n spacings along x, moving
//  along the axis; the least and the greatest
std::pair<double, double> waveGain
(
    const lattice& points,
    const int n,
    const int axis
)
{
    particleCloud cloud(points);
    particles& f = cloud.fluid;
    const double k = waveNumber(points, n);
    cloud.setVelocity
    (
        [&](double x, double, double)
        {
            vector3 U{0, 0, 0};
            U[axis] = std::sin(k*x);
            return U;
        }
    );
    addViscousForce(cloud);

    const particles::array& u = axis == 0 ? f.u : axis == 1 ? f.v : f.w;
    const particles::array& a = axis == 0 ? f.ax : axis == 1 ? f.ay : f.az;
    std::pair<double, double> gain{1e9, -1e9};
    for (int i = 0; i < cloud.size(); ++i)
    {
        if
        (
            cloud.inside(i, 2*cloud.near.kernel().support())
         && std::abs(u[i]) > 0.2
        )
        {
            const double value = -a[i]*f.rho[i]/(eta*k*k*u[i]);
            gain.first = std::min(gain.first, value);
            gain.second = std::max(gain.second, value);
        }
    }
    return gain;
}


//- A wave of n spacings fits between the margins
lattice planeLattice(const int n, const double ratio)
{
    return {{n + 20, 20, 1}, 1.0/n, kernelType::quinticSpline, ratio};
}

} // End anonymous namespace


// Quintic spline, h = 1.3 spacings, in the plane: the published figures of the
// gradient followed by the divergence
TEST(StressDivergence, shearWaveInThePlane)
{
    const std::pair<int, double> published[] =
    {
        {24, 0.947}, {48, 0.987}, {96, 0.998}
    };
    for (const auto& [n, gain] : published)
    {
        const lattice points = planeLattice(n, 1.3);
        const auto measured = waveGain(points, n, 1);
        const double symbol = gradientGain(points, waveNumber(points, n));

        RecordProperty("gain" + std::to_string(n), std::to_string(measured.first));
        EXPECT_NEAR(measured.first, symbol*symbol, 1e-10);
        EXPECT_NEAR(measured.second, symbol*symbol, 1e-10);
        EXPECT_NEAR(measured.first, gain, 6e-4);
    }
}


TEST(StressDivergence, secondOrderOnLattice)
{
    std::vector<double> errors;
    for (const int n : {24, 48})
    {
        errors.push_back(1 - waveGain(planeLattice(n, 1.5), n, 1).first);
    }
    RecordProperty("order", std::to_string(orderOf(errors)));
    EXPECT_NEAR(orderOf(errors), 2, 0.1);
}


// Shear along y and z; along x the deviator leaves 2 - 2/d of a wave of
// compression
TEST(StressDivergence, wavesInSpace)
{
    for (const kernelType kernel :
        {kernelType::wendlandC2, kernelType::quinticSpline})
    {
        const double ratio = kernel == kernelType::wendlandC2 ? 1.4 : 1.1;
        const lattice points{{26, 15, 15}, 0.01, kernel, ratio};
        const int n = 20;
        const double symbol = gradientGain(points, waveNumber(points, n));
        for (const int axis : {0, 1, 2})
        {
            const auto measured = waveGain(points, n, axis);
            const double gain = symbol*symbol*(axis == 0 ? 4.0/3 : 1);
            EXPECT_NEAR(measured.first, gain, 1e-10) << "axis " << axis;
            EXPECT_NEAR(measured.second, gain, 1e-10) << "axis " << axis;
        }
    }
}


TEST(StressDivergence, compressionWaveInThePlane)
{
    const lattice points = planeLattice(24, 1.3);
    const double symbol = gradientGain(points, waveNumber(points, 24));
    EXPECT_NEAR(waveGain(points, 24, 0).first, symbol*symbol, 1e-10);
}


// Every component of a linear stress, on a lattice
TEST(StressDivergence, linearStress)
{
    const lattice points{{11, 12, 10}, 0.01, kernelType::wendlandC2, 1.5};
    particleCloud cloud(points);
    particles& f = cloud.fluid;
    for (int i = 0; i < cloud.size(); ++i)
    {
        const double x = f.x[i], y = f.y[i], z = f.z[i];
        f.S[0][i] = 1 + 2*x - y + z;
        f.S[1][i] = 2 - 3*x + 4*y + 5*z;
        f.S[2][i] = 3 + 6*x + y - 7*z;
        f.S[3][i] = 4 - x + 8*y - 2*z;
        f.S[4][i] = 5 + 3*x - 9*y + 10*z;
        f.S[5][i] = 6 + x + y - 11*z;
    }
    addStressDivergence(cloud.near, cloud.walls, f);

    const double c = gradientGain(points, 0)/1000;
    int nInside = 0;
    for (int i = 0; i < cloud.size(); ++i)
    {
        if (cloud.inside(i, cloud.near.kernel().support()))
        {
            ++nInside;
            ASSERT_NEAR(f.ax[i], c*(2 + 4 - 7), 1e-12);
            ASSERT_NEAR(f.ay[i], c*(-3 + 8 + 10), 1e-12);
            ASSERT_NEAR(f.az[i], c*(6 - 9 - 11), 1e-12);
        }
    }
    EXPECT_GT(nInside, 50);
}

// ************************************************************************* //
