/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatAccount.H"

#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::heatAccount::give
(
    voxelGrid& grid,
    const int x,
    const int y,
    const int z,
    const double heat,
    const double dt
)
{
    voxelBrick& b = grid.ownAt(x, y, z);
    const auto energy =
        std::int64_t(std::llround(heat/grid.material().energyUnit));
    b.energy[voxelBrick::offset(x, y, z)] += energy;
    b.changed = true;
    (energy > 0 ? in : out) += std::abs(energy);
    fastest = max(fastest, std::abs(energy)/(voxelMaterial::energyRange*dt));
}

// ************************************************************************* //
