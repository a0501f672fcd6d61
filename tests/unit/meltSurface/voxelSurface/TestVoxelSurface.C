/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelSurface.H"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

using namespace Foam::melt;

namespace
{

const std::array<int, 3> size{{24, 26, 28}};
const std::array<double, 3> origin{{-0.6, -0.65, -0.7}};
const double voxel = 0.05;

//- 0.5 at the sphere of radius 0.4 about the origin, linear across it
std::vector<float> ball()
{
    std::vector<float> value;
    for (int k = 0; k < size[2]; ++k)
    {
        for (int j = 0; j < size[1]; ++j)
        {
            for (int i = 0; i < size[0]; ++i)
            {
                const double r = std::sqrt
                (
                    std::pow(origin[0] + i*voxel, 2)
                  + std::pow(origin[1] + j*voxel, 2)
                  + std::pow(origin[2] + k*voxel, 2)
                );
                const double chi = 0.5 + (0.4 - r)/(4*voxel);
                value.push_back(float(std::min(std::max(chi, 0.0), 1.0)));
            }
        }
    }
    return value;
}

}

TEST(voxelSurface, ballOfDenseVoxels)
{
    const triangleMesh mesh =
        voxelSurface(size, ball().data(), origin, voxel, 0.5);
    EXPECT_EQ(mesh.nBadEdges(), 0u);
    EXPECT_NEAR(mesh.volume()/(4*M_PI/3*std::pow(0.4, 3)), 1, 0.02);
    EXPECT_NEAR(mesh.area()/(4*M_PI*std::pow(0.4, 2)), 1, 0.02);
}

TEST(voxelSurface, sparseEqualsDense)
{
    const std::vector<float> value = ball();
    std::vector<int> ijk;
    std::vector<float> given;
    for (int i = 0; i < int(value.size()); ++i)
    {
        if (value[i] > 0)
        {
            const int row = i/size[0];
            ijk.insert
            (
                ijk.end(), {i % size[0], row % size[1], row/size[1]}
            );
            given.push_back(value[i]);
        }
    }
    const triangleMesh dense =
        voxelSurface(size, value.data(), origin, voxel, 0.5);
    const triangleMesh sparse = voxelSurface
    (
        given.size(), ijk.data(), given.data(), origin, voxel, 0.5
    );
    EXPECT_EQ(sparse.points, dense.points);
    EXPECT_EQ(sparse.triangles, dense.triangles);
}

TEST(voxelSurface, fullBlockIsClosedAtItsBorders)
{
    const std::array<int, 3> cube{{4, 4, 4}};
    const std::vector<float> value(64, 1);
    const triangleMesh mesh =
        voxelSurface(cube, value.data(), {{0, 0, 0}}, 1, 0.5);
    EXPECT_EQ(mesh.nBadEdges(), 0u);
    // Faces are midway between the last voxel's centre and the empty one's
    const auto range =
        std::minmax_element(mesh.points.begin(), mesh.points.end());
    EXPECT_NEAR(*range.first, -0.5, 1e-6);
    EXPECT_NEAR(*range.second, 3.5, 1e-6);
}

TEST(voxelSurface, refusesBadArguments)
{
    const float value = 1;
    const std::array<int, 3> one{{1, 1, 1}};
    const std::array<double, 3> zero{{0, 0, 0}};
    EXPECT_THROW(voxelSurface(one, &value, zero, 0, 1), std::invalid_argument);
    EXPECT_THROW(voxelSurface(one, &value, zero, 1, 0), std::invalid_argument);
}
