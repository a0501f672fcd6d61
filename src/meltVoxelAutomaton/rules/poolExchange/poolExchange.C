/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "poolExchange.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::melt;

//- Calls action(x, y, segment) for all segments in the columns of a slot whose
//  bits are set
template<class Action>
void forSegments
(
    openSegments::slot& s,
    std::uint64_t columns,
    const Action& action
)
{
    for (; columns; columns &= columns - 1)
    {
        const int column = __builtin_ctzll(columns);
        const int x = 8*s.bx + column/8, y = 8*s.by + column % 8;
        for (int i = s.start[column]; i < s.start[column + 1]; ++i)
        {
            action(x, y, s.segments[i]);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double Foam::melt::poolExchange::limit(std::vector<filmFlow>& flows)
{
    double largest = 0;
    for (filmFlow& f : flows)
    {
        openSegment& donor = *f.donor;
        openSegment* receiver = f.receiver;
        const std::int64_t wanted = f.mass;
        if (donor.wantedOut > donor.mass)
        {
            f.mass =
                voxelMaterial::share(wanted, donor.mass, donor.wantedOut);
        }
        if (receiver && receiver->wantedIn > receiver->room)
        {
            f.mass = std::min
            (
                f.mass,
                voxelMaterial::share
                (
                    wanted, receiver->room, receiver->wantedIn
                )
            );
        }
        #pragma omp atomic
        donor.out += f.mass;
        if (receiver && f.z < 0)
        {
            #pragma omp atomic
            receiver->in += f.mass;
        }
        largest = std::max(largest, double(f.mass)/donor.mass);
    }
    return largest;
}


void Foam::melt::poolExchange::take
(
    voxelGrid& grid,
    const int x,
    const int y,
    openSegment& s
)
{
    std::int64_t wanted = s.out;
    for (int z = s.top; wanted > 0; --z)
    {
        voxelBrick& b = grid.ownAt(x, y, z);
        const int i = voxelBrick::offset(x, y, z);
        const std::int64_t mass = std::min<std::int64_t>(wanted, b.mass[i]);
        const std::int64_t energy =
            mass == b.mass[i]
          ? b.energy[i]
          : voxelMaterial::share(b.energy[i], mass, b.mass[i]);
        b.mass[i] -= std::int32_t(mass);
        b.energy[i] -= energy;
        b.changed = true;
        s.outEnergy += energy;
        wanted -= mass;
        if (b.mass[i] == 0)
        {
            s.top = z - 1;
        }
    }
}


void Foam::melt::poolExchange::deliver(voxelGrid& grid, const filmFlow& f)
{
    const std::int64_t energy =
        voxelMaterial::share(f.donor->outEnergy, f.mass, f.donor->out);

    // What the shares leave over stays with the donor
    #pragma omp atomic
    f.donor->inEnergy -= energy;

    if (!f.receiver)
    {
        #pragma omp atomic
        lostMass_ += f.mass;
        #pragma omp atomic
        lostEnergy_ += energy;
    }
    else if (f.z < 0)
    {
        #pragma omp atomic
        f.receiver->inEnergy += energy;
    }
    else
    {
        voxelBrick& b = grid.ownAt(f.x, f.y, f.z);
        const int i = voxelBrick::offset(f.x, f.y, f.z);
        #pragma omp atomic
        b.mass[i] += std::int32_t(f.mass);
        #pragma omp atomic
        b.energy[i] += energy;
        b.changed = true;
    }
}


void Foam::melt::poolExchange::put
(
    voxelGrid& grid,
    const int x,
    const int y,
    openSegment& s
)
{
    // The excess of a voxel goes to the one above, and below the ceiling down
    std::int64_t mass = s.in;
    std::int64_t energy = s.inEnergy + s.outEnergy;
    const int start = std::max(s.top, s.z0);
    int z = start;
    int step = 1;
    while (mass > 0)
    {
        if (z > s.z1)
        {
            z = start - 1;
            step = -1;
        }
        voxelBrick& b = grid.ownAt(x, y, z);
        const int i = voxelBrick::offset(x, y, z);
        const std::int64_t moved =
            std::min<std::int64_t>(mass, b.capacity(i) - b.mass[i]);
        if (moved > 0)
        {
            const std::int64_t share =
                moved == mass
              ? energy : voxelMaterial::share(energy, moved, mass);
            b.mass[i] += std::int32_t(moved);
            b.energy[i] += share;
            b.changed = true;
            mass -= moved;
            energy -= share;
        }
        z += step;
    }
    if (energy)
    {
        voxelBrick& b = grid.ownAt(x, y, start);
        b.energy[voxelBrick::offset(x, y, start)] += energy;
        b.changed = true;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::melt::poolExchange::exchange
(
    voxelGrid& grid,
    openSegments& segments,
    std::vector<std::vector<filmFlow>>& flows
)
{
    std::vector<openSegments::slot>& slots = segments.slots();
    const int n = int(slots.size());
    double largest = 0;

    #pragma omp parallel for schedule(dynamic, 4) reduction(max:largest)
    for (int i = 0; i < n; ++i)
    {
        largest = std::max(largest, limit(flows[i]));
    }

    #pragma omp parallel for schedule(dynamic, 4)
    for (int i = 0; i < n; ++i)
    {
        forSegments
        (
            slots[i],
            slots[i].wet,
            [&](const int x, const int y, openSegment& s)
            {
                if (s.out > 0)
                {
                    take(grid, x, y, s);
                }
            }
        );
    }

    #pragma omp parallel for schedule(dynamic, 4)
    for (int i = 0; i < n; ++i)
    {
        for (const filmFlow& f : flows[i])
        {
            if (f.mass > 0)
            {
                deliver(grid, f);
            }
        }
    }

    // Enthalpy that the shares have left over stays where the melt was wet
    #pragma omp parallel for schedule(dynamic, 4)
    for (int i = 0; i < n; ++i)
    {
        forSegments
        (
            slots[i],
            slots[i].wet | slots[i].receives,
            [&](const int x, const int y, openSegment& s)
            {
                if (s.in > 0 || s.inEnergy + s.outEnergy)
                {
                    put(grid, x, y, s);
                }
            }
        );
    }
    return largest;
}

// ************************************************************************* //
