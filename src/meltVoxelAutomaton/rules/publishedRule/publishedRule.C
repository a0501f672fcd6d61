/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "publishedRule.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::melt;

constexpr double unity = 1 << 28;

//- What moves from one voxel to a neighbour
struct gift
{
    std::array<int, 3> from, to;

    std::int64_t mass;
};


//- Liquid voxels x y z in the order of bricks, each from the bottom up
std::vector<std::array<int, 3>> liquidVoxels(voxelGrid& grid)
{
    std::vector<std::array<int, 3>> result;
    for (const int index : grid.list())
    {
        const voxelBrick& b = grid.brick(index);
        const std::array<int, 3> o = grid.origin(index);
        for (int i = 0; b.nLiquid && i < voxelBrick::size; ++i)
        {
            if (b.phase[i] == LIQUID)
            {
                result.push_back
                (
                    {o[0] + (i >> 6), o[1] + ((i >> 3) & 7), o[2] + (i & 7)}
                );
            }
        }
    }
    return result;
}


std::int64_t room(const voxelGrid& grid, const std::array<int, 3>& v)
{
    return grid.capacity(v[0], v[1], v[2]) - grid.mass(v[0], v[1], v[2]);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::int32_t& Foam::melt::publishedRule::energyAt
(
    const voxelGrid& grid,
    const int x,
    const int y,
    const int z
)
{
    const std::array<int, 3>& nb = grid.nBricks();
    energy_.resize(std::size_t(nb[0])*nb[1]*nb[2]);
    std::vector<std::int32_t>& energies =
        energy_[grid.brickIndex(x >> 3, y >> 3, z >> 3)];
    if (energies.empty())
    {
        energies.assign
        (
            voxelBrick::size, std::int32_t(coeffs_.initialEnergy*unity)
        );
    }
    return energies[voxelBrick::offset(x, y, z)];
}


void Foam::melt::publishedRule::move
(
    voxelGrid& grid,
    const std::array<int, 3>& from,
    const std::array<int, 3>& to,
    const std::int64_t mass,
    const double gain
)
{
    voxelBrick& donor = grid.ownAt(from[0], from[1], from[2]);
    const int i = voxelBrick::offset(from[0], from[1], from[2]);
    const std::int64_t enthalpy =
        mass == donor.mass[i]
      ? donor.energy[i]
      : voxelMaterial::share(donor.energy[i], mass, donor.mass[i]);
    std::int32_t& donorEnergy = energyAt(grid, from[0], from[1], from[2]);
    const double energy = double(donorEnergy)*mass/donor.mass[i];
    donorEnergy = std::int32_t(std::max(0.0, donorEnergy - energy));
    donor.mass[i] -= std::int32_t(mass);
    donor.energy[i] -= enthalpy;
    donor.changed = true;

    if (!grid.inside(to[0], to[1], to[2]))
    {
        lostMass_ += mass;
        lostEnergy_ += enthalpy;
        return;
    }
    voxelBrick& receiver = grid.ownAt(to[0], to[1], to[2]);
    const int j = voxelBrick::offset(to[0], to[1], to[2]);
    std::int32_t& received = energyAt(grid, to[0], to[1], to[2]);
    const double before = receiver.mass[j] > 0 ? received : 0;
    received = std::int32_t(std::min(unity, before + gain*energy));
    receiver.mass[j] += std::int32_t(mass);
    receiver.energy[j] += enthalpy;
    receiver.changed = true;
}


double Foam::melt::publishedRule::alpha
(
    const voxelGrid& grid,
    const std::array<int, 3>& v
) const
{
    const std::uint8_t below = grid.phase(v[0], v[1], v[2] - 1);
    return
        below == ROCK ? coeffs_.alphaFloor
      : below == SOLID ? coeffs_.alphaSolid
      : coeffs_.alphaLiquid;
}


std::array<int, 4> Foam::melt::publishedRule::order
(
    const std::array<int, 3>& v
) const
{
    std::array<int, 4> result{0, 1, 2, 3};

    // splitmix64 of what is unique
    std::uint64_t x = coeffs_.seed;
    for (const std::int64_t part : {step_, std::int64_t(v[0]),
        std::int64_t(v[1]), std::int64_t(v[2])})
    {
        x += std::uint64_t(part) + 0x9E3779B97F4A7C15;
        x = (x ^ (x >> 30))*0xBF58476D1CE4E5B9;
        x = (x ^ (x >> 27))*0x94D049BB133111EB;
        x ^= x >> 31;
    }
    for (int permutation = int(x % 24); permutation > 0; --permutation)
    {
        std::next_permutation(result.begin(), result.end());
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::publishedRule::fall(voxelGrid& grid)
{
    std::vector<std::array<int, 3>> voxels(liquidVoxels(grid));
    std::stable_sort
    (
        voxels.begin(),
        voxels.end(),
        [](const std::array<int, 3>& a, const std::array<int, 3>& b)
        {
            return a[2] < b[2];
        }
    );
    for (const std::array<int, 3>& v : voxels)
    {
        const std::array<int, 3> below{v[0], v[1], v[2] - 1};
        if (below[2] < 0 && !grid.open(4))
        {
            continue;
        }
        const std::int64_t mass = grid.mass(v[0], v[1], v[2]);
        const std::int64_t moved = std::min
        (
            std::int64_t(std::ceil(coeffs_.factor*mass)),
            below[2] < 0 ? mass : room(grid, below)
        );
        if (moved > 0)
        {
            move(grid, v, below, moved, 1 + coeffs_.beta);
        }
    }
    grid.refresh();
}


void Foam::melt::publishedRule::spread(voxelGrid& grid)
{
    const auto threshold = std::int32_t(coeffs_.threshold*unity);
    std::vector<gift> gifts;
    for (const std::array<int, 3>& v : liquidVoxels(grid))
    {
        if (energyAt(grid, v[0], v[1], v[2]) <= threshold)
        {
            continue;
        }
        const bool rests =
            v[2] == 0 ? !grid.open(4) : room(grid, {v[0], v[1], v[2] - 1}) <= 0;
        if (!rests)
        {
            continue;
        }

        const std::int64_t mass = grid.mass(v[0], v[1], v[2]);
        std::int64_t left = mass;
        for (const int side : order(v))
        {
            const std::array<int, 3> to
            {
                v[0] + (side == 0) - (side == 1),
                v[1] + (side == 2) - (side == 3),
                v[2]
            };
            const bool inside = grid.inside(to[0], to[1], to[2]);
            if (grid.phase(to[0], to[1], to[2]) & 2)
            {
                continue;
            }
            const std::int64_t given = std::min
            ({
                std::int64_t(coeffs_.share*(coeffs_.random ? left : mass)),
                left,
                inside ? room(grid, to)/4 : left
            });
            if (given > 0)
            {
                gifts.push_back({v, to, given});
                left -= given;
            }
        }
    }
    for (const gift& g : gifts)
    {
        move(grid, g.from, g.to, g.mass, alpha(grid, g.to));
    }
    ++step_;
    grid.refresh();
}

// ************************************************************************* //
