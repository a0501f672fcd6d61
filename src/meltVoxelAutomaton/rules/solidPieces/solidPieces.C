/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidPieces.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Action>
void Foam::melt::solidPieces::forRuns
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


void Foam::melt::solidPieces::listRuns(voxelGrid& grid)
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::melt::solidPieces::root(int i)
{
    while (root_[i] != i)
    {
        root_[i] = root_[root_[i]];
        i = root_[i];
    }
    return i;
}


int Foam::melt::solidPieces::runAt
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


void Foam::melt::solidPieces::connect(voxelGrid& grid)
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


std::vector<std::vector<int>> Foam::melt::solidPieces::pieces()
{
    // Bricks are in ascending order, the higher after the lower
    std::vector<std::vector<int>> result;
    std::vector<int> order(runs_.size(), -1);
    for (int i = 0; i < int(runs_.size()); ++i)
    {
        int& place = order[root(i)];
        if (place < 0)
        {
            place = int(result.size());
            result.emplace_back();
        }
        result[place].push_back(i);
    }
    return result;
}

// ************************************************************************* //
