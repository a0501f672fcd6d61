/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "filmHeating.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::filmHeating::give
(
    voxelGrid& grid,
    const exposedFace& face,
    const scalar T,
    const scalar power,
    const scalar slope,
    const scalar dt,
    heatAccount& account
)
{
    if (power == 0)
    {
        return;
    }
    const voxelMaterial& material = grid.material();

    // The voxel itself, the one below, solids beside and above it, with what
    // counts of their masses
    struct part
    {
        int x, y, z;
        scalar mass;
    };
    std::array<part, 7> parts;
    int n = 0;
    scalar total = 0;
    const auto add = [&](const int x, const int y, const int z, const scalar w)
    {
        const scalar mass = w*grid.mass(x, y, z)*material.massUnit;
        if (mass > 0)
        {
            parts[n++] = {x, y, z, mass};
            total += mass;
        }
    };
    add(face.x, face.y, face.z, 1);
    const scalar vacant =
        1 - scalar(grid.mass(face.x, face.y, face.z))/voxelMaterial::full;
    for (int side = 0; side < 6; ++side)
    {
        const std::array<int, 3> d = exposedFaces::normal(side);
        const int x = face.x + d[0], y = face.y + d[1], z = face.z + d[2];
        const std::uint8_t phase = grid.phase(x, y, z);
        if
        (
            grid.inside(x, y, z)
         && (phase == SOLID || (side == 4 && phase == LIQUID))
        )
        {
            add(x, y, z, vacant);
        }
    }

    const auto h = [&](const part& p)
    {
        return material.h
        (
            grid.mass(p.x, p.y, p.z),
            grid.brickAt(p.x, p.y, p.z).energy
            [
                voxelBrick::offset(p.x, p.y, p.z)
            ]
        );
    };
    const scalar hFilm = h(parts[0]);
    const scalar heat =
        power*dt/(1 + slope*dt/(total*material.curve.Cp(hFilm)));
    for (int i = 0; i < n; ++i)
    {
        const part& p = parts[i];
        scalar share = heat*p.mass/total;
        if (slope > 0)
        {
            // Not beyond the temperature at which the power would be 0: on its
            // way the voxel's heat capacity may fall
            const scalar balance =
                p.mass*(material.curve.h(T + power/slope) - h(p));
            share =
                power > 0
              ? min(share, max(balance, scalar(0)))
              : max(share, min(balance, scalar(0)));
        }
        account.give(grid, p.x, p.y, p.z, share, dt);
    }
}

// ************************************************************************* //
