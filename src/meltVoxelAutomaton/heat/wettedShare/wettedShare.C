/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wettedShare.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::melt;

//- Filled share of a voxel with melt on a flat floor, else 0
float filmAt(const voxelGrid& grid, const int x, const int y, const int z)
{
    if (!grid.inside(x, y, z) || grid.phase(x, y, z - 1) != ROCK)
    {
        return 0;
    }
    const voxelBrick& b = grid.brickAt(x, y, z);
    const int i = voxelBrick::offset(x, y, z);
    return b.rock[i] ? 0 : float(b.mass[i])/voxelMaterial::full;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

float Foam::melt::wettedShare
(
    const voxelGrid& grid,
    const int x,
    const int y,
    const int z
)
{
    const float film = filmAt(grid, x, y, z);
    if (!(film > 0))
    {
        return 1;
    }
    float thickness = film;
    for (const int sign : {-1, 1})
    {
        for (const int axis : {0, 1})
        {
            // No voxel holds more than 1
            float part = 0.5;
            for (int k = sign; part > thickness; k += sign, part /= 2)
            {
                const float beside = axis == 0
                  ? filmAt(grid, x + k, y, z) : filmAt(grid, x, y + k, z);
                if (!(beside > 0))
                {
                    break;
                }
                thickness = std::max(thickness, part*beside);
            }
        }
    }
    return film/thickness;
}

// ************************************************************************* //
