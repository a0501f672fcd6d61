/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stokesSystem.H"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace Foam::melt;

namespace
{

const double rho = 1000, g = 9.81;

faceVelocities uniform(const staggeredGrid& grid, const int a, const double u)
{
    faceVelocities U;
    for (int b = 0; b < 3; ++b)
    {
        U[b].assign(grid.nFaces(b), a == b ? u : 0);
    }
    return U;
}


//- A block on the floor in the corner of a box, its surface within a cell
struct block
{
    const int n;

    staggeredGrid grid;

    std::vector<double> alpha;

    block(const int cells, const bool threeDimensional)
    :
        n(cells),
        grid
        (
            {n, n, threeDimensional ? n : 1},
            {0.3/n, 0.3/n, 0.3/n},
            {true, true, threeDimensional}
        ),
        alpha(grid.nCells(), 0)
    {
        for (int k = 0; k < (threeDimensional ? n/2 : 1); ++k)
        {
            for (int j = 0; j < n/2; ++j)
            {
                for (int i = 0; i < n/2; ++i)
                {
                    alpha[grid.cell({i, j, k})] = j == n/2 - 1 ? 0.4 : 1;
                }
            }
        }
    }

    //- Velocities after a step from rest, viscosities [Pa s] spread by a
    //  contrast
    faceVelocities step
    (
        const double D,
        const double contrast,
        const saddleSolver::controls& c
    ) const
    {
        const strainElements elements(grid, alpha, 1e-3);
        stokesSystem system(elements);
        system.setInertia
        (
            rho,
            D*std::pow(grid.d()[0], 2),
            uniform(grid, 1, 0),
            uniform(grid, 1, -g),
            {}
        );
        std::mt19937 random(1);
        std::vector<double> eta(elements.elements().size());
        for (double& e : eta)
        {
            e = rho*std::pow
            (
                contrast, std::uniform_real_distribution<>(0, 1)(random)
            );
        }
        saddleSolver solver(c);
        EXPECT_TRUE(system.solve(eta, solver));
        EXPECT_LT(system.maxDivergence(), 1e-7);
        faceVelocities U(uniform(grid, 0, 0));
        std::vector<double> p(grid.nCells());
        system.get(U, p);
        return U;
    }
};


saddleSolver::controls controls(const bool direct)
{
    saddleSolver::controls c;
    c.tolerance = 1e-9;
    c.directUnknowns = direct ? 1000000 : 0;
    return c;
}


double greatestDifference(const faceVelocities& A, const faceVelocities& B)
{
    double difference = 0, greatest = 0;
    for (int a = 0; a < 3; ++a)
    {
        for (std::size_t i = 0; i < A[a].size(); ++i)
        {
            difference = std::max(difference, std::abs(A[a][i] - B[a][i]));
            greatest = std::max(greatest, std::abs(A[a][i]));
        }
    }
    return difference/greatest;
}

} // End anonymous namespace


TEST(StokesSystem, poolAtRest)
{
    const staggeredGrid grid({4, 6, 1}, {0.1, 0.1, 0.1}, {true, true, false});
    std::vector<double> alpha(grid.nCells(), 0);
    for (int i = 0; i < 4; ++i)
    {
        for (int j = 0; j < 4; ++j)
        {
            alpha[grid.cell({i, j, 0})] = j == 3 ? 0.3 : 1;
        }
    }
    const strainElements elements(grid, alpha, 1e-3);
    stokesSystem system(elements);
    system.setInertia
    (
        rho, 1e3, uniform(grid, 1, 0), uniform(grid, 1, -g), {}
    );
    saddleSolver solver(controls(true));
    ASSERT_TRUE
    (
        system.solve(std::vector<double>(elements.elements().size(), 1), solver)
    );
    EXPECT_LT(system.u().lpNorm<Eigen::Infinity>(), 1e-10);

    faceVelocities U(uniform(grid, 0, 0));
    std::vector<double> p(grid.nCells());
    system.get(U, p);
    for (int j = 0; j < 4; ++j)
    {
        // A cell that is partly filled has the pressure of a half full one
        const double depth = j == 3 ? 0.05 : 0.33 - 0.1*(j + 0.5);
        EXPECT_NEAR(p[grid.cell({2, j, 0})], rho*g*depth, 1e-6*rho*g);
    }
}


TEST(StokesSystem, noStrainInRigidMotion)
{
    const block b(8, true);
    std::vector<double> alpha(b.grid.nCells(), 0);
    for (int i = 2; i < 6; ++i)
    {
        for (int j = 3; j < 5; ++j)
        {
            for (int k = 1; k < 7; ++k)
            {
                alpha[b.grid.cell({i, j, k})] = 1;
            }
        }
    }
    const strainElements elements(b.grid, alpha, 1e-3);
    const double d = b.grid.d()[0];
    std::vector<double> u(elements.nVelocities());
    staggeredGrid::triple c;
    const double omega[3] = {1, -2, 3};
    for (int a = 0; a < 3; ++a)
    {
        for (c[0] = 0; c[0] < 8; ++c[0])
        {
            for (c[1] = 0; c[1] < 8; ++c[1])
            {
                for (c[2] = 0; c[2] < 8; ++c[2])
                {
                    const int i = elements.velocity(a, b.grid.face(a, c));
                    const int b1 = (a + 1) % 3, b2 = (a + 2) % 3;
                    if (i >= 0)
                    {
                        u[i] = d
                           *(
                                omega[b1]*(c[b2] + 0.5)
                              - omega[b2]*(c[b1] + 0.5)
                            );
                    }
                }
            }
        }
    }
    for (const double rate : elements.shearRate(u.data()))
    {
        EXPECT_NEAR(rate, 0, 1e-12);
    }
}


class StokesSystemD
:
    public ::testing::TestWithParam<double>
{};


TEST_P(StokesSystemD, directAndIterative)
{
    for (const double contrast : {1.0, 1e6})
    {
        for (const bool threeDimensional : {false, true})
        {
            const block b(threeDimensional ? 8 : 24, threeDimensional);
            const faceVelocities U(b.step(GetParam(), contrast, controls(true)));
            EXPECT_GT(U[1][b.grid.face(1, {1, b.n/4, 0})]*-1, 0);
            EXPECT_LT
            (
                greatestDifference
                (
                    U, b.step(GetParam(), contrast, controls(false))
                ),
                2e-5
            );
        }
    }
}


INSTANTIATE_TEST_SUITE_P
(
    D,
    StokesSystemD,
    ::testing::Values(1e-3, 0.6, 6, 32, 128, 3e3, 6e6, 1e12)
);


// From D = 1e4 on the inertia is not felt: the velocity is that of the limit
TEST(StokesSystem, quasiStaticLimit)
{
    const block b(24, false);
    const faceVelocities limit(b.step(1e12, 1, controls(true)));
    for (const double D : {1e4, 1e6, 1e8})
    {
        EXPECT_LT
        (
            greatestDifference(limit, b.step(D, 1, controls(true))), 50/D
        );
    }
}


TEST(StokesSystem, failsWithItsHistory)
{
    const block b(8, false);
    const strainElements elements(b.grid, b.alpha, 1e-3);
    stokesSystem system(elements);
    system.setInertia
    (
        rho, 1, uniform(b.grid, 1, 0), uniform(b.grid, 1, -g), {}
    );
    saddleSolver solver(controls(true));
    EXPECT_FALSE
    (
        system.solve
        (
            std::vector<double>(elements.elements().size(), std::nan("")),
            solver
        )
    );
}
