/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exposedFaces.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::melt;

void facesOfVoxel
(
    const voxelGrid& grid,
    const std::array<int, 3>& v,
    const float filled,
    std::vector<exposedFace>& free,
    std::vector<exposedFace>& atSides
)
{
    const std::size_t begin = free.size();
    float sum[3] = {0, 0, 0};
    float largest = 0, total = 0;

    // A film on what is below has the voxel's area; what falls is a drop
    const bool falling =
        v[2] > 0 && grid.phase(v[0], v[1], v[2] - 1) == EMPTY;
    const float across = falling ? std::cbrt(filled*filled) : 1;
    for (int side = 0; side < 6; ++side)
    {
        const std::array<int, 3> n = exposedFaces::normal(side);
        const int x = v[0] + n[0], y = v[1] + n[1], z = v[2] + n[2];
        const float area = side < 4 ? filled : across;
        exposedFace face{v[0], v[1], v[2], side, area, area};
        if (!grid.inside(x, y, z))
        {
            atSides.push_back(face);
        }
        else if (grid.phase(x, y, z) == EMPTY)
        {
            free.push_back(face);
            sum[side/2] += area*n[side/2];
            largest = std::max(largest, area);
            total += area;
        }
    }
    const float surface = std::max
    (
        largest,
        std::sqrt(sum[0]*sum[0] + sum[1]*sum[1] + sum[2]*sum[2])
    );
    for (std::size_t i = begin; i < free.size(); ++i)
    {
        free[i].smooth = free[i].area*surface/total;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::exposedFaces::build(voxelGrid& grid)
{
    const std::vector<int>& bricks = grid.list();
    const int n = int(bricks.size());
    std::vector<std::vector<exposedFace>> freeOf(n), atSidesOf(n);

    #pragma omp parallel for schedule(dynamic, 4)
    for (int bricki = 0; bricki < n; ++bricki)
    {
        const voxelBrick& b = grid.brick(bricks[bricki]);
        if (b.nLiquid + b.nSolid == 0)
        {
            continue;
        }
        const std::array<int, 3> o = grid.origin(bricks[bricki]);
        for (int i = 0; i < voxelBrick::size; ++i)
        {
            const int x = i >> 6, y = (i >> 3) & 7, z = i & 7;
            const auto filled = [&](const int step)
            {
                return b.phase[i + step] != EMPTY;
            };
            const bool within =
                x > 0 && x < 7 && y > 0 && y < 7 && z > 0 && z < 7
             && filled(-64) && filled(64) && filled(-8) && filled(8)
             && filled(-1) && filled(1);
            if (b.mass[i] > 0 && !within)
            {
                facesOfVoxel
                (
                    grid,
                    {o[0] + x, o[1] + y, o[2] + z},
                    float(b.mass[i])/voxelMaterial::full,
                    freeOf[bricki],
                    atSidesOf[bricki]
                );
            }
        }
    }

    free.clear();
    atSides.clear();
    for (int bricki = 0; bricki < n; ++bricki)
    {
        free.insert
        (
            free.end(), freeOf[bricki].begin(), freeOf[bricki].end()
        );
        atSides.insert
        (
            atSides.end(), atSidesOf[bricki].begin(), atSidesOf[bricki].end()
        );
    }
}

// ************************************************************************* //
