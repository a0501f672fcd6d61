/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelRays.H"

#include <algorithm>
#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::melt::voxelRays::blocked
(
    const voxelGrid& grid,
    const std::array<double, 3>& from,
    const std::array<double, 3>& to
)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();

    // The part of the ray, from 0 to 1, that is in the grid
    double enter = 0, leave = 1;
    std::array<double, 3> d;
    for (int k = 0; k < 3; ++k)
    {
        d[k] = to[k] - from[k];
        const double n = grid.n()[k];
        if (d[k] == 0)
        {
            if (from[k] < 0 || from[k] >= n)
            {
                return false;
            }
            continue;
        }
        const double a = -from[k]/d[k], b = (n - from[k])/d[k];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (!(enter < leave))
    {
        return false;
    }

    // Where the ray crosses the next face of each direction
    std::array<int, 3> voxel, step;
    std::array<double, 3> next, width;
    for (int k = 0; k < 3; ++k)
    {
        const double x = from[k] + enter*d[k];
        step[k] = d[k] > 0 ? 1 : -1;
        const double floor = std::floor(x);
        voxel[k] = int(d[k] < 0 && x == floor ? floor - 1 : floor);
        voxel[k] = std::clamp(voxel[k], 0, grid.n()[k] - 1);
        width[k] = d[k] == 0 ? infinity : std::abs(1/d[k]);
        next[k] =
            d[k] == 0
          ? infinity : (voxel[k] + (d[k] > 0) - from[k])/d[k];
    }

    while (true)
    {
        if
        (
            grid.brickAt(voxel[0], voxel[1], voxel[2]).phase
            [
                voxelBrick::offset(voxel[0], voxel[1], voxel[2])
            ]
         != EMPTY
        )
        {
            return true;
        }
        const int k =
            next[0] <= next[1]
          ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
        if (next[k] >= leave)
        {
            return false;
        }
        voxel[k] += step[k];
        next[k] += width[k];
        if (unsigned(voxel[k]) >= unsigned(grid.n()[k]))
        {
            return false;
        }
    }
}

// ************************************************************************* //
