/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatConduction.H"
#include "latticeSymbol.H"
#include "meltUnitTests.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const double kappa = 0.4, cold = 300, hot = 400;
const double fixedTemperature = std::numeric_limits<double>::infinity();

//- Walls at both ends along x, the lower one cold, the upper one hot, with
//  heat transfer coefficients
void addWalls(particleCloud& cloud, const double HCold, const double HHot)
{
    cloud.addWall(0, false);
    cloud.addWall(0, true);
    wallState& walls = cloud.walls;
    for (std::size_t i = 0; i < walls.size(); ++i)
    {
        const bool upper = walls.nx[i] < 0;
        walls.T[i] = upper ? hot : cold;
        walls.heatTransfer[i] = upper ? HHot : HCold;
    }
    cloud.build();
}


double conduct(particleCloud& cloud)
{
    return heatConduction
    (
        cloud.near, cloud.walls, kappa, cloud.points().spacing, cloud.fluid
    );
}


lattice plate(const int length, const int width, const kernelType kernel)
{
    return {{length, width, 1}, 0.01, kernel, 1.3};
}


//- Heat [W/m] that the hot wall gives to a plate between a cold wall of fixed
//  temperature and a hot one, in the steady state: heat flux q [W/m2]. Every
//  particle in the middle must be in balance
double steadyHeat(particleCloud& cloud, const double q, const double HHot)
{
    addWalls(cloud, fixedTemperature, HHot);
    particles& f = cloud.fluid;
    for (int i = 0; i < cloud.size(); ++i)
    {
        f.T[i] = cold + q/kappa*f.x[i];
    }
    const double support = cloud.near.kernel().support();
    const double width = cloud.points().n[1]*cloud.points().spacing;
    conduct(cloud);
    for (int i = 0; i < cloud.size(); ++i)
    {
        if (f.y[i] > support && f.y[i] < width - support)
        {
            EXPECT_NEAR(f.dH[i], 0, 1e-9);
        }
    }

    // The hot wall alone
    for (std::size_t i = 0; i < cloud.walls.size(); ++i)
    {
        if (cloud.walls.nx[i] > 0)
        {
            cloud.walls.heatTransfer[i] = 0;
        }
    }
    return conduct(cloud);
}


//- Heat flux in the middle of a wide plate over the exact one: the ends of two
//  plates of different width are alike
double steadyFlux(const kernelType kernel, const double HHot)
{
    const double exact = (hot - cold)/(0.12/kappa + 1/HHot);
    particleCloud narrow(plate(12, 10, kernel)), wide(plate(12, 16, kernel));
    const double difference =
        steadyHeat(wide, exact, HHot) - steadyHeat(narrow, exact, HHot);
    return difference/(6*0.01)/exact;
}

} // End anonymous namespace


// As exact as the kernel's gradient of a linear field
TEST(HeatFromWalls, steadyFluxBetweenTwoWalls)
{
    for (const kernelType kernel :
        {kernelType::quinticSpline, kernelType::wendlandC2})
    {
        const double flux = steadyFlux(kernel, fixedTemperature);
        const double gain = gradientGain(plate(12, 1, kernel), 0);
        RecordProperty
        (
            kernel == kernelType::quinticSpline ? "quintic" : "Wendland",
            std::to_string(flux)
        );
        EXPECT_NEAR(flux/gain, 1, 1e-9);
        if (kernel == kernelType::quinticSpline)
        {
            EXPECT_NEAR(flux, 1, 0.01);
        }
    }
}


// Conduction and heat transfer in series
TEST(HeatFromWalls, steadyFluxThroughHeatTransfer)
{
    EXPECT_NEAR(steadyFlux(kernelType::quinticSpline, 5), 1, 0.01);
}


TEST(HeatFromWalls, meltTendsToTheLinearProfile)
{
    particleCloud cloud(plate(6, 12, kernelType::quinticSpline));
    addWalls(cloud, fixedTemperature, fixedTemperature);
    particles& f = cloud.fluid;
    f.T.assign(cloud.size(), hot);
    const double h = cloud.points().h();
    for (int step = 0; step < 300; ++step)
    {
        conduct(cloud);
        for (int i = 0; i < cloud.size(); ++i)
        {
            f.T[i] += 0.15*h*h*1000/kappa*f.dH[i];
        }
    }
    for (int i = 0; i < cloud.size(); ++i)
    {
        const double exact = cold + (hot - cold)*f.x[i]/0.06;
        ASSERT_NEAR(f.T[i], exact, 0.02*(hot - cold));
    }
}


TEST(HeatFromWalls, adiabaticWallsAreAsIfNotThere)
{
    const lattice points{{8, 7, 6}, 0.01, kernelType::wendlandC2, 1.3, 0.3};
    particleCloud alone(points), walled(points);
    alone.randomise(alone.fluid.T, cold, hot);
    walled.randomise(walled.fluid.T, cold, hot);
    addWalls(walled, 0, 0);
    conduct(alone);
    EXPECT_EQ(conduct(walled), 0);
    EXPECT_EQ(alone.fluid.dH, walled.fluid.dH);
}


TEST(HeatFromWalls, whatIsReturnedEntersTheMelt)
{
    particleCloud cloud
    (
        lattice{{8, 7, 6}, 0.01, kernelType::wendlandC2, 1.3, 0.3}
    );
    cloud.randomise(cloud.fluid.T, cold, hot);
    addWalls(cloud, 30, fixedTemperature);
    const double heat = conduct(cloud);

    double sum = 0, all = 0;
    for (int i = 0; i < cloud.size(); ++i)
    {
        sum += cloud.fluid.m[i]*cloud.fluid.dH[i];
        all += std::abs(cloud.fluid.m[i]*cloud.fluid.dH[i]);
    }
    EXPECT_NE(heat, 0);
    EXPECT_NEAR(sum, heat, 1e-13*all);
}

// ************************************************************************* //
