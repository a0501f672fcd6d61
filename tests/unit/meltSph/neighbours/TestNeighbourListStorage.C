/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/neighbours/pointCloud.H"
#include "meltUnitTests.H"

#include <algorithm>
#include <cstdlib>
#include <omp.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt::unitTest;
using Foam::melt::neighbourList;

namespace
{

//- A slab with so many particles in a layer of cells that neighbours lie
//  further apart in the sorted order than two bytes hold
pointCloud largeSlab()
{
    pointCloud slab = pointCloud::box(90000, 128, 128, 2, 9);
    slab.add(0, 0, 140);
    return slab;
}

} // End anonymous namespace


TEST(NeighbourList, twoAndFourBytes)
{
    pointCloud few = pointCloud::box(20000, 16, 16, 16, 31);
    const neighbourList narrow = few.sortAndList(1);
    EXPECT_LT(narrow.bytes(), 4*narrow.nPairs());

    pointCloud slab = largeSlab();
    const neighbourList wide = slab.sortAndList(1);
    EXPECT_GE(wide.bytes(), 4*wide.nPairs());

    const neighbourTable found = sorted(selfRows(wide, slab.size()));
    int longest = 0;
    for (int i = 0; i < slab.size(); i += 499)
    {
        ASSERT_EQ(found[i], slab.closerThan(1, slab, i, true));
        for (const int j : found[i])
        {
            longest = std::max(longest, std::abs(i - j));
        }
    }
    EXPECT_GT(longest, 32767);
}


TEST(NeighbourList, sameWithOneAndTwoThreads)
{
    const int threads = omp_get_max_threads();
    for (pointCloud points : {pointCloud::clusters(5000, 41), largeSlab()})
    {
        const double radius = points.size() < 10000 ? 0.1 : 1;
        pointCloud again = points;

        omp_set_num_threads(1);
        const neighbourTable one =
            selfRows(points.sortAndList(radius), points.size());
        omp_set_num_threads(2);
        const neighbourTable two =
            selfRows(again.sortAndList(radius), again.size());
        omp_set_num_threads(threads);

        EXPECT_EQ(points.x, again.x);
        EXPECT_TRUE(one == two);
    }
}

// ************************************************************************* //
