/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exposedFaces.H"
#include "meltVoxelAutomaton/voxelTestTools.H"

#include <gtest/gtest.h>

#include <random>

using namespace unitTest;

namespace
{

const double dx = 1e-2;


double smoothArea(voxelGrid& grid)
{
    exposedFaces faces;
    faces.build(grid);
    double sum = 0;
    for (const exposedFace& f : faces.free)
    {
        sum += f.smooth;
    }
    return sum;
}

} // End anonymous namespace


// A sphere's faces: by area of the staircase 6 pi R^2, by what they stand for
// 4 pi R^2; of whole voxels or cut by the surface
TEST(ExposedFaces, areaOfASphere)
{
    for (const bool partial : {false, true})
    {
        for (const double R : {6.3, 12.3, 24.3})
        {
            const int n = 2*int(R) + 8;
            voxelGrid grid({n, n, n}, dx, wax(dx));
            for (int i = 0; i < n*n*n; ++i)
            {
                const double x = i/(n*n) - n/2 + 0.4;
                const double y = i/n % n - n/2 + 0.4, z = i % n - n/2 + 0.4;
                const double out = std::sqrt(x*x + y*y + z*z) - R;
                const double share =
                    partial ? std::clamp(0.5 - out, 0.0, 1.0) : out < 0;
                if (share > 0)
                {
                    grid.fill(i/(n*n), i/n % n, i % n, share, 280);
                }
            }
            grid.refresh();
            exposedFaces faces;
            faces.build(grid);
            double area = 0, smooth = 0;
            for (const exposedFace& f : faces.free)
            {
                area += f.area;
                smooth += f.smooth;
            }
            std::cout << "    R = " << R << (partial ? ", cut" : ", whole")
                << ": area " << area/(6*M_PI*R*R) << ", smooth "
                << smooth/(4*M_PI*R*R) << '\n';
            EXPECT_NEAR(area/(6*M_PI*R*R), 1, 0.03);
            EXPECT_NEAR(smooth/(4*M_PI*R*R), 1, 0.03);
            EXPECT_TRUE(faces.atSides.empty());
        }
    }
}


// Flat faces, their edges and corners stand for themselves, also of sheets and
// rods
TEST(ExposedFaces, areaOfBoxesIsExact)
{
    for (const std::array<int, 3>& m :
        {
            std::array<int, 3>{10, 10, 10},
            std::array<int, 3>{2, 3, 4},
            std::array<int, 3>{5, 5, 1},
            std::array<int, 3>{1, 1, 7}
        })
    {
        voxelGrid grid({16, 16, 16}, dx, wax(dx));
        for (int i = 0; i < m[0]*m[1]*m[2]; ++i)
        {
            grid.fill
            (
                3 + i/(m[1]*m[2]), 3 + i/m[2] % m[1], 3 + i % m[2], 1, 280
            );
        }
        grid.refresh();
        EXPECT_FLOAT_EQ
        (
            smoothArea(grid), 2*(m[0]*m[1] + m[1]*m[2] + m[2]*m[0])
        );
    }
}


// The same with sides within voxels, here in their middle
TEST(ExposedFaces, areaOfABoxWithinVoxelsIsExact)
{
    voxelGrid grid({12, 12, 12}, dx, wax(dx));
    const auto share = [](const int i)
    {
        return i == 0 || i == 5 ? 0.5 : 1.0;
    };
    for (int i = 0; i < 6*6*6; ++i)
    {
        const int x = i/36, y = i/6 % 6, z = i % 6;
        grid.fill(3 + x, 3 + y, 3 + z, share(x)*share(y)*share(z), 280);
    }
    grid.refresh();
    EXPECT_FLOAT_EQ(smoothArea(grid), 6*5*5);
}


// The staircase of a slope stands for its plane, in whole voxels
TEST(ExposedFaces, areaOfASlope)
{
    for (const std::array<double, 2>& slope :
        {
            std::array<double, 2>{0.125, 0},
            std::array<double, 2>{1.0/3, 0},
            std::array<double, 2>{1, 0},
            std::array<double, 2>{0.5, 0.25},
            std::array<double, 2>{1, 1}
        })
    {
        const int n = 32, n0 = 8, nz = 64;
        voxelGrid grid({n, n, nz}, dx, wax(dx));
        for (int x = 0; x < n; ++x)
        {
            for (int y = 0; y < n; ++y)
            {
                const int height = int(3.5 + slope[0]*x + slope[1]*y);
                for (int z = 0; z < std::min(height, nz); ++z)
                {
                    grid.fill(x, y, z, 1, 280);
                }
            }
        }
        grid.refresh();
        exposedFaces faces;
        faces.build(grid);
        double smooth = 0;
        for (const exposedFace& f : faces.free)
        {
            // Whole periods of the slope, away from the sides
            if (f.x >= 4 && f.x < 28 && f.y >= n0 && f.y < n0 + 16)
            {
                smooth += f.smooth;
            }
        }
        const double exact =
            24*16
           *std::sqrt(1 + slope[0]*slope[0] + slope[1]*slope[1]);
        std::cout << "    slope " << slope[0] << ' ' << slope[1] << ": "
            << smooth/exact << '\n';
        EXPECT_NEAR(smooth/exact, 1, 0.04);
    }
}

// What shines on a film on the floor, front or not, heats it at most twice as
// fast as a sheet as thick as the film beside it, however little there is in it
TEST(ExposedFaces, filmsAtFrontsCoverTheirFloorInPart)
{
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> decades(-8, 0);
    const int n = 24;
    voxelGrid grid({n, n, 4}, dx, wax(dx));
    for (int i = 0; i < n*n; ++i)
    {
        const double share = std::pow(10, decades(engine));
        if (share > 1e-7)
        {
            grid.fill(i/n, i % n, 0, share, 350);
        }
    }
    grid.refresh();
    exposedFaces faces;
    faces.build(grid);
    const auto filled = [&](const int x, const int y)
    {
        return
            grid.inside(x, y, 0)
          ? double(grid.mass(x, y, 0))/voxelMaterial::full : 0;
    };
    int nPartly = 0;
    for (const exposedFace& f : faces.free)
    {
        if (f.side == 5)
        {
            const double beside = std::max
            ({
                filled(f.x - 1, f.y), filled(f.x + 1, f.y),
                filled(f.x, f.y - 1), filled(f.x, f.y + 1)
            });
            const double own = filled(f.x, f.y);
            EXPECT_LE(f.area/own, std::min(1/own, 2/beside)*(1 + 1e-5));
            nPartly += f.area < 1;
        }
    }
    EXPECT_GT(nPartly, n*n/2);
}


// A sheet that becomes thinner by less than a half from voxel to voxel covers
// its floor; what lies on melt is not at its front
TEST(ExposedFaces, sheetsCoverTheirFloor)
{
    voxelGrid grid({8, 8, 4}, dx, wax(dx));
    const double height[8] = {1.3, 1, 0.6, 0.31, 0.16, 0.02, 1e-4, 0};
    for (int i = 0; i < 64; ++i)
    {
        const double h = height[i/8];
        if (h > 0)
        {
            grid.fill(i/8, i % 8, 0, std::min(h, 1.0), 350);
        }
        if (h > 1)
        {
            grid.fill(i/8, i % 8, 1, h - 1, 350);
        }
    }
    grid.refresh();
    exposedFaces faces;
    faces.build(grid);
    const double expected[8] = {1, 1, 1, 1, 1, 0.02/0.08, 1e-4/0.04, 0};
    for (const exposedFace& f : faces.free)
    {
        if (f.side == 5)
        {
            EXPECT_NEAR(f.area/expected[f.x], 1, 1e-4) << f.x;
        }
    }
}

// ************************************************************************* //
