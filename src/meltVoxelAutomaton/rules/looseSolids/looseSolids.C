/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "looseSolids.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int Foam::melt::looseSolids::find(int i)
{
    while (root_[i] != i)
    {
        root_[i] = root_[root_[i]];
        i = root_[i];
    }
    return i;
}


int Foam::melt::looseSolids::numberAt
(
    const voxelGrid& grid,
    const int x,
    const int y,
    const int z
) const
{
    if (!grid.inside(x, y, z))
    {
        return -1;
    }
    const std::vector<int>& numbers =
        number_[grid.brickIndex(x >> 3, y >> 3, z >> 3)];
    return numbers.empty() ? -1 : numbers[voxelBrick::offset(x, y, z)];
}


void Foam::melt::looseSolids::connect(voxelGrid& grid)
{
    voxels_.clear();
    number_.resize
    (
        std::size_t(grid.nBricks()[0])*grid.nBricks()[1]*grid.nBricks()[2]
    );
    for (std::vector<int>& numbers : number_)
    {
        numbers.clear();
    }
    for (const int index : grid.list())
    {
        const voxelBrick& b = grid.brick(index);
        if (b.nSolid == 0)
        {
            continue;
        }
        const std::array<int, 3> o = grid.origin(index);
        number_[index].assign(voxelBrick::size, -1);
        for (int i = 0; i < voxelBrick::size; ++i)
        {
            if (b.phase[i] == SOLID)
            {
                number_[index][i] = int(voxels_.size());
                voxels_.push_back
                (
                    {o[0] + (i >> 6), o[1] + ((i >> 3) & 7), o[2] + (i & 7)}
                );
            }
        }
    }

    root_.resize(voxels_.size());
    for (std::size_t i = 0; i < root_.size(); ++i)
    {
        root_[i] = int(i);
    }
    for (std::size_t i = 0; i < voxels_.size(); ++i)
    {
        const std::array<int, 3>& v = voxels_[i];
        for (int n = 14; n < 27; ++n)
        {
            const int j = numberAt
            (
                grid, v[0] + n/9 - 1, v[1] + n/3 % 3 - 1, v[2] + n % 3 - 1
            );
            if (j >= 0)
            {
                const int a = find(int(i)), b = find(j);
                root_[std::max(a, b)] = std::min(a, b);
            }
        }
    }
}


bool Foam::melt::looseSolids::held
(
    const voxelGrid& grid,
    const std::vector<int>& piece
) const
{
    for (const int i : piece)
    {
        const std::array<int, 3>& v = voxels_[i];
        for (int side = 0; side < 4; ++side)
        {
            const int x = v[0] + (side == 0) - (side == 1);
            const int y = v[1] + (side == 2) - (side == 3);
            if (grid.inside(x, y, v[2]) && grid.phase(x, y, v[2]) == ROCK)
            {
                return true;
            }
        }
        if (v[2] == 0)
        {
            return true;
        }
        const voxelBrick& b = grid.brickAt(v[0], v[1], v[2] - 1);
        const int below = voxelBrick::offset(v[0], v[1], v[2] - 1);
        if (b.phase[below] == ROCK || b.rock[below] > 0)
        {
            return true;
        }
    }
    return false;
}


bool Foam::melt::looseSolids::canFall
(
    const voxelGrid& grid,
    const std::vector<int>& piece
)
{
    if (held(grid, piece))
    {
        return false;
    }
    const int root = find(piece[0]);
    double below = 0, filled = 0;
    for (const int i : piece)
    {
        const std::array<int, 3>& v = voxels_[i];
        const int j = numberAt(grid, v[0], v[1], v[2] - 1);
        if (j < 0 || find(j) != root)
        {
            below += 1;
            filled +=
                double(grid.mass(v[0], v[1], v[2] - 1))/voxelMaterial::full;
        }
    }
    return filled < 0.5*below;
}


void Foam::melt::looseSolids::moveDown
(
    voxelGrid& grid,
    const std::vector<int>& piece
) const
{
    // From the bottom up each solid voxel changes places with the one below,
    // which takes melt in the way up through the piece
    for (const int i : piece)
    {
        const std::array<int, 3>& v = voxels_[i];
        voxelBrick& upper = grid.ownAt(v[0], v[1], v[2]);
        voxelBrick& lower = grid.ownAt(v[0], v[1], v[2] - 1);
        const int a = voxelBrick::offset(v[0], v[1], v[2]);
        const int b = voxelBrick::offset(v[0], v[1], v[2] - 1);
        std::swap(upper.mass[a], lower.mass[b]);
        std::swap(upper.energy[a], lower.energy[b]);
        upper.changed = true;
        lower.changed = true;
    }
}


std::vector<std::vector<int>> Foam::melt::looseSolids::pieces()
{
    std::vector<std::vector<int>> result;
    std::vector<int> order(voxels_.size(), -1);
    for (std::size_t i = 0; i < voxels_.size(); ++i)
    {
        int& place = order[find(int(i))];
        if (place < 0)
        {
            place = int(result.size());
            result.emplace_back();
        }
        result[place].push_back(int(i));
    }
    for (std::vector<int>& piece : result)
    {
        std::stable_sort
        (
            piece.begin(),
            piece.end(),
            [&](const int a, const int b)
            {
                return voxels_[a][2] < voxels_[b][2];
            }
        );
    }
    return result;
}


void Foam::melt::looseSolids::findLoose(const voxelGrid& grid)
{
    const std::vector<falling> before(std::move(falling_));
    falling_.clear();
    loose_ = false;
    for (const std::vector<int>& piece : pieces())
    {
        if (held(grid, piece))
        {
            continue;
        }
        loose_ = true;
        if (!canFall(grid, piece))
        {
            continue;
        }
        const std::array<int, 3>& v = voxels_[piece[0]];
        falling f{v[0], v[1], v[2], 0, 0};
        for (const falling& known : before)
        {
            const int i = numberAt(grid, known.x, known.y, known.z);
            if (i >= 0 && find(i) == find(piece[0]))
            {
                f.speed = std::max(f.speed, known.speed);
                f.way = std::max(f.way, known.way);
            }
        }
        falling_.push_back(f);
    }
}


bool Foam::melt::looseSolids::fallOneVoxel(voxelGrid& grid, falling& f)
{
    const int number = numberAt(grid, f.x, f.y, f.z);
    if (number < 0)
    {
        return false;
    }
    const int root = find(number);
    for (const std::vector<int>& piece : pieces())
    {
        if (find(piece[0]) == root && canFall(grid, piece))
        {
            moveDown(grid, piece);
            f.way -= grid.dx();
            --f.z;
            grid.refresh();
            connect(grid);
            return true;
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::looseSolids::fall(voxelGrid& grid, const double dt)
{
    if (g_ <= 0)
    {
        return;
    }
    loose_ = grid.takeSolidsChanged() || loose_;
    waiting_ += dt;
    bool connected = false;
    if (loose_ && waiting_ >= 0.5*std::sqrt(2*grid.dx()/g_))
    {
        connect(grid);
        findLoose(grid);
        waiting_ = 0;
        connected = true;
    }

    for (std::size_t i = 0; i < falling_.size();)
    {
        falling& f = falling_[i];
        f.way += (f.speed + 0.5*g_*dt)*dt;
        f.speed += g_*dt;
        bool free = true;
        while (free && f.way >= grid.dx())
        {
            if (!connected)
            {
                connect(grid);
                connected = true;
            }
            free = fallOneVoxel(grid, f);
        }
        if (free)
        {
            ++i;
        }
        else
        {
            falling_.erase(falling_.begin() + i);
        }
    }
}

// ************************************************************************* //
