/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gravityRule.H"

#include <algorithm>
#include <cmath>
#include <cstring>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::gravityRule::besideWall
(
    const voxelGrid& grid,
    const int x,
    const int y,
    const int z
)
{
    // SOLID and ROCK have the second bit
    return
    (
        grid.phase(x - 1, y, z) | grid.phase(x + 1, y, z)
      | grid.phase(x, y - 1, z) | grid.phase(x, y + 1, z)
    ) & 2;
}


std::int64_t Foam::melt::gravityRule::fall
(
    voxelGrid& grid,
    const int x,
    const int y,
    const int z,
    const double dt
)
{
    const int i = voxelBrick::offset(x, y, z);
    const std::int64_t mass = grid.brickAt(x, y, z).mass[i];
    std::int64_t room = mass;

    if (z == 0)
    {
        if (!grid.open(4))
        {
            return 0;
        }
    }
    else
    {
        room = grid.capacity(x, y, z - 1) - grid.mass(x, y, z - 1);
        if (room <= 0)
        {
            return 0;
        }
    }

    const double free = std::min(1.0, dt/maxDeltaT(grid));
    auto moved = std::int64_t(free*mass);
    const double filling = double(mass)/voxelMaterial::full;
    if (besideWall(grid, x, y, z))
    {
        const double dx = grid.dx();
        const double weight = grid.material().rho*g_;
        const double fluidity = film_.fluidity
        (
            grid.T(x, y, z), weight*filling*dx
        );
        const double portion = weight*fluidity*filling*filling*dx*dt/3;
        moved = std::min(moved, std::int64_t(portion*mass));
    }
    else if (filling < dregs_)
    {
        moved = mass;
    }
    moved = std::min(moved, room);
    if (moved <= 0)
    {
        return 0;
    }

    voxelBrick& from = grid.ownAt(x, y, z);
    const std::int64_t energy =
        moved == mass
      ? from.energy[i] : voxelMaterial::share(from.energy[i], moved, mass);
    from.mass[i] -= std::int32_t(moved);
    from.energy[i] -= energy;
    from.changed = true;

    if (z == 0)
    {
        #pragma omp atomic
        lostMass_ += moved;
        #pragma omp atomic
        lostEnergy_ += energy;
    }
    else
    {
        voxelBrick& to = grid.ownAt(x, y, z - 1);
        const int j = voxelBrick::offset(x, y, z - 1);
        to.mass[j] += std::int32_t(moved);
        to.energy[j] += energy;
        to.changed = true;
    }
    return moved;
}


double Foam::melt::gravityRule::fallColumn
(
    voxelGrid& grid,
    const int bx,
    const int by,
    const double dt
)
{
    constexpr std::uint64_t lowBits = 0x0101010101010101;
    double fastest = 0;

    for (int bz = 0; bz < grid.nBricks()[2]; ++bz)
    {
        const voxelBrick& b = grid.brick(grid.brickIndex(bx, by, bz));
        if (b.nLiquid == 0)
        {
            continue;
        }
        for (int column = 0; column < 64; ++column)
        {
            std::uint64_t phase;
            std::memcpy(&phase, b.phase + 8*column, sizeof(phase));

            // LIQUID alone has the first bit without the second
            for
            (
                std::uint64_t liquid = phase & ~(phase >> 1) & lowBits;
                liquid;
                liquid &= liquid - 1
            )
            {
                const int i = __builtin_ctzll(liquid)/8;
                const std::int32_t mass = b.mass[8*column + i];
                if (i > 0 && b.mass[8*column + i - 1] == voxelMaterial::full)
                {
                    continue;
                }
                const std::int64_t moved = fall
                (
                    grid, 8*bx + column/8, 8*by + column % 8, 8*bz + i, dt
                );
                fastest = std::max(fastest, double(moved)/mass);
            }
        }
    }
    return fastest;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::gravityRule::gravityRule
(
    const filmViscosity& film,
    const double g,
    const double dregs
)
:
    film_(film),
    g_(g),
    dregs_(dregs)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::melt::gravityRule::maxDeltaT(const voxelGrid& grid) const
{
    return g_ > 0 ? std::sqrt(2*grid.dx()/g_) : 1e30;
}


void Foam::melt::gravityRule::fall(voxelGrid& grid, const double dt)
{
    if (g_ <= 0)
    {
        return;
    }
    const std::array<int, 3>& nb = grid.nBricks();
    std::vector<char> melted(std::size_t(nb[0])*nb[1], 0);
    for (const int index : grid.list())
    {
        if (grid.brick(index).nLiquid)
        {
            melted[index % melted.size()] = 1;
        }
    }

    double fastest = 0;
    #pragma omp parallel for schedule(dynamic, 4) reduction(max:fastest)
    for (int i = 0; i < int(melted.size()); ++i)
    {
        if (melted[i])
        {
            fastest = std::max
            (
                fastest, fallColumn(grid, i % nb[0], i/nb[0], dt)
            );
        }
    }
    maxSpeed_ = fastest*grid.dx()/dt;

    grid.refresh();
}

// ************************************************************************* //
