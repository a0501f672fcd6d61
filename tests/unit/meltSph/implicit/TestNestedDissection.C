/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nestedDissection.H"

#include <Eigen/Sparse>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;

namespace
{

using node = std::array<std::int64_t, 3>;

std::vector<node> box(const int nx, const int ny, const int nz)
{
    std::vector<node> nodes;
    for (int x = 0; x < nx; ++x)
    {
        for (int y = 0; y < ny; ++y)
        {
            for (int z = 0; z < nz; ++z)
            {
                nodes.push_back({x - 3, y + 10, z});
            }
        }
    }
    return nodes;
}


//- Entries of the factor of the matrix of trilinear elements, nodes in order
template<class Ordering>
long entries
(
    const std::vector<node>& nodes,
    const std::vector<int>& place,
    const node& nInPeriod = {}
)
{
    const int n = int(nodes.size());
    std::vector<Eigen::Triplet<double>> a;
    for (int i = 0; i < n; ++i)
    {
        for (int j = 0; j < n; ++j)
        {
            const auto near = [&](const int axis)
            {
                const auto d = std::abs(nodes[i][axis] - nodes[j][axis]);
                return d < 2 || d == nInPeriod[axis] - 1;
            };
            if (near(0) && near(1) && near(2))
            {
                a.emplace_back(place[i], place[j], i == j ? 30 : -1);
            }
        }
    }
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(a.begin(), a.end());
    Eigen::SimplicialLLT
    <
        Eigen::SparseMatrix<double>, Eigen::Lower, Ordering
    > factor(A);
    EXPECT_EQ(factor.info(), Eigen::Success);
    return factor.matrixL().nestedExpression().nonZeros();
}

} // End anonymous namespace


TEST(NestedDissection, isAnOrderWithLittleFill)
{
    for (const auto& nodes : {box(11, 11, 11), box(40, 6, 6), box(30, 30, 2)})
    {
        const std::vector<int> place(nestedDissection(nodes));
        std::vector<int> sorted(place), numbers(place.size());
        std::sort(sorted.begin(), sorted.end());
        std::iota(numbers.begin(), numbers.end(), 0);
        EXPECT_EQ(sorted, numbers);

        // Beside an order by minimum degree
        EXPECT_LT
        (
            entries<Eigen::NaturalOrdering<int>>(nodes, place),
            entries<Eigen::AMDOrdering<int>>(nodes, numbers)
        );
    }
}


TEST(NestedDissection, cutsPeriodsOpen)
{
    std::vector<node> nodes(box(24, 6, 6));
    for (node& n : nodes)
    {
        n[0] += 3;
    }
    const node period{24, 0, 0};
    const std::vector<int> place(nestedDissection(nodes, period));
    std::vector<int> sorted(place), numbers(place.size());
    std::sort(sorted.begin(), sorted.end());
    std::iota(numbers.begin(), numbers.end(), 0);
    EXPECT_EQ(sorted, numbers);

    const long fill =
        entries<Eigen::NaturalOrdering<int>>(nodes, place, period);
    EXPECT_LT(fill, entries<Eigen::AMDOrdering<int>>(nodes, numbers, period));
    const std::vector<int> closed(nestedDissection(nodes));
    EXPECT_LT
    (
        fill, entries<Eigen::NaturalOrdering<int>>(nodes, closed, period)
    );
}


TEST(NestedDissection, halvesFirst)
{
    const std::vector<node> nodes(box(7, 2, 1));
    const std::vector<int> place(nestedDissection(nodes));
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        EXPECT_EQ(place[i] >= 12, nodes[i][0] == 0) << i;
    }
}


TEST(NestedDissection, takesAnyNumber)
{
    EXPECT_EQ(nestedDissection({}), std::vector<int>());
    EXPECT_EQ(nestedDissection({{5, 5, 5}}), std::vector<int>({0}));
}

// ************************************************************************* //
