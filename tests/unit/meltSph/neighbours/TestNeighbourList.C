/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "indexedOctree.H"
#include "meltSph/neighbours/pointCloud.H"
#include "meltUnitTests.H"
#include "treeDataPoint.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;


TEST(NeighbourList, equalsBruteForce)
{
    std::vector<pointCloud> clouds
    {
        pointCloud::box(1500, 1, 2, 0.6, 1),
        pointCloud::box(1200, 0.2, 0.01, 4, 2),
        pointCloud::box(1200, 2, 1, 0, 3),
        pointCloud::clusters(1500, 4),
        pointCloud::box(1, 1, 1, 1, 5),
        pointCloud()
    };
    for (pointCloud& points : clouds)
    {
        const double radius = 0.15;
        const neighbourList list = points.sortAndList(radius);
        const neighbourTable found = sorted(selfRows(list, points.size()));

        std::uint64_t nPairs = 0;
        for (int i = 0; i < points.size(); ++i)
        {
            ASSERT_EQ(found[i], points.closerThan(radius, points, i, true));
            nPairs += found[i].size();
        }
        EXPECT_EQ(list.nPairs(), nPairs);
        EXPECT_EQ(list.empty(), points.size() == 0);
    }
}


TEST(NeighbourList, equalsOctree)
{
    using namespace Foam;

    for (pointCloud points :
        {pointCloud::box(6000, 1, 1.5, 0.7, 11), pointCloud::clusters(4000, 12)})
    {
        const double radius = 0.1;
        const neighbourTable found =
            sorted(selfRows(points.sortAndList(radius), points.size()));

        pointField positions(points.size());
        forAll(positions, i)
        {
            positions[i] = point(points.x[i], points.y[i], points.z[i]);
        }
        treeBoundBox bounds(positions);
        bounds.inflate(0.01);
        const indexedOctree<treeDataPoint> octree
        (
            treeDataPoint(positions), bounds, 10, 10, 3
        );

        forAll(positions, i)
        {
            const labelList inSphere
            (
                octree.findSphere(positions[i], sqr(radius))
            );
            std::vector<int> expected;
            for (const label j : inSphere)
            {
                if (j != i)
                {
                    expected.push_back(j);
                }
            }
            std::sort(expected.begin(), expected.end());
            ASSERT_EQ(found[i], expected);
        }
    }
}


TEST(NeighbourList, otherSourcesThanTargets)
{
    const double radius = 0.2;
    pointCloud sources = pointCloud::box(900, 1, 1, 1, 21);
    pointCloud targets = pointCloud::box(700, 1.5, 3, 1, 22);
    for (double& z : targets.z)
    {
        z -= 0.9;
    }
    cellGrid grid;
    std::vector<int> order;
    sources.sort(grid, radius, order);

    neighbourList list;
    list.build
    (
        targets.x.data(), targets.y.data(), targets.z.data(), targets.size(),
        sources.x.data(), sources.y.data(), sources.z.data(), grid, radius
    );
    neighbourTable found = sourceRows(list, targets.size());
    int nNear = 0;
    for (int i = 0; i < targets.size(); ++i)
    {
        const auto expected = sources.closerThan(radius, targets, i, false);
        nNear += !expected.empty();
        std::sort(found[i].begin(), found[i].end());
        ASSERT_EQ(found[i], expected);
    }
    EXPECT_GT(nNear, 50);
    EXPECT_LT(nNear, targets.size() - 50);
}


TEST(NeighbourList, emptyListHasNoSources)
{
    const neighbourList list;
    EXPECT_TRUE(list.empty());
    EXPECT_EQ(list.sourcesOf(3).size(), 0);
    EXPECT_EQ(list.nPairs(), 0u);
}

// ************************************************************************* //
