/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "looseSolids.H"

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


template<class Action>
void Foam::melt::looseSolids::forRuns
(
    const voxelGrid& grid,
    const int x,
    const int y,
    const int z0,
    const int z1,
    const Action& action
) const
{
    if (!grid.inside(x, y, z0))
    {
        return;
    }
    const std::vector<int>& first =
        first_[grid.brickIndex(x >> 3, y >> 3, z0 >> 3)];
    if (first.empty())
    {
        return;
    }
    const int column = (x & 7)*8 + (y & 7);
    for (int i = first[column]; i < first[column + 1]; ++i)
    {
        if (runs_[i].z0 <= z1 && runs_[i].z1 >= z0)
        {
            action(i);
        }
    }
}


int Foam::melt::looseSolids::runAt
(
    const voxelGrid& grid,
    const int x,
    const int y,
    const int z
) const
{
    int result = -1;
    forRuns(grid, x, y, z, z, [&](const int i) { result = i; });
    return result;
}


void Foam::melt::looseSolids::listRuns(voxelGrid& grid)
{
    runs_.clear();
    first_.resize
    (
        std::size_t(grid.nBricks()[0])*grid.nBricks()[1]*grid.nBricks()[2]
    );
    for (std::vector<int>& first : first_)
    {
        first.clear();
    }
    for (const int index : grid.list())
    {
        const voxelBrick& b = grid.brick(index);
        if (b.nSolid == 0)
        {
            continue;
        }
        const std::array<int, 3> o = grid.origin(index);
        std::vector<int>& first = first_[index];
        first.resize(65);
        for (int column = 0; column < 64; ++column)
        {
            first[column] = int(runs_.size());
            const std::uint8_t* phase = b.phase + 8*column;
            for (int k = 0; k < 8; ++k)
            {
                if (phase[k] != SOLID)
                {
                    continue;
                }
                const int z = o[2] + k;
                if (k > 0 && phase[k - 1] == SOLID)
                {
                    runs_.back().z1 = z;
                }
                else
                {
                    runs_.push_back
                    (
                        {o[0] + column/8, o[1] + column % 8, z, z}
                    );
                }
            }
        }
        first[64] = int(runs_.size());
    }
}


void Foam::melt::looseSolids::connect(voxelGrid& grid)
{
    listRuns(grid);
    root_.resize(runs_.size());
    for (std::size_t i = 0; i < root_.size(); ++i)
    {
        root_[i] = int(i);
    }

    // Half of the 26 neighbours of each voxel: the other half finds it
    constexpr int beside[4][2] = {{1, -1}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < int(runs_.size()); ++i)
    {
        const run& r = runs_[i];
        const int floor = r.z0 & ~7, ceiling = r.z1 | 7;
        const auto joinTo = [&](const int j) { join(i, j); };
        for (const int (&step)[2] : beside)
        {
            const int x = r.x + step[0], y = r.y + step[1];
            forRuns
            (
                grid, x, y,
                std::max(r.z0 - 1, floor), std::min(r.z1 + 1, ceiling),
                joinTo
            );
            if (r.z0 == floor)
            {
                forRuns(grid, x, y, floor - 1, floor - 1, joinTo);
            }
            if (r.z1 == ceiling)
            {
                forRuns(grid, x, y, ceiling + 1, ceiling + 1, joinTo);
            }
        }
        if (r.z1 == ceiling)
        {
            forRuns(grid, r.x, r.y, ceiling + 1, ceiling + 1, joinTo);
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
        const run& r = runs_[i];
        if (r.z0 == 0)
        {
            return true;
        }
        // Rock below, or in part of its voxels
        for (int z = r.z0 - 1; z <= r.z1; ++z)
        {
            const voxelBrick& b = grid.brickAt(r.x, r.y, z);
            const int voxel = voxelBrick::offset(r.x, r.y, z);
            if (b.phase[voxel] == ROCK || b.rock[voxel] > 0)
            {
                return true;
            }
        }
    }
    for (const int i : piece)
    {
        const run& r = runs_[i];
        for (int side = 0; side < 4; ++side)
        {
            const int x = r.x + (side == 0) - (side == 1);
            const int y = r.y + (side == 2) - (side == 3);
            for (int z = r.z0; z <= r.z1; ++z)
            {
                if (grid.inside(x, y, z) && grid.phase(x, y, z) == ROCK)
                {
                    return true;
                }
            }
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
    double below = 0, filled = 0;
    for (const int i : piece)
    {
        const run& r = runs_[i];

        // Solid below is of the same piece
        if (runAt(grid, r.x, r.y, r.z0 - 1) < 0)
        {
            below += 1;
            filled +=
                double(grid.mass(r.x, r.y, r.z0 - 1))/voxelMaterial::full;
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
        const run& r = runs_[i];
        for (int z = r.z0; z <= r.z1; ++z)
        {
            voxelBrick& upper = grid.ownAt(r.x, r.y, z);
            voxelBrick& lower = grid.ownAt(r.x, r.y, z - 1);
            const int a = voxelBrick::offset(r.x, r.y, z);
            const int b = voxelBrick::offset(r.x, r.y, z - 1);
            std::swap(upper.mass[a], lower.mass[b]);
            std::swap(upper.energy[a], lower.energy[b]);
            upper.changed = true;
            lower.changed = true;
        }
    }
}


std::vector<std::vector<int>> Foam::melt::looseSolids::pieces()
{
    // Bricks are in ascending order, the higher after the lower
    std::vector<std::vector<int>> result;
    std::vector<int> order(runs_.size(), -1);
    for (int i = 0; i < int(runs_.size()); ++i)
    {
        int& place = order[find(i)];
        if (place < 0)
        {
            place = int(result.size());
            result.emplace_back();
        }
        result[place].push_back(i);
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
        const run& r = runs_[piece[0]];
        falling f{r.x, r.y, r.z0, 0, 0};
        for (const falling& known : before)
        {
            const int i = runAt(grid, known.x, known.y, known.z);
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
    const int found = runAt(grid, f.x, f.y, f.z);
    if (found < 0)
    {
        return false;
    }
    const int root = find(found);
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
