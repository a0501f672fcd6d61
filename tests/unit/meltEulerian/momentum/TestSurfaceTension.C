/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceTension.H"
#include "heightCurvature.H"
#include "meltFlow.H"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace Foam::melt;

namespace
{

const double sigma = 0.03, rho = 1000, eta = 0.1;

//- A drop in a box of edge 1 m
struct drop
{
    const double radius;

    const bool inSpace;

    staggeredGrid grid;

    std::vector<double> alpha;

    drop
    (
        const int n,
        const bool threeDimensional,
        const std::array<double, 3>& centre,
        const double R
    )
    :
        radius(R),
        inSpace(threeDimensional),
        grid
        (
            {n, n, threeDimensional ? n : 1},
            {1.0/n, 1.0/n, 1.0/n},
            {true, true, threeDimensional}
        ),
        alpha(grid.nCells(), 0)
    {
        // Means over points of a face of the length inside along the normal to
        // it, which is exact: the normal nearest to that of the surface
        const int nPoints = 48;
        const double d = 1.0/n;
        for (int cell = 0; cell < grid.nCells(); ++cell)
        {
            std::array<double, 3> low{};
            int a = 0;
            double square = 0;
            for (int b = 0; b < (inSpace ? 3 : 2); ++b)
            {
                low[b] = d*grid.position(cell)[b] - centre[b];
                a = std::abs(low[b] + 0.5*d) > std::abs(low[a] + 0.5*d) ? b : a;
                square += (low[b] + 0.5*d)*(low[b] + 0.5*d);
            }
            if (std::abs(std::sqrt(square) - R) > d)
            {
                alpha[cell] = square < R*R;
                continue;
            }
            const int b = inSpace ? (a + 1) % 3 : 1 - a, c = (a + 2) % 3;
            for (int i = 0; i < nPoints; ++i)
            {
                for (int j = 0; j < (inSpace ? nPoints : 1); ++j)
                {
                    const double x = low[b] + d*(i + 0.5)/nPoints;
                    const double z =
                        inSpace ? low[c] + d*(j + 0.5)/nPoints : 0;
                    const double half =
                        std::sqrt(std::max(0.0, R*R - x*x - z*z));
                    const double length =
                        std::min(low[a] + d, half) - std::max(low[a], -half);
                    alpha[cell] += std::max(0.0, length)/d/nPoints
                       /(inSpace ? nPoints : 1);
                }
            }
            alpha[cell] = std::min(alpha[cell], 1.0);
            if (alpha[cell] > 1 - 1e-9)
            {
                alpha[cell] = 1;
            }
        }
    }

    double curvature() const
    {
        return (inSpace ? 2 : 1)/radius;
    }

    //- Greatest relative error of the curvature in cells that are cut
    double curvatureError() const
    {
        const heightCurvature kappa(grid, alpha);
        double worst = 0;
        for (int cell = 0; cell < grid.nCells(); ++cell)
        {
            if (alpha[cell] > 1e-3 && alpha[cell] < 1 - 1e-3)
            {
                EXPECT_TRUE(kappa.known(cell));
                worst = std::max
                (
                    worst, std::abs(kappa[cell]/curvature() - 1)
                );
            }
        }
        return worst;
    }

    //- After steps of the capillary time: relative error of the mean pressure
    //  of full cells, and capillary number of the greatest velocity
    std::array<double, 2> atRest(const int nSteps) const
    {
        meltFlow::controls c;
        meltFlow flow(grid, c);
        const double dt = 0.5*surfaceTension::capillaryTime(grid, sigma, rho);
        faceVelocities a;
        for (int step = 0; step < nSteps; ++step)
        {
            for (int b = 0; b < 3; ++b)
            {
                a[b].assign(grid.nFaces(b), 0);
            }
            surfaceTension::addAcceleration
            (
                grid, alpha, c.wetFrom, sigma, rho, a
            );
            const auto viscosity = [](const auto&, const auto&, auto& etas)
            {
                std::fill(etas.begin(), etas.end(), eta);
            };
            EXPECT_TRUE
            (
                flow.advance(alpha, rho, dt, a, {}, viscosity, false).solved
            );
        }
        double p = 0, u = 0;
        int n = 0;
        for (int cell = 0; cell < grid.nCells(); ++cell)
        {
            if (alpha[cell] == 1)
            {
                p += flow.p()[cell];
                ++n;
            }
        }
        for (const auto& component : flow.U())
        {
            for (const double value : component)
            {
                u = std::max(u, std::abs(value));
            }
        }
        return {std::abs(p/n/(sigma*curvature()) - 1), eta*u/sigma};
    }
};

const std::array<double, 3> centre{0.507, 0.493, 0.511};

} // End anonymous namespace


// Greatest error 3.4 % at 6 cells a radius and 0.6 % at 12: of second order
TEST(HeightCurvature, cylinder)
{
    const double coarse = drop(20, false, centre, 0.3).curvatureError();
    const double fine = drop(40, false, centre, 0.3).curvatureError();
    EXPECT_LT(coarse, 0.04);
    EXPECT_LT(fine, 0.01);
    EXPECT_GT(coarse/fine, 3);
}


// 1.2 % at 6 cells a radius, 4.9 % at 12: greatest on the diagonals of space, the
// places that are least good for columns
TEST(HeightCurvature, sphere)
{
    EXPECT_LT(drop(20, true, centre, 0.3).curvatureError(), 0.03);
    EXPECT_LT(drop(40, true, centre, 0.3).curvatureError(), 0.06);
}


// The surface meets walls at a right angle: a half and a quarter of a cylinder
TEST(HeightCurvature, mirroredAtWalls)
{
    EXPECT_LT(drop(32, false, {0.507, 0, 0}, 0.3).curvatureError(), 0.03);
    EXPECT_LT(drop(32, false, {1, 1, 0}, 0.3).curvatureError(), 0.03);
}


// A film has none, whatever its thickness
TEST(HeightCurvature, filmIsFlat)
{
    const staggeredGrid grid({6, 6, 1}, {0.1, 0.1, 0.1}, {true, true, false});
    for (const double thickness : {0.3, 1.7, 2.0})
    {
        std::vector<double> alpha(grid.nCells(), 0);
        for (int cell = 0; cell < grid.nCells(); ++cell)
        {
            alpha[cell] = std::min
            (
                1.0, std::max(0.0, thickness - grid.position(cell)[1])
            );
        }
        const heightCurvature kappa(grid, alpha);
        for (int cell = 0; cell < grid.nCells(); ++cell)
        {
            EXPECT_NEAR(kappa[cell], 0, 1e-9);
        }
    }
}


// The edges of a square along the grid, and a drop of one cell, have one between
// 1/dx and 4/dx, the sides none; that of a hole is the opposite
TEST(HeightCurvature, sharpEdges)
{
    const double dx = 0.1;
    const staggeredGrid grid({16, 16, 1}, {dx, dx, dx}, {true, true, false});
    for (const int n : {1, 8})
    {
        std::vector<double> alpha(grid.nCells(), 0), hole(grid.nCells(), 1);
        for (int i = 4; i < 4 + n; ++i)
        {
            for (int j = 4; j < 4 + n; ++j)
            {
                alpha[grid.cell({i, j, 0})] = 1;
                hole[grid.cell({i, j, 0})] = 0;
            }
        }
        const heightCurvature kappa(grid, alpha), opposite(grid, hole);
        const int last = 3 + n;
        for (const int i : {4, last})
        {
            for (const int j : {4, last})
            {
                const int edge = grid.cell({i, j, 0});
                EXPECT_GT(kappa[edge], 1/dx);
                EXPECT_LT(kappa[edge], 4/dx);
                EXPECT_NEAR(opposite[edge], -kappa[edge], 1e-9/dx);
            }
        }
        if (n > 1)
        {
            EXPECT_NEAR(kappa[grid.cell({last, 8, 0})], 0, 1e-9/dx);
            EXPECT_NEAR(kappa[grid.cell({8, 4, 0})], 0, 1e-9/dx);
        }
    }
}


// Pressure sigma/R to 1.5 % at 6 cells a radius, 0.34 % at 12; spurious currents
// of a capillary number of 4e-4 and 3e-5
TEST(SurfaceTension, cylinderAtRest)
{
    const auto coarse = drop(20, false, centre, 0.3).atRest(20);
    const auto fine = drop(40, false, centre, 0.3).atRest(20);
    EXPECT_LT(coarse[0], 0.02);
    EXPECT_LT(fine[0], 0.005);
    EXPECT_LT(coarse[1], 1e-3);
    EXPECT_LT(fine[1], 1e-4);
}


// Pressure 2 sigma/R to 1.5 % at 3.5 cells a radius, 1.1 % at 5.6; capillary
// numbers 0.03 and 4e-4
TEST(SurfaceTension, sphereAtRest)
{
    const auto coarse = drop(10, true, centre, 0.35).atRest(5);
    const auto fine = drop(16, true, centre, 0.35).atRest(5);
    EXPECT_LT(coarse[0], 0.02);
    EXPECT_LT(fine[0], 0.015);
    EXPECT_LT(coarse[1], 0.05);
    EXPECT_LT(fine[1], 1e-3);
}


TEST(SurfaceTension, capillaryTimeIsThatOfTheLeastEdge)
{
    const staggeredGrid grid
    (
        {2, 2, 1}, {0.2, 0.1, 0.01}, {true, true, false}
    );
    EXPECT_DOUBLE_EQ
    (
        surfaceTension::capillaryTime(grid, sigma, rho),
        std::sqrt(rho*1e-3/(2*M_PI*sigma))
    );
}
