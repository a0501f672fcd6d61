/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelSurface.H"
#include "vdbSurface.H"

#include <stdexcept>

namespace
{

void checkVoxel(const double voxel)
{
    if (!(voxel > 0))
    {
        throw std::invalid_argument("voxelSurface: voxel must be positive");
    }
}

}


Foam::melt::triangleMesh Foam::melt::voxelSurface
(
    const std::array<int, 3>& size,
    const float* value,
    const std::array<double, 3>& origin,
    const double voxel,
    const double level
)
{
    checkVoxel(voxel);
    auto grid = vdbGrid(origin, voxel);
    auto accessor = grid->getAccessor();

    openvdb::Coord ijk;
    for (ijk[2] = 0; ijk[2] < size[2]; ++ijk[2])
    {
        for (ijk[1] = 0; ijk[1] < size[1]; ++ijk[1])
        {
            for (ijk[0] = 0; ijk[0] < size[0]; ++ijk[0], ++value)
            {
                if (*value != 0)
                {
                    accessor.setValue(ijk, *value);
                }
            }
        }
    }
    return vdbSurface(*grid, level);
}


Foam::melt::triangleMesh Foam::melt::voxelSurface
(
    const std::size_t n,
    const int* ijk,
    const float* value,
    const std::array<double, 3>& origin,
    const double voxel,
    const double level
)
{
    checkVoxel(voxel);
    auto grid = vdbGrid(origin, voxel);
    auto accessor = grid->getAccessor();

    for (std::size_t i = 0; i < n; ++i)
    {
        accessor.setValue(openvdb::Coord(&ijk[3*i]), value[i]);
    }
    return vdbSurface(*grid, level);
}
