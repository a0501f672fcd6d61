/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ventRule.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::ventRule::ventRule
(
    const dictionary& meltProperties,
    const voxelFrame& frame
)
:
    frame_(frame),
    vents_(meltProperties),
    waiting(vents_.size(), 0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::int64_t Foam::melt::ventRule::put
(
    voxelGrid& grid,
    const int x,
    const int y,
    const int z0,
    std::int64_t left,
    const scalar T
)
{
    const scalar h = grid.material().curve.h(T);
    bool begun = false;
    for (int z = std::max(z0, 0); z < grid.n()[2] && left > 0; ++z)
    {
        const int i = voxelBrick::offset(x, y, z);
        const std::int64_t room =
            grid.brickAt(x, y, z).capacity(i) - grid.mass(x, y, z);
        if (grid.phase(x, y, z) == ROCK)
        {
            if (begun)
            {
                break;
            }
            continue;
        }
        begun = true;
        const auto moved = std::int32_t(std::min(left, room));
        if (moved > 0)
        {
            voxelBrick& b = grid.ownAt(x, y, z);
            const std::int64_t enthalpy = grid.material().energy(moved, h);
            b.mass[i] += moved;
            b.energy[i] += enthalpy;
            b.changed = true;
            left -= moved;
            mass += moved;
            energy += enthalpy;
        }
    }
    return left;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::ventRule::flow
(
    voxelGrid& grid,
    const scalar time,
    const scalar dt
)
{
    if (vents_.update())
    {
        waiting.resize(vents_.size(), 0);
    }

    forAll(vents_, venti)
    {
        const vent& v = vents_[venti];
        const std::array<double, 3> centre = frame_.coordinates(v.position());
        const scalar radius = v.radius()/frame_.dx();

        std::vector<std::array<int, 2>> columns;
        const double reach = std::max(radius, 0.75);
        const auto first = [&](const int axis)
        {
            return std::max(int(std::floor(centre[axis] - reach)), 0);
        };
        const auto last = [&](const int axis)
        {
            return std::min(int(centre[axis] + reach), grid.n()[axis] - 1);
        };
        for (int x = first(0); x <= last(0); ++x)
        {
            for (int y = first(1); y <= last(1); ++y)
            {
                if
                (
                    std::hypot(x + 0.5 - centre[0], y + 0.5 - centre[1])
                 <= reach
                )
                {
                    columns.push_back({x, y});
                }
            }
        }
        if (columns.empty())
        {
            FatalIOErrorInFunction(v.dict())
                << "Vent " << v.name() << " at " << v.position()
                << " is not in the domain" << exit(FatalIOError);
        }

        waiting[venti] += v.rate(time)*dt;
        const auto n = std::int64_t(columns.size());
        const auto share = std::int64_t
        (
            waiting[venti]/grid.material().massUnit/n
        );
        std::int64_t refused = 0;
        for (const std::array<int, 2>& c : columns)
        {
            refused += put
            (
                grid, c[0], c[1], int(std::floor(centre[2])), share, v.T()
            );
        }
        waiting[venti] -= (share*n - refused)*grid.material().massUnit;
    }
    grid.refresh();
}

// ************************************************************************* //
