/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "blockSum.H"
#include "meltUnitTests.H"

#include <cmath>
#include <omp.h>
#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;

namespace
{

//- Numbers of very different size and sign
std::vector<double> numbers(const int n, const unsigned seed)
{
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> values(n);
    for (double& value : values)
    {
        value = uniform(generator)*std::pow(10, 8*uniform(generator));
    }
    return values;
}

} // End anonymous namespace


TEST(BlockSum, sumsAll)
{
    for (const int n : {0, 1, 1023, 1024, 1025, 5000})
    {
        const double sum = blockSum(n, [](const int i) { return i + 1; });
        EXPECT_EQ(sum, 0.5*n*(n + 1.0)) << "n = " << n;
    }
}


TEST(BlockSum, sameBytesWithAnyNumberOfThreads)
{
    const int before = omp_get_max_threads();
    for (const unsigned seed : {1u, 2u, 3u})
    {
        const std::vector<double> values = numbers(50001, seed);
        std::vector<double> sums;
        for (const int threads : {1, 2, 3, 7})
        {
            omp_set_num_threads(threads);
            sums.push_back
            (
                blockSum(values.size(), [&](const int i) { return values[i]; })
            );
        }
        omp_set_num_threads(before);
        for (const double sum : sums)
        {
            EXPECT_EQ(sum, sums[0]);
        }
    }
}


TEST(ParallelMax, findsTheGreatest)
{
    const std::vector<double> values = numbers(3000, 5);
    const double greatest = parallelMax
    (
        values.size(), [&](const int i) { return values[i]; }
    );
    EXPECT_EQ(greatest, *std::max_element(values.begin(), values.end()));
    EXPECT_EQ(parallelMax(3, [](const int i) { return -5.0 - i; }), -5);
    EXPECT_EQ
    (
        parallelMax(0, [](const int) { return 1.0; }),
        std::numeric_limits<double>::lowest()
    );
}


TEST(ParallelMax, notANumberIsSeenWhereverItIs)
{
    for (const int bad : {0, 1, 1500, 2998, 2999})
    {
        const double greatest = parallelMax
        (
            3000, [&](const int i) { return i == bad ? std::nan("") : i; }
        );
        EXPECT_TRUE(std::isnan(greatest)) << bad;
    }
}

// ************************************************************************* //
