/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"

#include <algorithm>
#include <cmath>
#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

//- Particle j's nearest of 27 images is closer to i than the radius
bool near
(
    const particles& f,
    const int i,
    const int j,
    const std::array<double, 3>& period,
    const double radius
)
{
    for (int image = 0; image < 27; ++image)
    {
        const double dx = f.x[i] - f.x[j] + (image%3 - 1)*period[0];
        const double dy = f.y[i] - f.y[j] + (image/3%3 - 1)*period[1];
        const double dz = f.z[i] - f.z[j] + (image/9 - 1)*period[2];
        if (dx*dx + dy*dy + dz*dz < radius*radius)
        {
            return true;
        }
    }
    return false;
}

} // End anonymous namespace


TEST(PeriodicBox, nearestImageIsOddAndWithinHalfAPeriod)
{
    const periodicBox box({-1, 0, 5}, {3, 0, 0.7});
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-20, 20);

    for (int k = 0; k < 1000; ++k)
    {
        const double d[3] =
            {uniform(generator), uniform(generator), uniform(generator)};
        double dx = d[0], dy = d[1], dz = d[2];
        box.nearestImage(dx, dy, dz);

        EXPECT_LE(std::abs(dx), 1.5);
        EXPECT_EQ(dy, d[1]);
        EXPECT_LE(std::abs(dz), 0.35 + 1e-12);
        EXPECT_NEAR(std::remainder(dx - d[0], 3), 0, 1e-12);
        EXPECT_NEAR(std::remainder(dz - d[2], 0.7), 0, 1e-12);

        double ex = -d[0], ey = -d[1], ez = -d[2];
        box.nearestImage(ex, ey, ez);
        EXPECT_EQ(ex, -dx);
        EXPECT_EQ(ez, -dz);
    }
}


TEST(PeriodicBox, coordinateComesBackIntoTheBox)
{
    const periodicBox box({-1, 0, 5}, {3, 0, 0.7});

    EXPECT_TRUE(box.any());
    EXPECT_FALSE(periodicBox().any());
    EXPECT_DOUBLE_EQ(box.inside(2.5, 0), -0.5);
    EXPECT_DOUBLE_EQ(box.inside(-7.5, 0), 1.5);
    EXPECT_EQ(box.inside(-1, 0), -1);
    EXPECT_EQ(box.inside(2, 0), -1);
    EXPECT_EQ(box.periodsBeyond(-7.5, 0), -3);

    // Just below the lower end is just below the upper one, or the lower end
    EXPECT_LT(box.inside(std::nextafter(-1, -2), 0), 2);
    EXPECT_LT(box.inside(std::nextafter(5, 4), 2), 5.7);
    EXPECT_TRUE(std::isnan(box.inside(std::nan(""), 0)));
}


// As many cells along a period as it has (2 at least), in 2 and 3 dimensions
TEST(PeriodicBox, listsHoldTheNearestImages)
{
    const std::array<std::array<int, 3>, 4> sizes
    {{
        {6, 7, 6}, {6, 9, 12}, {24, 6, 1}, {40, 6, 1}
    }};
    for (const std::array<int, 3>& n : sizes)
    {
        for (const bool all : {false, true})
        {
            lattice points{n, 0.01};
            points.kernel = smoothingKernel::kernelType::wendlandC2;
            points.jitter = 1.5;
            points.periodic = {true, all, all && n[2] > 1};
            const particleCloud cloud(points, 7);
            const particles& f = cloud.fluid;
            const double radius = cloud.near.radius();

            std::array<double, 3> period;
            for (int a = 0; a < 3; ++a)
            {
                period[a] = points.box().period(a);
                ASSERT_TRUE(period[a] == 0 || period[a] >= 2*radius);
            }

            int nPairs = 0;
            cloud.near.fluid().forEach([&](const int i, const auto& row)
            {
                std::vector<int> found;
                for (int k = 0; k < row.size(); ++k)
                {
                    if (row[k] != i)
                    {
                        found.push_back(row[k]);
                    }
                }
                std::sort(found.begin(), found.end());

                std::vector<int> expected;
                for (int j = 0; j < f.size(); ++j)
                {
                    if (j != i && near(f, i, j, period, radius))
                    {
                        expected.push_back(j);
                    }
                }
                #pragma omp critical
                {
                    EXPECT_EQ(found, expected) << i;
                    nPairs += int(found.size());
                }
            });
            EXPECT_EQ(nPairs, int(cloud.near.fluid().nPairs()));
        }
    }
}


TEST(PeriodicBox, particlesComeBackWhenTheListsAreBuilt)
{
    lattice points{{12, 12, 1}, 0.01};
    points.periodic = {true, false, false};
    particleCloud cloud(points);
    particles& f = cloud.fluid;
    const std::uint64_t nPairs = cloud.near.fluid().nPairs();

    // 2.25 periods on; one particle back by one
    for (double& x : f.x)
    {
        x += 2.25*0.12;
    }
    f.x[3] -= 3*0.12;
    cloud.build();

    for (const double x : f.x)
    {
        EXPECT_GE(x, 0);
        EXPECT_LT(x, 0.12);
    }
    EXPECT_EQ(cloud.near.fluid().nPairs(), nPairs);

    // A quarter of them is three periods on, the others two
    EXPECT_NEAR
    (
        cloud.near.crossed()[0],
        f.m[0]*0.12*(144*2.25 - 3),
        1e-9*f.m[0]
    );
    EXPECT_EQ(cloud.near.crossed()[1], 0);
}

// ************************************************************************* //
