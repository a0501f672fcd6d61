/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nestedDissection.H"

#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using index = std::array<std::int64_t, 3>;
using iterator = std::vector<int>::iterator;

//- Put the nodes [begin, end) into order
void dissect
(
    const std::vector<index>& nodes,
    const iterator begin,
    const iterator end
)
{
    int axis = 0;
    std::int64_t middle = 0, longest = -1;
    for (int a = 0; a < 3 && begin != end; ++a)
    {
        const auto [low, high] = std::minmax_element
        (
            begin, end,
            [&](const int i, const int j) { return nodes[i][a] < nodes[j][a]; }
        );
        const std::int64_t extent = nodes[*high][a] - nodes[*low][a];
        if (extent > longest)
        {
            longest = extent;
            axis = a;
            middle = nodes[*low][a] + extent/2;
        }
    }
    if (longest < 2)
    {
        return;
    }

    const iterator upper = std::stable_partition
    (
        begin, end, [&](const int i) { return nodes[i][axis] < middle; }
    );
    const iterator plane = std::stable_partition
    (
        upper, end, [&](const int i) { return nodes[i][axis] > middle; }
    );
    dissect(nodes, begin, upper);
    dissect(nodes, upper, plane);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<int> Foam::melt::nestedDissection
(
    const std::vector<std::array<std::int64_t, 3>>& nodes,
    const std::array<std::int64_t, 3>& nInPeriod
)
{
    std::vector<int> order(nodes.size());
    std::iota(order.begin(), order.end(), 0);
    iterator end = order.end();
    for (int axis = 0; axis < 3; ++axis)
    {
        if (nInPeriod[axis])
        {
            const iterator seam = std::stable_partition
            (
                order.begin(), end,
                [&](const int i) { return nodes[i][axis] != 0; }
            );
            dissect(nodes, seam, end);
            end = seam;
        }
    }
    dissect(nodes, order.begin(), end);

    std::vector<int> placeOf(nodes.size());
    for (std::size_t place = 0; place < order.size(); ++place)
    {
        placeOf[order[place]] = int(place);
    }
    return placeOf;
}

// ************************************************************************* //
