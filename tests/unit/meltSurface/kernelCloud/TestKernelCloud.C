/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "kernelCloud.H"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <stdexcept>

using Foam::melt::kernelCloud;

namespace
{

//- Unit cube of 10^3 particles on a lattice
struct lattice
{
    static constexpr int n = 10;
    static constexpr double spacing = 1.0/n;
    std::vector<double> position;
    std::vector<double> volume;

    lattice()
    {
        for (int i = 0; i < n*n*n; ++i)
        {
            position.push_back((i % n + 0.5)*spacing);
            position.push_back((i/n % n + 0.5)*spacing);
            position.push_back((i/n/n + 0.5)*spacing);
            volume.push_back(spacing*spacing*spacing);
        }
    }

    kernelCloud cloud(const double radius) const
    {
        return
            kernelCloud(volume.size(), position.data(), volume.data(), radius);
    }
};

}

TEST(kernelCloud, kernelIntegratesToOne)
{
    const double radius = 0.3;
    const int n = 2000;
    double sum = 0;
    for (int i = 0; i < n; ++i)
    {
        const double r = (i + 0.5)*radius/n;
        sum += 4*M_PI*r*r*kernelCloud::kernel(r, radius)*radius/n;
    }
    EXPECT_NEAR(sum, 1, 1e-6);
    EXPECT_EQ(kernelCloud::kernel(radius, radius), 0);
}

TEST(kernelCloud, chiIsOneInsideHalfAtTheFaceZeroOutside)
{
    const lattice particles;
    const std::vector<double> points =
        {0.5, 0.5, 0.5,  0.5, 0.5, 1.0,  0.5, 0.5, 1.5,  50, 50, 50};
    const auto chi = particles.cloud(0.3).chi(4, points.data());
    EXPECT_NEAR(chi[0], 1, 0.01);
    EXPECT_NEAR(chi[1], 0.5, 0.01);
    EXPECT_EQ(chi[2], 0);
    EXPECT_EQ(chi[3], 0);
}

TEST(kernelCloud, chiEqualsTheSumOverAllParticles)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const std::size_t n = 500;
    const double radius = 0.37;
    std::vector<double> x(3*n), v(n);
    for (double& value : x) value = uniform(random);
    for (double& value : v) value = 1 + uniform(random);
    const kernelCloud cloud(n, x.data(), v.data(), radius);

    // Points beyond the particles too
    std::vector<double> points(x);
    for (double& value : points) value *= 1.3;
    const auto chi = cloud.chi(n, points.data());
    for (std::size_t i = 0; i < n; ++i)
    {
        double sum = 0;
        for (std::size_t j = 0; j < n; ++j)
        {
            const double r = std::sqrt
            (
                std::pow(points[3*i] - x[3*j], 2)
              + std::pow(points[3*i + 1] - x[3*j + 1], 2)
              + std::pow(points[3*i + 2] - x[3*j + 2], 2)
            );
            sum += v[j]*kernelCloud::kernel(r, radius);
        }
        EXPECT_NEAR(chi[i], sum, 1e-12*(1 + sum));
    }
}

TEST(kernelCloud, normalsPointOutOfTheFaces)
{
    const lattice particles;
    const std::vector<double> points = {0.5, 0.5, 1.0,  0, 0.5, 0.5};
    const auto normal = particles.cloud(0.3).normals(2, points.data());
    EXPECT_NEAR(normal[2], 1, 1e-12);
    EXPECT_NEAR(normal[3], -1, 1e-12);
}

TEST(kernelCloud, interpolationKeepsConstantsAndBounds)
{
    const lattice particles;
    const std::size_t n = particles.volume.size();
    const kernelCloud cloud = particles.cloud(0.3);

    const std::vector<double> constant(n, 300.1);
    std::vector<double> height(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        height[i] = particles.position[3*i + 2];
    }

    const std::vector<double> points =
        {0.5, 0.5, 0.5,  0.31, 0.77, 0.02,  1, 1, 1,  9, 9, 9};
    const auto same = cloud.interpolate(4, points.data(), constant.data());
    EXPECT_EQ(same[0], 300.1);
    EXPECT_EQ(same[1], 300.1);
    EXPECT_EQ(same[2], 300.1);
    EXPECT_EQ(same[3], 0);

    const auto z = cloud.interpolate(3, points.data(), height.data());
    EXPECT_NEAR(z[0], 0.5, 1e-12);
    EXPECT_GE(z[1], 0.05);
    EXPECT_LE(z[2], 0.95);
}

TEST(kernelCloud, refusesBadRadius)
{
    EXPECT_THROW(kernelCloud(0, nullptr, nullptr, 0), std::invalid_argument);
    EXPECT_THROW(kernelCloud(0, nullptr, nullptr, NAN), std::invalid_argument);
}
