/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "looseSolids.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::looseSolids::held
(
    const voxelGrid& grid,
    const std::vector<int>& piece
) const
{
    for (const int i : piece)
    {
        const solidPieces::run& r = solids_[i];
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
        const solidPieces::run& r = solids_[i];
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
        const solidPieces::run& r = solids_[i];

        // Solid below is of the same piece
        if (solids_.runAt(grid, r.x, r.y, r.z0 - 1) < 0)
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
        const solidPieces::run& r = solids_[i];
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


void Foam::melt::looseSolids::findLoose(const voxelGrid& grid)
{
    const std::vector<falling> before(std::move(falling_));
    falling_.clear();
    loose_ = false;
    for (const std::vector<int>& piece : solids_.pieces())
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
        const solidPieces::run& r = solids_[piece[0]];
        falling f{r.x, r.y, r.z0, 0, 0};
        for (const falling& known : before)
        {
            const int i = solids_.runAt(grid, known.x, known.y, known.z);
            if (i >= 0 && solids_.root(i) == solids_.root(piece[0]))
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
    const int found = solids_.runAt(grid, f.x, f.y, f.z);
    if (found < 0)
    {
        return false;
    }
    const int root = solids_.root(found);
    for (const std::vector<int>& piece : solids_.pieces())
    {
        if (solids_.root(piece[0]) == root && canFall(grid, piece))
        {
            moveDown(grid, piece);
            f.way -= grid.dx();
            --f.z;
            grid.refresh();
            solids_.connect(grid);
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
        solids_.connect(grid);
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
                solids_.connect(grid);
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
