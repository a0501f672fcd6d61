/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "densityField.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::melt;

// Mass that fits into a voxel and into 1/256 of it
constexpr float wholeRoom = voxelMaterial::full;
constexpr float rockUnit = wholeRoom/256;

// A brick and one layer around it, and the steps between voxels in it
constexpr int side = 10;
constexpr int size = side*side*side;
constexpr int step[3] = {side*side, side, 1};

//- Calls action(brick, brick x, y, z, of -1 to 1) for a brick and those
//  around it that are in the grid
template<class Action>
void forBricksAround
(
    const voxelGrid& grid,
    const int index,
    const Action& action
)
{
    const std::array<int, 3> o = grid.origin(index);
    const std::array<int, 3>& nb = grid.nBricks();
    for (int n = 0; n < 27; ++n)
    {
        const int dx = n/9 - 1, dy = n/3 % 3 - 1, dz = n % 3 - 1;
        const int bx = o[0]/8 + dx, by = o[1]/8 + dy, bz = o[2]/8 + dz;
        if
        (
            bx >= 0 && bx < nb[0] && by >= 0 && by < nb[1]
         && bz >= 0 && bz < nb[2]
        )
        {
            action(grid.brickIndex(bx, by, bz), dx, dy, dz);
        }
    }
}


//- Filter along an axis; of the outermost layers nothing is needed
void smooth(float* field, const int s)
{
    float result[size];
    #pragma omp simd
    for (int i = s; i < size - s; ++i)
    {
        result[i] = 0.25f*(field[i - s] + field[i + s]) + 0.5f*field[i];
    }
    std::copy(result + s, result + size - s, field + s);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::unique_ptr<Foam::melt::densityField::values>
Foam::melt::densityField::filter(const voxelGrid& grid, const int index)
{
    bool melt = false;
    forBricksAround
    (
        grid,
        index,
        [&](const int other, int, int, int)
        {
            const voxelBrick& b = grid.brick(other);
            melt = melt || b.nLiquid || b.nSolid;
        }
    );
    if (!melt)
    {
        return nullptr;
    }

    float mass[size] = {}, room[size] = {};
    const std::array<int, 3>& n = grid.n();
    forBricksAround
    (
        grid,
        index,
        [&](const int other, const int dx, const int dy, const int dz)
        {
            const voxelBrick& b = grid.brick(other);
            const std::array<int, 3> o = grid.origin(other);
            const auto begin = [](const int d) { return d < 0 ? 7 : 0; };
            const auto end = [&](const int d, const int axis)
            {
                return std::min(d > 0 ? 1 : 8, n[axis] - o[axis]);
            };
            for (int x = begin(dx); x < end(dx, 0); ++x)
            {
                for (int y = begin(dy); y < end(dy, 1); ++y)
                {
                    const int row =
                        (x + 8*dx + 1)*step[0] + (y + 8*dy + 1)*step[1]
                      + 8*dz + 1;
                    const int column = voxelBrick::offset(x, y, 0);
                    const int last = end(dz, 2);
                    #pragma omp simd
                    for (int z = begin(dz); z < last; ++z)
                    {
                        mass[row + z] = b.mass[column + z];
                        room[row + z] =
                            b.phase[column + z] == ROCK
                          ? 0 : wholeRoom - b.rock[column + z]*rockUnit;
                    }
                }
            }
        }
    );
    for (const int s : step)
    {
        smooth(mass, s);
        smooth(room, s);
    }

    auto result = std::make_unique<values>();
    float sum = 0;
    for (int column = 0; column < 64; ++column)
    {
        const int j = (column/8 + 1)*step[0] + (column % 8 + 1)*step[1] + 1;
        float* const values = result->data() + 8*column;
        #pragma omp simd reduction(+:sum)
        for (int k = 0; k < 8; ++k)
        {
            values[k] = room[j + k] > 0 ? mass[j + k]/room[j + k] : 0;
            sum += mass[j + k];
        }
    }
    return sum > 0 ? std::move(result) : nullptr;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::melt::densityField::update(voxelGrid& grid)
{
    const int nBricks =
        grid.nBricks()[0]*grid.nBricks()[1]*grid.nBricks()[2];
    brick_.resize(nBricks);

    std::vector<char> visit(nBricks, 0);
    for (int index = 0; index < nBricks; ++index)
    {
        const bool freed = brick_[index] && !grid.allocated(index);
        if (freed || grid.brick(index).unfiltered)
        {
            forBricksAround
            (
                grid,
                index,
                [&](const int other, int, int, int) { visit[other] = 1; }
            );
        }
    }

    int n = 0;
    #pragma omp parallel for schedule(dynamic, 4) reduction(+:n)
    for (int index = 0; index < nBricks; ++index)
    {
        if (visit[index])
        {
            brick_[index] = filter(grid, index);
            ++n;
        }
    }
    for (const int index : grid.list())
    {
        grid.own(index).unfiltered = false;
    }
    return n;
}

// ************************************************************************* //
