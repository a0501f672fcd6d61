/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exposedFaces.H"
#include "surfaceEdge.H"
#include "wettedShare.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::melt;

//- Share of a voxel that melt and rock take; own where there is only rock, or
//  a wall
float filledAt
(
    const voxelGrid& grid,
    const int x,
    const int y,
    const int z,
    const float own
)
{
    if (!grid.inside(x, y, z))
    {
        return grid.outsidePhase(x, y, z) == EMPTY ? 0 : own;
    }
    const voxelBrick& b = grid.brickAt(x, y, z);
    const int i = voxelBrick::offset(x, y, z);
    return
        b.phase[i] == ROCK
      ? own : float(b.mass[i])/voxelMaterial::full + b.rock[i]/256.0f;
}


//- Area of a free face: where the voxels behind it hold more, as at a slope
//  that cuts several voxels, it stands for them too
float areaOfFace
(
    const voxelGrid& grid,
    const std::array<int, 3>& v,
    const std::array<int, 3>& normal,
    const float own
)
{
    float area = own;
    for (int step = 1; area < 1; ++step)
    {
        const int x = v[0] - step*normal[0];
        const int y = v[1] - step*normal[1];
        const int z = v[2] - step*normal[2];
        if (!grid.inside(x, y, z))
        {
            break;
        }
        const float behind = float(grid.mass(x, y, z))/voxelMaterial::full;
        if (behind <= area)
        {
            break;
        }
        area = behind;
    }
    return area;
}


//- Filled shares of a voxel's 27 neighbours and itself, and the normal of the
//  surface there
struct neighbourhood
{
    float share[3][3][3];

    //- -grad(filled) by differences
    float n[3] = {0, 0, 0};

    neighbourhood
    (
        const voxelGrid& grid,
        const std::array<int, 3>& v,
        const float own
    )
    {
        // As in a mirror where there is rock, or a wall
        int step[3][3];
        for (int k = 0; k < 3; ++k)
        {
            for (const int d : {-1, 0, 1})
            {
                std::array<int, 3> b(v);
                b[k] += d;
                step[k][d + 1] = grid.phase(b[0], b[1], b[2]) == ROCK ? 0 : d;
            }
        }

        constexpr float weight[3] = {1, 2, 1};
        for (int x = 0; x < 3; ++x)
        {
            for (int y = 0; y < 3; ++y)
            {
                for (int z = 0; z < 3; ++z)
                {
                    const float f = filledAt
                    (
                        grid,
                        v[0] + step[0][x],
                        v[1] + step[1][y],
                        v[2] + step[2][z],
                        own
                    );
                    share[x][y][z] = f;
                    n[0] += (1 - x)*weight[y]*weight[z]*f;
                    n[1] += (1 - y)*weight[z]*weight[x]*f;
                    n[2] += (1 - z)*weight[x]*weight[y]*f;
                }
            }
        }
    }

    //- Share of the neighbour a step along an axis and one along another away
    float at(const int axis, const int step, const int other, const int across)
    const
    {
        int c[3] = {1, 1, 1};
        c[axis] += step;
        c[other] += across;
        return share[c[0]][c[1]][c[2]];
    }

    //- How much of a true edge is beside a face normal to an axis, on the side
    //  of another axis that the surface goes down to
    float edge
    (
        const voxelGrid& grid,
        const std::array<int, 3>& v,
        const std::array<int, 3>& normal,
        const int axis,
        const int other
    ) const
    {
        // Rounding of the shares beside each other on a flat side
        constexpr float same = 0.99f;
        const int down = n[other] > 0 ? 1 : -1;
        const float own = share[1][1][1], beside = at(axis, 0, other, down);

        // The line of voxels beside is partly filled all the way: the edge is
        // in them
        std::array<int, 3> b(v);
        b[other] += down;
        if
        (
            beside > 0
         && areaOfFace(grid, b, normal, beside)
          < same*areaOfFace(grid, v, normal, own)
        )
        {
            return 1;
        }
        return edgeSharpness
        (
            own,
            at(axis, normal[axis], other, -down),
            std::max(at(axis, -normal[axis], other, down), beside)
        );
    }

    //- |n| / (|nx| + |ny| + |nz|) of the surface at a face; a face at a true
    //  edge does not see the slope beyond it
    float slant(const voxelGrid& grid, const exposedFace& face) const
    {
        const std::array<int, 3> v{face.x, face.y, face.z};
        const std::array<int, 3> normal = exposedFaces::normal(face.side);
        const int axis = face.side/2;
        float sum = 0, square = 0;
        for (int other = 0; other < 3; ++other)
        {
            float component = std::abs(n[other]);
            if (other != axis && component > 0)
            {
                component *= 1 - edge(grid, v, normal, axis, other);
            }
            sum += component;
            square += component*component;
        }

        // A sheet of one voxel has no normal, and both its sides count
        return sum > 0.1f ? std::sqrt(square)/sum : 1;
    }
};


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

    // A film has the area of what it covers below; what falls is a drop; a
    // column of voxels that are all partly filled is the side of a solid
    const bool falling =
        v[2] > 0 && grid.phase(v[0], v[1], v[2] - 1) == EMPTY;
    const bool film = filledAt(grid, v[0], v[1], v[2] - 1, 1) >= 1;
    const float across =
        falling ? std::cbrt(filled*filled)
      : film ? wettedShare(grid, v[0], v[1], v[2])
      : filled;
    for (int side = 0; side < 6; ++side)
    {
        const std::array<int, 3> n = exposedFaces::normal(side);
        const int x = v[0] + n[0], y = v[1] + n[1], z = v[2] + n[2];
        const float own = side < 4 ? filled : across;
        if (!grid.inside(x, y, z))
        {
            atSides.push_back({v[0], v[1], v[2], side, own, own});
        }
        else if (grid.phase(x, y, z) == EMPTY)
        {
            const float area = areaOfFace(grid, v, n, own);
            free.push_back({v[0], v[1], v[2], side, area, area});
        }
    }
    if (free.size() > begin)
    {
        const neighbourhood around
        (
            grid, v, filledAt(grid, v[0], v[1], v[2], 0)
        );
        for (std::size_t i = begin; i < free.size(); ++i)
        {
            free[i].smooth *= around.slant(grid, free[i]);
        }
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
