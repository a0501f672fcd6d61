/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/neighbours/pointCloud.H"
#include "meltUnitTests.H"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <stdexcept>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using unitTest::pointCloud;

namespace
{

std::vector<int> identity(const int n)
{
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    return order;
}


//- All points of the runs around a position
std::vector<int> candidates(const cellGrid& grid, double x, double y, double z)
{
    cellGrid::runs runs;
    const int n = grid.neighbourRuns(x, y, z, runs);
    std::vector<int> found;
    for (int r = 0; r < n; ++r)
    {
        for (int j = runs[r].begin; j < runs[r].end; ++j)
        {
            found.push_back(j);
        }
    }
    return found;
}


const std::vector<pointCloud> clouds
{
    pointCloud::box(700, 1, 2, 0.6, 1),
    pointCloud::box(700, 0.3, 0.01, 4, 2),
    pointCloud::box(400, 2, 1, 0, 3),
    pointCloud::clusters(700, 4),
    pointCloud::box(1, 1, 1, 1, 5)
};

} // End anonymous namespace


TEST(CellGrid, orderIsPermutationAndIdempotent)
{
    for (pointCloud points : clouds)
    {
        cellGrid grid;
        std::vector<int> order;
        const pointCloud before = points;
        points.sort(grid, 0.17, order);

        for (int i = 0; i < points.size(); ++i)
        {
            ASSERT_EQ(points.distance2(i, before, order[i]), 0);
        }
        std::sort(order.begin(), order.end());
        EXPECT_EQ(order, identity(points.size()));

        // Sorting sorted points changes nothing
        points.sort(grid, 0.17, order);
        EXPECT_EQ(order, identity(points.size()));
    }
}


// All points of one cell: they keep their order
TEST(CellGrid, sortIsStable)
{
    pointCloud points = pointCloud::box(300, 0.01, 0.01, 0.01, 6);
    cellGrid grid;
    std::vector<int> order;
    points.sort(grid, 1, order);
    EXPECT_EQ(order, identity(points.size()));

    // Two cells in turns
    pointCloud turns;
    for (int i = 0; i < 10; ++i)
    {
        turns.add(i % 2, 0.1*i, 0);
    }
    turns.sort(grid, 0.95, order);
    EXPECT_EQ(order, (std::vector<int>{0, 2, 4, 6, 8, 1, 3, 5, 7, 9}));
}


TEST(CellGrid, runsHoldEverythingNear)
{
    const double cell = 0.17;
    for (pointCloud points : clouds)
    {
        cellGrid grid;
        std::vector<int> order;
        points.sort(grid, cell, order);

        for (int i = 0; i < points.size(); ++i)
        {
            const std::vector<int> found =
                candidates(grid, points.x[i], points.y[i], points.z[i]);
            ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
            for (int j = 0; j < points.size(); ++j)
            {
                if (points.distance2(i, points, j) < cell*cell)
                {
                    ASSERT_TRUE
                    (
                        std::binary_search(found.begin(), found.end(), j)
                    );
                }
            }
        }
    }
}


TEST(CellGrid, reachBoundsDistancesInSortedOrder)
{
    for (pointCloud points : clouds)
    {
        cellGrid grid;
        std::vector<int> order;
        points.sort(grid, 0.17, order);

        int longest = 0;
        for (int i = 0; i < points.size(); ++i)
        {
            for
            (
                const int j :
                candidates(grid, points.x[i], points.y[i], points.z[i])
            )
            {
                longest = std::max(longest, std::abs(i - j));
            }
        }
        EXPECT_GE(grid.reach(), longest);
        EXPECT_LE(grid.reach(), points.size());
    }
}


TEST(CellGrid, nothingIsNearAPositionFarOutside)
{
    pointCloud points = clouds[0];
    cellGrid grid;
    std::vector<int> order;
    points.sort(grid, 0.1, order);

    EXPECT_TRUE(candidates(grid, -0.3, 0.5, 0.5).empty());
    EXPECT_TRUE(candidates(grid, 0.5, 0.5, 7).empty());
    EXPECT_FALSE(candidates(grid, -0.05, 0.5, 0.3).empty());

    pointCloud none;
    none.sort(grid, 0.1, order);
    EXPECT_TRUE(order.empty());
    EXPECT_TRUE(candidates(grid, 0, 0, 0).empty());
    EXPECT_EQ(grid.reach(), 0);
}


TEST(CellGrid, positionThatIsNoNumberOrFarAwayIsRefused)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf, 1e300})
    {
        for (const int which : {0, 7, 699})
        {
            pointCloud points = clouds[0];
            cellGrid grid;
            std::vector<int> order;
            points.y[which] = bad;
            EXPECT_THROW(points.sort(grid, 0.1, order), std::runtime_error)
                << bad << " at " << which;
        }
    }
}

// ************************************************************************* //
