/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSegments.H"

#include <algorithm>
#include <cstring>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::openSegments::measure
(
    const voxelGrid& grid,
    const int x,
    const int y,
    openSegment& s
)
{
    constexpr std::int64_t full = voxelMaterial::full;
    const bool bottomless = s.z0 == 0 && grid.open(4);

    std::int64_t energy = 0;
    s.mass = 0;
    s.top = s.z0 - 1;
    s.room = 0;
    s.base = s.z0;
    bool pool = !bottomless;

    s.base += grid.brickAt(x, y, s.z0).rock[voxelBrick::offset(x, y, s.z0)]/256.0;

    // By bricks; no voxel of a segment is rock or solid throughout
    for (int begin = s.z0; begin <= s.z1; begin = (begin | 7) + 1)
    {
        const int end = std::min(begin | 7, s.z1) + 1;
        const int index = grid.brickIndex(x >> 3, y >> 3, begin >> 3);
        if (!grid.allocated(index))
        {
            s.room += (end - begin)*full;
            pool = false;
            continue;
        }
        const voxelBrick& b = grid.brick(index);
        const int first = voxelBrick::offset(x, y, begin);
        std::int64_t mass = 0, rock = 0;
        for (int i = first; i < first + end - begin; ++i)
        {
            mass += b.mass[i];
            rock += b.rock[i];
        }
        s.room += (end - begin)*full - mass - rock*(full/256);

        for (int z = begin; pool && z < end; ++z)
        {
            const int i = voxelBrick::offset(x, y, z);
            pool = b.phase[i] == LIQUID;
            if (pool)
            {
                s.top = z;
                s.mass += b.mass[i];
                energy += b.energy[i];
            }
        }
    }

    s.height = double(s.mass)/full;
    s.T = 0;
    if (s.mass > 0)
    {
        const voxelMaterial& material = grid.material();
        s.T = material.curve.T
        (
            energy*material.energyUnit/(s.mass*material.massUnit)
        );
    }
    s.in = s.inEnergy = s.out = s.outEnergy = 0;
}


void Foam::melt::openSegments::cutColumn
(
    const voxelGrid& grid,
    const int x,
    const int y,
    std::vector<openSegment>& segments
)
{
    constexpr std::uint64_t highBits = 0x0202020202020202;
    const int n = grid.n()[2];
    int begin = -1;

    const auto close = [&](const int end)
    {
        if (begin >= 0)
        {
            openSegment s;
            s.z0 = begin;
            s.z1 = end - 1;
            measure(grid, x, y, s);
            segments.push_back(s);
            begin = -1;
        }
    };

    for (int z0 = 0; z0 < n; z0 += 8)
    {
        const voxelBrick& b = grid.brickAt(x, y, z0);
        const std::uint8_t* phase = b.phase + voxelBrick::offset(x, y, z0);

        // SOLID and ROCK have the second bit
        std::uint64_t closed;
        std::memcpy(&closed, phase, sizeof(closed));
        closed &= highBits;

        if (closed == 0)
        {
            begin = begin < 0 ? z0 : begin;
        }
        else if (closed == highBits)
        {
            close(z0);
        }
        else
        {
            for (int i = 0; i < 8 && z0 + i < n; ++i)
            {
                if (phase[i] & 2)
                {
                    close(z0 + i);
                }
                else if (begin < 0)
                {
                    begin = z0 + i;
                }
            }
        }
    }
    close(n);
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
        slot& s = slots_[i];
        s.segments.clear();
        for (int column = 0; column < 64; ++column)
        {
            const int x = 8*s.bx + column/8, y = 8*s.by + column % 8;
            s.start[column] = int(s.segments.size());
            if (x < grid.n()[0] && y < grid.n()[1])
            {
                cutColumn(grid, x, y, s.segments);
            }
        }
        s.start[64] = int(s.segments.size());
    }
}

// ************************************************************************* //
