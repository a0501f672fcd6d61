/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "publishedSpreading.H"
#include "publishedRule.H"

#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::melt;

//- Voxels along an edge of the floor
constexpr int n = 192;

struct size
{
    //- Root of the mean square distance from the axis, and radius of the
    //  outline at 1/1000 of the largest thickness [voxels]
    double meanSquare, outline;
};


size sizeOf(const voxelGrid& grid)
{
    std::vector<double> h(n*n, 0);
    double total = 0, moment = 0, highest = 0;
    for (int i = 0; i < n*n; ++i)
    {
        const int x = i/n, y = i % n;
        for (int z = 0; z < grid.n()[2]; ++z)
        {
            h[i] += double(grid.mass(x, y, z))/voxelMaterial::full;
        }
        const double r = std::hypot(x + 0.5 - 0.5*n, y + 0.5 - 0.5*n);
        total += h[i];
        moment += h[i]*r*r;
        highest = std::max(highest, h[i]);
    }
    double area = 0;
    for (const double hi : h)
    {
        area += hi > 1e-3*highest;
    }
    return {std::sqrt(moment/total), std::sqrt(area/M_PI)};
}


void spread(const publishedCoeffs& coeffs)
{
    const enthalpyCurve curve{1000, 1000, 300, 310, 2e5};
    voxelGrid grid
    (
        {n, n, 16},
        1e-3,
        voxelMaterial(curve, 1000, 0.2, 0.2, 0.5, 1e-3, 250, 400)
    );
    for (int x = 0; x < n; ++x)
    {
        for (int y = 0; y < n; ++y)
        {
            for (int z = 0; z < 8; ++z)
            {
                if (std::hypot(x + 0.5 - 0.5*n, y + 0.5 - 0.5*n) < 8)
                {
                    grid.fill(x, y, z, 1, 350);
                }
            }
        }
    }
    grid.refresh();

    publishedRule rule(coeffs);
    std::printf("    steps   mean square  exponent   outline  exponent\n");
    size before{0, 0};
    int step = 0;
    for (const int next : {25, 50, 100, 200, 400, 800, 1600, 3200})
    {
        for (; step < next; ++step)
        {
            rule.spread(grid);
            rule.fall(grid);
        }
        const size now(sizeOf(grid));
        const bool first = before.outline == 0;
        std::printf
        (
            "    %5d   %11.2f  %8.3f  %8.2f  %8.3f\n",
            step,
            now.meanSquare,
            first ? 0 : std::log2(now.meanSquare/before.meanSquare),
            now.outline,
            first ? 0 : std::log2(now.outline/before.outline)
        );
        before = now;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::publishedSpreading()
{
    std::printf("Published rule, defaults: a drop loses Energy and stops\n");
    spread({0.8, 0.1, 0.2, 0.1, 0.5, 0.98, 0.95, 0.9, false, 0});
    std::printf("Published rule, Energy is kept\n");
    spread({0.8, 0.1, 0.2, 0.1, 0.5, 1, 1, 1, false, 0});
}

// ************************************************************************* //
