/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointCloud.H"

#include <algorithm>
#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
namespace unitTest
{

void pointCloud::add(const double xi, const double yi, const double zi)
{
    x.push_back(xi);
    y.push_back(yi);
    z.push_back(zi);
}


double pointCloud::distance2
(
    const int i,
    const pointCloud& b,
    const int j
) const
{
    const double dx = x[i] - b.x[j];
    const double dy = y[i] - b.y[j];
    const double dz = z[i] - b.z[j];
    return dx*dx + dy*dy + dz*dz;
}


void pointCloud::sort
(
    cellGrid& grid,
    const double cellSize,
    std::vector<int>& order
)
{
    grid.sort(x.data(), y.data(), z.data(), size(), cellSize, order);
    for (std::vector<double>* a : {&x, &y, &z})
    {
        std::vector<double> sorted;
        for (const int i : order)
        {
            sorted.push_back((*a)[i]);
        }
        a->swap(sorted);
    }
}


neighbourList pointCloud::sortAndList(const double radius)
{
    cellGrid grid;
    std::vector<int> order;
    sort(grid, radius, order);

    neighbourList list;
    list.buildSelf(x.data(), y.data(), z.data(), size(), grid, radius);
    return list;
}


std::vector<int> pointCloud::closerThan
(
    const double radius,
    const pointCloud& targets,
    const int i,
    const bool self
) const
{
    std::vector<int> found;
    for (int j = 0; j < size(); ++j)
    {
        if
        (
            targets.distance2(i, *this, j) < radius*radius
         && !(self && i == j)
        )
        {
            found.push_back(j);
        }
    }
    return found;
}


pointCloud pointCloud::box
(
    const int n,
    const double lx,
    const double ly,
    const double lz,
    const unsigned seed
)
{
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    pointCloud points;
    for (int i = 0; i < n; ++i)
    {
        const double a = uniform(generator);
        const double b = uniform(generator);
        points.add(lx*a, ly*b, lz*uniform(generator));
    }
    return points;
}


pointCloud pointCloud::clusters(const int n, const unsigned seed)
{
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::normal_distribution<double> normal;
    pointCloud points;
    double cx = 0, cy = 0, cz = 0, width = 1;
    for (int i = 0; i < n; ++i)
    {
        if (i % 50 == 0)
        {
            cx = uniform(generator);
            cy = uniform(generator);
            cz = uniform(generator);
            width = 0.01 + 0.2*(1 + uniform(generator));
        }
        const double a = normal(generator);
        const double b = normal(generator);
        points.add
        (
            cx + width*a, cy + width*b, cz + width*normal(generator)
        );
    }
    points.add(points.x[0], points.y[0], points.z[0]);
    points.add(points.x[7], points.y[7], points.z[7]);
    return points;
}


neighbourTable selfRows(const neighbourList& list, const int n)
{
    neighbourTable all(n);
    list.forEach
    (
        [&](const int i, const auto& row)
        {
            for (int k = 0; k < row.size(); ++k)
            {
                all[i].push_back(row[k]);
            }
        }
    );
    return all;
}


neighbourTable sourceRows(const neighbourList& list, const int nTargets)
{
    neighbourTable all(nTargets);
    for (int i = 0; i < nTargets; ++i)
    {
        const auto row = list.sourcesOf(i);
        for (int k = 0; k < row.size(); ++k)
        {
            all[i].push_back(row[k]);
        }
    }
    return all;
}


neighbourTable sorted(const neighbourTable& selfRows)
{
    neighbourTable all = selfRows;
    for (int i = 0; i < int(all.size()); ++i)
    {
        while (!all[i].empty() && all[i].back() == i)
        {
            all[i].pop_back();
        }
        std::sort(all[i].begin(), all[i].end());
    }
    return all;
}

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
