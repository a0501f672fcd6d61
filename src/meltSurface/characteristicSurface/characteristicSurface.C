/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "characteristicSurface.H"
#include "kernelCloud.H"
#include "vdbSurface.H"

#include <cmath>
#include <stdexcept>

Foam::melt::triangleMesh Foam::melt::characteristicSurface
(
    const std::size_t n,
    const double* position,
    const double* volume,
    const double radius,
    const double voxel,
    const double level
)
{
    if (!(voxel > 0 && radius >= voxel))
    {
        throw std::invalid_argument
        (
            "characteristicSurface: needs 0 < voxel <= radius"
        );
    }

    openvdb::FloatGrid::Ptr grid = vdbGrid({0, 0, 0}, voxel);
    auto accessor = grid->getAccessor();

    for (std::size_t i = 0; i < n; ++i)
    {
        const openvdb::Vec3d x(&position[3*i]);
        const openvdb::Vec3d low = (x - openvdb::Vec3d(radius))/voxel;
        const openvdb::Vec3d high = (x + openvdb::Vec3d(radius))/voxel;
        openvdb::Coord ijk;
        for (ijk[0] = int(std::ceil(low[0])); ijk[0] <= high[0]; ++ijk[0])
        {
            for (ijk[1] = int(std::ceil(low[1])); ijk[1] <= high[1]; ++ijk[1])
            {
                const openvdb::Vec2d across
                (
                    ijk[0]*voxel - x[0],
                    ijk[1]*voxel - x[1]
                );
                const double chord =
                    radius*radius - across.dot(across);
                if (chord <= 0)
                {
                    continue;
                }
                const double half = std::sqrt(chord);
                ijk[2] = int(std::ceil((x[2] - half)/voxel));
                for (; ijk[2]*voxel <= x[2] + half; ++ijk[2])
                {
                    const double r = std::sqrt
                    (
                        across.dot(across)
                      + std::pow(ijk[2]*voxel - x[2], 2)
                    );
                    const double w = kernelCloud::kernel(r, radius);
                    accessor.modifyValue
                    (
                        ijk,
                        [&](float& value) { value += float(volume[i]*w); }
                    );
                }
            }
        }
    }

    return vdbSurface(*grid, level);
}
