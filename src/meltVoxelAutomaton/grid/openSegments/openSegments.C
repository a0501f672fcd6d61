/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSegments.H"
#include "columnCutter.H"

#include <algorithm>
#include <cstring>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::openSegments::cut(const voxelGrid& grid, slot& s)
{
    const std::array<int, 3>& n = grid.n();
    s.segments.clear();
    s.wet = 0;
    s.receives = 0;

    // The layers of bricks in which there is something
    std::vector<std::pair<int, const voxelBrick*>> layers;
    for (int bz = 0; bz < grid.nBricks()[2]; ++bz)
    {
        const int index = grid.brickIndex(s.bx, s.by, bz);
        if (!grid.isVoid(index))
        {
            layers.emplace_back(8*bz, &grid.brick(index));
        }
    }

    for (int column = 0; column < 64; ++column)
    {
        s.start[column] = int(s.segments.size());
        if (8*s.bx + column/8 >= n[0] || 8*s.by + column % 8 >= n[1])
        {
            continue;
        }
        columnCutter cutter(grid, s.segments);
        int z = 0;
        for (const auto& layer : layers)
        {
            const int z0 = layer.first;
            const voxelBrick& b = *layer.second;
            if (z < z0)
            {
                cutter.empty(z, z0);
            }
            z = std::min(z0 + 8, n[2]);

            // SOLID and ROCK have the second bit
            constexpr std::uint64_t allClosed = 0x0202020202020202;
            const int i = 8*column;
            std::uint64_t closed;
            std::memcpy(&closed, b.phase + i, sizeof(closed));
            closed &= allClosed;
            if (closed == allClosed)
            {
                cutter.close(z0);
            }
            else if (closed == 0 && z == z0 + 8)
            {
                cutter.column(b, i, z0);
            }
            else
            {
                for (int k = 0; k < z - z0; ++k)
                {
                    if (b.phase[i + k] & 2)
                    {
                        cutter.close(z0 + k);
                    }
                    else
                    {
                        cutter.voxels(b, i + k, z0 + k, 1);
                    }
                }
            }
        }
        if (z < n[2])
        {
            cutter.empty(z, n[2]);
        }
        cutter.close(n[2]);
        s.wet |= std::uint64_t(cutter.wet) << column;
    }
    s.start[64] = int(s.segments.size());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::openSegments::build(voxelGrid& grid)
{
    const std::array<int, 3>& nb = grid.nBricks();
    slotOf_.assign(std::size_t(nb[0])*nb[1], -1);

    const auto mark = [&](const int bx, const int by)
    {
        if (bx >= 0 && bx < nb[0] && by >= 0 && by < nb[1])
        {
            slotOf_[bx + nb[0]*by] = 0;
        }
    };
    for (const int index : grid.list())
    {
        if (grid.brick(index).nLiquid)
        {
            const std::array<int, 3> o = grid.origin(index);
            const int bx = o[0]/8, by = o[1]/8;
            mark(bx, by);
            mark(bx - 1, by);
            mark(bx + 1, by);
            mark(bx, by - 1);
            mark(bx, by + 1);
        }
    }

    int n = 0;
    for (int& s : slotOf_)
    {
        s = s < 0 ? -1 : n++;
    }
    slots_.resize(n);
    for (std::size_t i = 0; i < slotOf_.size(); ++i)
    {
        if (slotOf_[i] >= 0)
        {
            slots_[slotOf_[i]].bx = int(i) % nb[0];
            slots_[slotOf_[i]].by = int(i)/nb[0];
        }
    }

    #pragma omp parallel for schedule(dynamic, 4)
    for (int i = 0; i < n; ++i)
    {
        cut(grid, slots_[i]);
    }
}

// ************************************************************************* //
