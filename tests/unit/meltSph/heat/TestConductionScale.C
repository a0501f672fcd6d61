/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conductionScale.H"
#include "heatConduction.H"
#include "latticeMoment.H"
#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"

#include <algorithm>
#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const double kappa = 0.4, spacing = 0.01;

void setScale(particleCloud& cloud)
{
    conductionScale(cloud.near.kernel(), spacing).update
    (
        cloud.near, cloud.walls, kappa, cloud.fluid
    );
}


double conduct(particleCloud& cloud)
{
    return heatConduction
    (
        cloud.near, cloud.walls, kappa, spacing, cloud.fluid
    );
}


//- Heat through the middle of a bar whose temperature rises linearly along x
//  over kappa A dT/dx: what all on one side of the middle receive, whatever
//  happens at the bar's ends
double gainAlong(const lattice& points)
{
    particleCloud cloud(points);
    particles& f = cloud.fluid;
    setScale(cloud);
    for (int i = 0; i < cloud.size(); ++i)
    {
        f.T[i] = 300 + f.x[i];
    }
    conduct(cloud);

    double heat = 0;
    for (int i = 0; i < cloud.size(); ++i)
    {
        heat += f.x[i] < 0.5*points.n[0]*spacing ? f.m[i]*f.dH[i] : 0;
    }
    const double area = points.n[1]*points.n[2]*spacing*spacing;
    return heat/(kappa*area*(points.dimensions() == 2 ? 1/spacing : 1));
}


//- s^2 of the particle nearest to x, times the lattice's moment
double scaleAt(const particleCloud& cloud, const vector3& x)
{
    const particles& f = cloud.fluid;
    int nearest = 0;
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < f.size(); ++i)
    {
        const double d = std::hypot
        (
            f.x[i] - x[0], f.y[i] - x[1], f.z[i] - x[2]
        );
        if (d < least)
        {
            least = d;
            nearest = i;
        }
    }
    return
        std::pow(f.conductionScale[nearest], 2)
       *latticeMoment(cloud.near.kernel(), spacing);
}


struct kernelChoice
{
    kernelType type;
    double smoothingRatio;
};

const kernelChoice kernels[] =
{
    {kernelType::wendlandC2, 1.2},
    {kernelType::wendlandC2, 1.5},
    {kernelType::quinticSpline, 1}
};

} // End anonymous namespace


// Only the lattice's own gain is corrected
TEST(ConductionScale, isThatOfTheLatticeInside)
{
    for (const kernelChoice& kernel : kernels)
    {
        particleCloud cloud
        (
            {
                {8, 8, 8}, spacing, kernel.type, kernel.smoothingRatio, 0,
                {true, true, true}
            }
        );
        setScale(cloud);
        const double moment = latticeMoment(cloud.near.kernel(), spacing);
        for (const double scale : cloud.fluid.conductionScale)
        {
            ASSERT_NEAR(scale*scale*moment, 1, 1e-12);
        }
    }
}


// A plate of two layers, a thread of four particles, in the plane a strip of
// two rows have but one kind of particle: exact
TEST(ConductionScale, thinBodiesConductAsTheyShould)
{
    for (const kernelChoice& kernel : kernels)
    {
        const auto bar = [&](const int ny, const int nz, const bool wide)
        {
            return lattice
            {
                {16, ny, nz}, spacing, kernel.type, kernel.smoothingRatio, 0,
                {false, wide, false}
            };
        };
        EXPECT_NEAR(gainAlong(bar(8, 2, true)), 1, 1e-8);
        EXPECT_NEAR(gainAlong(bar(2, 2, false)), 1, 1e-8);
        EXPECT_NEAR(gainAlong(bar(2, 1, false)), 1, 1e-8);
    }
}


// Without the factors 0.90 and 0.87 of the heat flows through the first two of
// these
TEST(ConductionScale, flatSurfacesAndEdges)
{
    for (const kernelChoice& kernel : kernels)
    {
        for (const int n : {8, 6, 4})
        {
            const double gain = gainAlong
            (
                {{16, n, n}, spacing, kernel.type, kernel.smoothingRatio}
            );
            RecordProperty
            (
                "gain" + std::to_string(n) + std::to_string(int(kernel.type)),
                std::to_string(gain)
            );
            EXPECT_NEAR(gain, 1, 0.01);
        }
    }
}


TEST(ConductionScale, ofASprayIsBounded)
{
    particleCloud cloud
    (
        lattice{{9, 8, 7}, spacing, kernelType::wendlandC2, 1.2, 0.5}
    );
    particles& f = cloud.fluid;
    std::vector<int> some;
    for (int i = 0; i < cloud.size(); i += 7)
    {
        some.push_back(i);
    }
    f.permute(some);
    cloud.build();
    setScale(cloud);

    const smoothingKernel& kernel = cloud.near.kernel();
    const auto ends = std::minmax_element
    (
        f.conductionScale.begin(), f.conductionScale.end()
    );
    EXPECT_GE(*ends.first, 1/std::sqrt(latticeMoment(kernel, spacing)));
    EXPECT_LE
    (
        *ends.second, 1/std::sqrt(rowMoment(kernel, spacing))*(1 + 1e-14)
    );
    EXPECT_GT(*ends.second, 1.2);
}


// A wall of fixed temperature stands for the melt behind it, an adiabatic one
// for none, one that resists for a part
TEST(ConductionScale, besideWalls)
{
    double before = std::numeric_limits<double>::max();
    const double fixedTemperature = std::numeric_limits<double>::infinity();
    for (const double heatTransfer : {0.0, 20.0, 200.0, fixedTemperature})
    {
        particleCloud cloud
        (
            lattice
            {
                {8, 8, 8}, spacing, kernelType::wendlandC2, 1.2, 0,
                {false, true, true}
            }
        );
        const double alone = [&]
        {
            setScale(cloud);
            return scaleAt(cloud, {0, 0.04, 0.04});
        }();
        cloud.addWall(0, false);
        cloud.walls.heatTransfer.assign(cloud.walls.size(), heatTransfer);
        cloud.build();
        setScale(cloud);

        const double scale = scaleAt(cloud, {0, 0.04, 0.04});
        EXPECT_LT(scale, before);
        before = scale;
        if (heatTransfer == 0)
        {
            EXPECT_DOUBLE_EQ(scale, alone);
            EXPECT_NEAR(scale, 1/0.8057, 1e-4);
        }
        EXPECT_NEAR(scaleAt(cloud, {0.04, 0.04, 0.04}), 1, 1e-12);
    }
    EXPECT_NEAR(before, 1, 1e-12);
}


TEST(ConductionScale, heatIsConservedOnDisorderedParticles)
{
    for (const bool uniform : {true, false})
    {
        for (const unsigned seed : {1u, 2u, 3u})
        {
            particleCloud cloud
            (
                lattice{{9, 8, 7}, spacing, kernelType::wendlandC2, 1.3, 0.4},
                seed
            );
            particles& f = cloud.fluid;
            cloud.randomiseDensity(0.3);
            cloud.randomise(f.T, 300, 400);
            if (!uniform)
            {
                f.kappa.resize(f.size());
                cloud.randomise(f.kappa, 0.01, 10);
            }
            setScale(cloud);
            EXPECT_EQ(conduct(cloud), 0);

            double sum = 0, all = 0;
            for (int i = 0; i < cloud.size(); ++i)
            {
                sum += f.m[i]*f.dH[i];
                all += std::abs(f.m[i]*f.dH[i]);
            }
            EXPECT_GT(all, 0);
            EXPECT_NEAR(sum, 0, 1e-13*all);
        }
    }
}


TEST(ConductionScale, isSetWhenListsAreNew)
{
    particleCloud cloud(lattice{{6, 5, 4}, spacing});
    particles& f = cloud.fluid;
    conductionScale scale(cloud.near.kernel(), spacing);
    scale.update(cloud.near, cloud.walls, kappa, f);
    const particles::array first = f.conductionScale;

    f.x[0] += 0.3*spacing;
    scale.update(cloud.near, cloud.walls, kappa, f);
    EXPECT_EQ(f.conductionScale, first);

    cloud.near.build(f, cloud.walls);
    scale.update(cloud.near, cloud.walls, kappa, f);
    EXPECT_NE(f.conductionScale, first);
}

// ************************************************************************* //
