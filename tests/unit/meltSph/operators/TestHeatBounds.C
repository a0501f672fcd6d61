/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conductionScale.H"
#include "heatConduction.H"
#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"

#include <algorithm>
#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const double kappa = 0.4, Cp = 2000, cold = 300, hot = 400;

//- Explicit steps of random temperatures, or of some hot particles in the cold:
//  none may leave the bounds. dt = share h^2 rho Cp/kappa
void expectBounds(particleCloud& cloud, const double share, const bool spots)
{
    particles& f = cloud.fluid;
    for (double& T : f.T)
    {
        T = cloud.random(cold, hot);
        T = spots ? (T > 395 ? hot : cold) : T;
    }
    conductionScale(cloud.near.kernel(), cloud.points().spacing).update
    (
        cloud.near, cloud.walls, kappa, f
    );

    const double h = cloud.points().h();
    const double dt = share*h*h*1000*Cp/kappa;
    for (int step = 0; step < 20; ++step)
    {
        const auto bounds = std::minmax_element(f.T.begin(), f.T.end());
        const bool walls = cloud.walls.size();
        const double low = walls ? cold : *bounds.first;
        const double high = walls ? hot : *bounds.second;
        heatConduction
        (
            cloud.near, cloud.walls, kappa, cloud.points().spacing, f
        );
        for (int i = 0; i < cloud.size(); ++i)
        {
            f.T[i] += dt*f.dH[i]/Cp;
            ASSERT_GE(f.T[i], low - 1e-9) << "step " << step;
            ASSERT_LE(f.T[i], high + 1e-9) << "step " << step;
        }
    }
}


lattice disordered(const kernelType kernel, const double jitter)
{
    return {{9, 8, 7}, 0.01, kernel, 1.2, jitter};
}

const double jitters[] = {0, 0.2, 0.4};

} // End anonymous namespace


TEST(HeatBounds, quinticSplineUpToTwoTenths)
{
    for (const double jitter : jitters)
    {
        for (const bool spots : {false, true})
        {
            particleCloud cloud(disordered(kernelType::quinticSpline, jitter));
            expectBounds(cloud, 0.2, spots);
        }
    }
}


TEST(HeatBounds, WendlandUpToOneTenth)
{
    for (const double jitter : jitters)
    {
        for (const bool spots : {false, true})
        {
            particleCloud cloud(disordered(kernelType::wendlandC2, jitter));
            expectBounds(cloud, 0.1, spots);
        }
    }
}


TEST(HeatBounds, conductivitiesThatDiffer)
{
    for (const unsigned seed : {1u, 2u})
    {
        particleCloud cloud(disordered(kernelType::quinticSpline, 0.4), seed);
        cloud.fluid.kappa.resize(cloud.size());
        cloud.randomise(cloud.fluid.kappa, 0.01*kappa, kappa);
        expectBounds(cloud, 0.2, true);
    }
}


// Particles as near to the wall as a tenth of the spacing
TEST(HeatBounds, betweenWallsOfFixedTemperature)
{
    for (const kernelType kernel :
        {kernelType::quinticSpline, kernelType::wendlandC2})
    {
        for (const double jitter : jitters)
        {
            particleCloud cloud(disordered(kernel, jitter));
            cloud.addWall(0, false);
            cloud.addWall(0, true);
            wallState& walls = cloud.walls;
            for (std::size_t i = 0; i < walls.size(); ++i)
            {
                walls.T[i] = walls.nx[i] < 0 ? hot : cold;
                walls.heatTransfer[i] =
                    std::numeric_limits<double>::infinity();
            }
            cloud.build();
            expectBounds(cloud, 0.09, jitter > 0);
        }
    }
}

// ************************************************************************* //
