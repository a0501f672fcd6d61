/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gravityRule.H"
#include "lubricationRule.H"
#include "meltVoxelAutomaton/voxelTestTools.H"

#include <gtest/gtest.h>

using namespace unitTest;

namespace
{

const double dx = 1e-3, g = 9.81, nu = 0.01;

//- Thickness of each column [voxels]
std::vector<double> thickness(const voxelGrid& grid)
{
    std::vector<double> h(grid.n()[0]*grid.n()[1], 0);
    for (int x = 0; x < grid.n()[0]; ++x)
    {
        for (int y = 0; y < grid.n()[1]; ++y)
        {
            for (int z = 0; z < grid.n()[2]; ++z)
            {
                h[x*grid.n()[1] + y] +=
                    double(grid.mass(x, y, z))/voxelMaterial::full;
            }
        }
    }
    return h;
}


//- What a drop that began as Huppert's profile, R0 voxels wide, has become
struct spread
{
    double radius, huppert, exponent, diagonalOverAxis;

    bool symmetric;
};


spread huppert(const double R0, const double h0, const double timeRatio)
{
    const int n = 2*int(1.2*R0*std::pow(timeRatio, 0.125)) + 8;
    voxelGrid grid({n, n, int(h0) + 4}, dx, wax(dx));
    double V = 0;
    for (int x = 0; x < n; ++x)
    {
        for (int y = 0; y < n; ++y)
        {
            const double r = std::hypot(x + 0.5 - 0.5*n, y + 0.5 - 0.5*n)/R0;
            const double h = r < 1 ? h0*std::cbrt(1 - r*r) : 0;
            V += h*dx*dx*dx;
            for (int z = 0; z < h; ++z)
            {
                grid.fill(x, y, z, std::min(1.0, h - z), 350);
            }
        }
    }
    grid.refresh();

    // Huppert 1982: r = 0.8939 (g V^3/(3 nu))^(1/8) t^(1/8)
    const double A = 0.8939138474*std::pow(g*V*V*V/(3*nu), 0.125);
    const double start = std::pow(R0*dx/A, 8);

    const filmViscosity film
    (
        [](double, double) { return 1000*nu; }, false, 250, 400, 1, 1e5, 0
    );
    lubricationRule lubrication(film, 1000*g, 100, 10);
    gravityRule gravity(film, g, 0.004);

    const auto radius = [&](const std::vector<double>& h, const double level)
    {
        double area = 0;
        for (const double hi : h)
        {
            area += hi > level;
        }
        return std::sqrt(area/M_PI);
    };
    const auto highest = [](const std::vector<double>& h)
    {
        return *std::max_element(h.begin(), h.end());
    };

    double t = start, first = 0, firstTime = 0;
    while (t < start*timeRatio)
    {
        const double dt = std::min
        (
            lubrication.prepare(grid), gravity.maxDeltaT(grid)
        );
        lubrication.spread(grid, dt);
        gravity.fall(grid, dt);
        t += dt;
        if (first == 0 && t > 2*start)
        {
            const std::vector<double> h(thickness(grid));
            first = radius(h, 1e-3*highest(h));
            firstTime = t;
        }
    }

    const std::vector<double> h(thickness(grid));
    const double level = 1e-3*highest(h);
    spread result;
    result.radius = radius(h, level);
    result.huppert = A*std::pow(t, 0.125)/dx;
    result.exponent = std::log(result.radius/first)/std::log(t/firstTime);

    // Where h, linear between the columns, falls below the level
    const auto reach = [&](const double direction)
    {
        double last = 0;
        for (double s = 0; s < 0.5*n - 1; s += 0.02)
        {
            const double x = 0.5*n + s*std::cos(direction) - 0.5;
            const double y = 0.5*n + s*std::sin(direction) - 0.5;
            const int i = int(x), j = int(y);
            const double u = x - i, v = y - j;
            const double value =
                (1 - u)*((1 - v)*h[i*n + j] + v*h[i*n + j + 1])
              + u*((1 - v)*h[(i + 1)*n + j] + v*h[(i + 1)*n + j + 1]);
            last = value > level ? s : last;
        }
        return last;
    };
    result.diagonalOverAxis = reach(M_PI/4)/reach(0);

    result.symmetric = true;
    for (int x = 0; x < n; ++x)
    {
        for (int y = 0; y < n; ++y)
        {
            result.symmetric =
                result.symmetric
             && h[x*n + y] == h[y*n + x]
             && h[x*n + y] == h[(n - 1 - x)*n + y];
        }
    }
    return result;
}

} // End anonymous namespace


//- Voxels that the drop has at the start
class LubricationRuleHuppert
:
    public ::testing::TestWithParam<int>
{};


TEST_P(LubricationRuleHuppert, spreadsAsHuppertSays)
{
    const double R0 = GetParam();
    const spread s = huppert(R0, 0.375*R0, 20);
    EXPECT_NEAR(s.radius/s.huppert, 1, 0.03);
    EXPECT_NEAR(s.exponent, 0.125, 0.01);
    EXPECT_NEAR(s.diagonalOverAxis, 1, 0.03);
    EXPECT_TRUE(s.symmetric);
    std::cout << "    " << R0 << " voxels: radius " << s.radius
        << ", Huppert " << s.huppert << ", exponent " << s.exponent
        << ", diagonal/axis " << s.diagonalOverAxis << '\n';
}

INSTANTIATE_TEST_SUITE_P
(
    resolutions, LubricationRuleHuppert, ::testing::Values(16, 20, 24)
);


// Half a dam break: at rest h dh/dx = -tauY/(rho g), so the front is where
// A = 2/3 sqrt(2 b) X^(3/2), b = tauY/(rho g)
TEST(LubricationRule, yieldStressStopsIt)
{
    const double b = 0.4e-3, A = 96e-6;
    const int n = 60;
    voxelGrid grid({n, 1, 12}, dx, wax(dx));
    for (int x = 0; x < 12; ++x)
    {
        for (int z = 0; z < 8; ++z)
        {
            grid.fill(x, 0, z, 1, 350);
        }
    }
    grid.refresh();
    const filmViscosity film
    (
        [](double, double) { return 1.0; }, false, 250, 400, 1, 1e5, b*1000*g
    );
    lubricationRule lubrication(film, 1000*g, 100, 10);
    gravityRule gravity(film, g, 0.004);
    for (int step = 0; step < 20000; ++step)
    {
        const double dt = std::min
        (
            lubrication.prepare(grid), gravity.maxDeltaT(grid)
        );
        lubrication.spread(grid, dt);
        gravity.fall(grid, dt);
    }
    const double X = std::pow(1.5*A, 2.0/3)/std::cbrt(2*b)/dx;
    const std::vector<double> h(thickness(grid));
    double front = 0;
    for (int x = 0; x < n; ++x)
    {
        front = h[x] > 1e-3*h[0] ? x + 1 : front;
    }
    EXPECT_NEAR(front/X, 1, 0.1);
    EXPECT_NEAR(h[0]/(std::sqrt(2*b*X*dx)/dx), 1, 0.1);
}


// A heap on a floor: at rest h^2 = 2 b (R - r), so that
// V = 8/15 pi sqrt(2 b) R^(5/2); round, though it flows along two axes
TEST(LubricationRule, yieldStressLeavesARoundHeap)
{
    const double b = 0.2e-3;
    const int n = 56, z1 = 10;
    voxelGrid grid({n, n, z1 + 2}, dx, wax(dx));
    double V = 0;
    for (int i = 0; i < n*n*z1; ++i)
    {
        const int x = i/(n*z1), y = i/z1 % n;
        if (std::hypot(x + 0.5 - 0.5*n, y + 0.5 - 0.5*n) < 9)
        {
            grid.fill(x, y, i % z1, 1, 350);
            V += dx*dx*dx;
        }
    }
    grid.refresh();
    const filmViscosity film
    (
        [](double, double) { return 1.0; }, false, 250, 400, 1, 1e5, b*1000*g
    );
    lubricationRule lubrication(film, 1000*g, 100, 10);
    gravityRule gravity(film, g, 0.004);
    for (int step = 0; step < 4000; ++step)
    {
        const double dt = std::min
        (
            lubrication.prepare(grid), gravity.maxDeltaT(grid)
        );
        lubrication.spread(grid, dt);
        gravity.fall(grid, dt);
    }
    const double R = std::pow(15*V/(8*M_PI*std::sqrt(2*b)), 0.4)/dx;
    const std::vector<double> h(thickness(grid));
    const auto reach = [&](const int dx, const int dy)
    {
        int steps = 0;
        for (int i = 0; i < n/2; ++i)
        {
            const bool wet = h[(n/2 + i*dx)*n + n/2 + i*dy] > 1e-2;
            steps = wet ? i + 1 : steps;
        }
        return steps*std::hypot(dx, dy);
    };
    std::cout << "    front " << reach(1, 0) << " along the axis, "
        << reach(1, 1) << " diagonally, Bingham heap " << R << '\n';
    EXPECT_NEAR(reach(1, 0)/R, 1, 0.1);
    EXPECT_NEAR(reach(1, 1)/R, 1, 0.1);
}


// A film under gravity on a wall carries q = g h^2 tau/(3 eta); the table must
// give eta_film of a power law: n/(2n + 1) for 1/3
TEST(FilmViscosity, isThatOfAPowerLawFilm)
{
    const double n = 0.5, K = 20, tau = 35;
    const filmViscosity film
    (
        [&](double rate, double) { return K*std::pow(rate, n - 1); },
        true, 250, 400, 1, 1e4, 0
    );
    // int_0^tau s (s/K)^(1/n) ds = tau^(2 + 1/n)/(K^(1/n) (2 + 1/n))
    const double fluidity =
        3/std::pow(tau, 3)*std::pow(tau, 2 + 1/n)/std::pow(K, 1/n)/(2 + 1/n);
    EXPECT_NEAR(film.fluidity(300, tau)/fluidity, 1, 1e-3);
}

// ************************************************************************* //
