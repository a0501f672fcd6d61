/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exposedFaces.H"
#include "meltVoxelAutomaton/voxelTestTools.H"
#include "voxelConduction.H"
#include "voxelRays.H"

#include <gtest/gtest.h>

#include <random>

using namespace unitTest;

namespace
{

const double dx = 1e-2;

//- A full cube of solid of one conductivity at T(x, y, z)
template<class Temperature>
voxelGrid* cube(const int n, const Temperature& T)
{
    voxelMaterial material(wax(dx));
    material.kappaLiquid = material.kappaSolid;
    auto* grid = new voxelGrid({n, n, n}, dx, material);
    for (int x = 0; x < n; ++x)
    {
        for (int y = 0; y < n; ++y)
        {
            for (int z = 0; z < n; ++z)
            {
                grid->fill(x, y, z, 1, T(x, y, z));
            }
        }
    }
    grid->refresh();
    return grid;
}


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


// The symbol of the rule for a wave of temperature, with gamma by which the
// paper's rule has the material's diffusivity
TEST(VoxelConduction, symbolOfTheRule)
{
    // What a unit of enthalpy is, times the neighbours
    const double roundOff = 2e-9;
    const int n = 24;
    for (const int neighbours : {6, 18, 26})
    {
        const double k[3] = {0.3, 0.45, 0.7};
        const double amplitude = 10;
        const std::unique_ptr<voxelGrid> grid
        (
            cube
            (
                n,
                [&](const int x, const int y, const int z)
                {
                    return
                        280 + amplitude*std::cos(k[0]*x + k[1]*y + k[2]*z);
                }
            )
        );
        voxelConduction conduction(neighbours);
        const double dt = 0.5*conduction.maxDeltaT(*grid);
        const double alpha = 0.2/(1000*1000);
        const double f = neighbours == 6 ? 1 : neighbours == 18 ? 3 : 13.0/3;
        const int farthest = neighbours == 6 ? 1 : neighbours == 18 ? 2 : 3;
        double gain = 1;
        for (int i = 0; i < 27; ++i)
        {
            const int a = i/9 - 1, b = i/3 % 3 - 1, c = i % 3 - 1;
            const int l2 = a*a + b*b + c*c;
            if (l2 > 0 && l2 <= farthest)
            {
                gain +=
                    alpha*dt/(dx*dx)/(f*l2)
                   *(std::cos(k[0]*a + k[1]*b + k[2]*c) - 1);
            }
        }
        const int m = n/2;
        const double before = grid->T(m, m, m) - 280;
        conduction.conduct(*grid, dt);
        EXPECT_NEAR((grid->T(m, m, m) - 280)/before, gain, roundOff)
            << neighbours << " neighbours";
    }
}


// A wave of temperature along rods and sheets with adiabatic sides decays as in
// one dimension, also where diagonal neighbours are missing
TEST(VoxelConduction, sidesAreAMirror)
{
    const int n = 16;
    const double k = M_PI/n, alpha = 0.2/(1000*1000);
    voxelMaterial material(wax(dx));
    material.kappaLiquid = material.kappaSolid;
    for (const int neighbours : {6, 18, 26})
    {
        for (const int width : {1, 2, 3})
        {
            for (const int height : {1, 4})
            {
                voxelGrid grid({n, 5, 6}, dx, material);
                for (int i = 0; i < n*width*height; ++i)
                {
                    const int x = i/(width*height), y = i/height % width;
                    grid.fill
                    (
                        x, y + 1, i % height, 1, 280 + 10*std::cos(k*(x + 0.5))
                    );
                }
                grid.refresh();
                voxelConduction conduction(neighbours);
                const double dt = conduction.maxDeltaT(grid);
                const double before = grid.T(3, 1, 0) - 280;
                conduction.conduct(grid, dt);
                EXPECT_NEAR
                (
                    (grid.T(3, 1, 0) - 280)/before,
                    1 + 2*alpha*dt/(dx*dx)*(std::cos(k) - 1),
                    2e-9
                )
                    << neighbours << " neighbours, " << width << " x " << height;
            }
        }
    }
}


TEST(VoxelConduction, keepsEnthalpyAndBounds)
{
    for (const int neighbours : {6, 18, 26})
    {
        voxelGrid grid({20, 20, 20}, dx, wax(dx));
        fillRandomly(grid, 11);
        double low = 1e9, high = 0;
        const auto bounds = [&]()
        {
            double a = 1e9, b = 0;
            for (int i = 0; i < 8000; ++i)
            {
                if (grid.mass(i/400, i/20 % 20, i % 20) > 0)
                {
                    const double T = grid.T(i/400, i/20 % 20, i % 20);
                    a = std::min(a, T);
                    b = std::max(b, T);
                }
            }
            return std::make_pair(a, b);
        };
        std::tie(low, high) = bounds();
        const std::int64_t energy = grid.totalEnergy();
        voxelConduction conduction(neighbours);
        for (int step = 0; step < 200; ++step)
        {
            conduction.conduct(grid, conduction.maxDeltaT(grid));
            EXPECT_EQ(grid.totalEnergy(), energy);
            const std::pair<double, double> now = bounds();
            EXPECT_GE(now.first, low - 1e-6);
            EXPECT_LE(now.second, high + 1e-6);
        }
    }
    EXPECT_THROW(voxelConduction(7), std::invalid_argument);
}


TEST(VoxelRays, blockedByWhatIsBetween)
{
    voxelGrid grid({20, 20, 20}, dx, wax(dx));
    grid.fill(10, 10, 10, 0.2, 280);
    grid.fillRock(4, 4, 4, 1);
    grid.refresh();
    EXPECT_TRUE(voxelRays::blocked(grid, {2.5, 10.5, 10.5}, {30, 10.5, 10.5}));
    EXPECT_TRUE(voxelRays::blocked(grid, {0.5, 0.5, 0.5}, {8, 8, 8}));
    EXPECT_FALSE(voxelRays::blocked(grid, {2.5, 10.5, 10.5}, {9.9, 10.5, 10.5}));
    EXPECT_FALSE(voxelRays::blocked(grid, {2.5, 11.5, 10.5}, {30, 11.5, 10.5}));
    EXPECT_FALSE(voxelRays::blocked(grid, {-5, 30, 3}, {-6, 40, 30}));
    EXPECT_FALSE(voxelRays::blocked(grid, {11, 10.5, 10.5}, {15, 10.5, 10.5}));
}


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
