/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltExtent.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double Foam::melt::meltExtent::filled
(
    const int x,
    const int y,
    const int z
) const
{
    return
        grid_.inside(x, y, z)
      ? double(grid_.mass(x, y, z))/voxelMaterial::full : 0;
}


double Foam::melt::meltExtent::covered
(
    const voxelPhase phase,
    const double own,
    const double behind
)
{
    const double wedge = phase == LIQUID ? 2 : 1;

    return wedge*own < behind ? wedge*own/behind : 1;
}


void Foam::melt::meltExtent::addToBox(const int x, const int y, const int z)
{
    const std::array<int, 3> v{x, y, z};
    const auto phase = voxelPhase(grid_.phase(x, y, z));
    const double own = filled(x, y, z);
    for (int k = 0; k < 3; ++k)
    {
        std::array<int, 3> d{0, 0, 0};
        d[k] = 1;
        const double before = filled(x - d[0], y - d[1], z - d[2]);
        const double after = filled(x + d[0], y + d[1], z + d[2]);

        // Liquid, and what is on a floor, lies at the bottom of a voxel
        const bool lies =
            k == 2 && (phase == LIQUID || grid_.phase(x, y, z - 1) == ROCK);
        low[k] = std::min
        (
            low[k], v[k] + (lies ? 0 : 1 - covered(phase, own, after))
        );
        high[k] = std::max
        (
            high[k], v[k] + (lies ? own : covered(phase, own, before))
        );
    }
}


void Foam::melt::meltExtent::addToRadius
(
    const int x,
    const int y,
    const int z
)
{
    const double rx = x + 0.5 - axis_[0], ry = y + 0.5 - axis_[1];
    const double r = std::hypot(rx, ry);
    double a = r > 0 ? std::abs(rx)/r : 1, b = r > 0 ? std::abs(ry)/r : 0;

    // A voxel that does not reach farther even if it is covered
    if (r + 0.5*(a + b) <= radius)
    {
        return;
    }

    // Inwards: straight on along the longer component, and diagonally
    const int sx = rx > 0 ? 1 : -1, sy = ry > 0 ? 1 : -1;
    const double straight =
        a >= b ? filled(x - sx, y, z) : filled(x, y - sy, z);
    const double diagonal = filled(x - sx, y - sy, z);
    if (a < b)
    {
        std::swap(a, b);
    }
    const double behind = straight + (diagonal - straight)*b/a;
    const double part = covered
    (
        voxelPhase(grid_.phase(x, y, z)), filled(x, y, z), behind
    );
    radius = std::max(radius, r + lineAt(part, a, b));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::meltExtent::meltExtent
(
    const voxelGrid& grid,
    const std::array<double, 2>& axis,
    const double seen
)
:
    grid_(grid),
    axis_(axis),
    seen_(seen)
{
    low.fill(1e30);
    high.fill(-1e30);

    const auto least = std::int32_t(seen_*voxelMaterial::full);
    const std::array<int, 3>& nb = grid_.nBricks();
    for (int index = 0; index < nb[0]*nb[1]*nb[2]; ++index)
    {
        const voxelBrick& b = grid_.brick(index);
        if (b.nLiquid + b.nSolid == 0)
        {
            continue;
        }
        const std::array<int, 3> o = grid_.origin(index);
        for (int i = 0; i < voxelBrick::size; ++i)
        {
            if (b.mass[i] > 0 && b.mass[i] >= least)
            {
                const int x = o[0] + (i >> 6);
                const int y = o[1] + ((i >> 3) & 7);
                const int z = o[2] + (i & 7);
                addToBox(x, y, z);
                addToRadius(x, y, z);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

double Foam::melt::meltExtent::lineAt
(
    const double part,
    const double a,
    const double b
)
{
    if (part > 0.5)
    {
        return -lineAt(1 - part, a, b);
    }

    return
        (2*a*part <= b ? std::sqrt(2*a*b*part) : a*part + 0.5*b)
      - 0.5*(a + b);
}

// ************************************************************************* //
