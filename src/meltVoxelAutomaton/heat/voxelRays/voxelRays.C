/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelRays.H"

#include <algorithm>
#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef std::array<int, 3> cell;

struct ray
{
    //- In voxels
    std::array<double, 3> from, way;
};


//- Walks along a part of a ray, enter < leave of 0 to 1, through the cells of
//  an edge of so many voxels, of low to high. Calls stop(cell, enter, leave)
//  for each with its part of the ray until one returns true; returns whether
//  one did
template<class Stop>
bool walk
(
    const ray& r,
    double enter,
    const double leave,
    const int edge,
    const cell& low,
    const cell& high,
    const Stop& stop
)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();

    // Where the ray crosses the next face of each direction
    cell c, step;
    std::array<double, 3> next, width;
    for (int k = 0; k < 3; ++k)
    {
        const double d = r.way[k];
        const double x = (r.from[k] + enter*d)/edge;
        const double floor = std::floor(x);
        step[k] = d > 0 ? 1 : -1;
        c[k] = int(d < 0 && x == floor ? floor - 1 : floor);
        c[k] = std::clamp(c[k], low[k], high[k]);
        width[k] = d == 0 ? infinity : std::abs(edge/d);
        next[k] =
            d == 0 ? infinity : ((c[k] + (d > 0))*edge - r.from[k])/d;
    }

    while (true)
    {
        const int k =
            next[0] <= next[1]
          ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
        const double exit = std::min(next[k], leave);
        if (stop(c, enter, exit))
        {
            return true;
        }
        c[k] += step[k];
        if (next[k] >= leave || c[k] < low[k] || c[k] > high[k])
        {
            return false;
        }
        enter = exit;
        next[k] += width[k];
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::melt::voxelRays::blocked
(
    const voxelGrid& grid,
    const std::array<double, 3>& from,
    const std::array<double, 3>& to
)
{
    // The part of the ray, from 0 to 1, that is in the grid
    double enter = 0, leave = 1;
    ray r{from, {}};
    for (int k = 0; k < 3; ++k)
    {
        const double d = to[k] - from[k];
        const double n = grid.n()[k];
        r.way[k] = d;
        if (d == 0)
        {
            if (from[k] < 0 || from[k] >= n)
            {
                return false;
            }
            continue;
        }
        const double a = -from[k]/d, b = (n - from[k])/d;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (!(enter < leave))
    {
        return false;
    }

    // By bricks, and by voxels where there is something in a brick
    const cell& nb = grid.nBricks();
    const cell& n = grid.n();
    return walk
    (
        r, enter, leave, voxelBrick::edge,
        {0, 0, 0}, {nb[0] - 1, nb[1] - 1, nb[2] - 1},
        [&](const cell& brick, const double in, const double out)
        {
            const int index = grid.brickIndex(brick[0], brick[1], brick[2]);
            if (grid.isVoid(index))
            {
                return false;
            }
            const voxelBrick& b = grid.brick(index);
            const cell o = grid.origin(index);
            return walk
            (
                r, in, out, 1,
                o,
                {
                    std::min(o[0] + 8, n[0]) - 1,
                    std::min(o[1] + 8, n[1]) - 1,
                    std::min(o[2] + 8, n[2]) - 1
                },
                [&](const cell& v, double, double)
                {
                    return
                        b.phase[voxelBrick::offset(v[0], v[1], v[2])] != EMPTY;
                }
            );
        }
    );
}

// ************************************************************************* //
