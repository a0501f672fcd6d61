/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeMoment.H"
#include "pressureCase.H"
#include "surfaceCorrection.H"

#include <gtest/gtest.h>

#include <algorithm>

namespace Foam
{
namespace melt
{
namespace unitTest
{

// Melt at rest under its own weight: the floor carries its lowest layer as the
// melt below carries the others
TEST(PressureAtWalls, floorCarriesTheWeight)
{
    const smoothingKernel::kernelType kernel =
        smoothingKernel::kernelType::wendlandC2;
    particleCloud cloud(lattice{{9, 9, 9}, 0.01, kernel, 1.3});
    cloud.addWall(1, false);
    cloud.build();

    pressureCase test(cloud, 0);
    sphSystem& s = test.scheme.system;
    particles& f = s.fluid;
    s.g = {0, -10, 0};
    const double rho0 = s.thermo.rho();
    for (int i = 0; i < f.size(); ++i)
    {
        f.rho[i] = rho0*(1 + 10*(0.09 - f.y[i])/400);
        f.V[i] = f.m[i]/f.rho[i];
    }
    test.pressure.update(0);

    const vectorArray force(test.force(vectorArray(f.size()), 1));
    for (int i = 0; i < f.size(); ++i)
    {
        if (std::abs(f.x[i] - 0.045) < 1e-6 && std::abs(f.z[i] - 0.045) < 1e-6
         && f.y[i] < 0.05)
        {
            EXPECT_NEAR(force.y[i]/(10*f.m[i]), 1, 0.03) << f.y[i];
        }
    }
}


// Side walls of a pool carry a part of it, but none of what falls
TEST(PressureAtWalls, wallsDoNotHoldUpWhatFalls)
{
    particleCloud cloud(densityLump(8));
    cloud.addWall(0, false);
    cloud.build();
    const int n = cloud.size();
    const vectorArray still(n);

    const auto forceOf = [&](const double g, const double acceleration)
    {
        pressureCase test(cloud, 0);
        particles& f = test.scheme.system.fluid;
        test.scheme.system.g = {0, g, 0};
        f.axOld.assign(n, 0);
        f.ayOld.assign(n, acceleration);
        f.azOld.assign(n, 0);
        test.pressure.update(0);
        return test.force(still, 1);
    };
    const auto change = [&](const double acceleration)
    {
        vectorArray difference(forceOf(-10, acceleration));
        // Not 0: the correction at side walls is by the direction of gravity
        difference.add(-1, forceOf(-1e-12, 0));
        return norm(difference);
    };

    const double atRest = change(0);
    EXPECT_GT(atRest, 0);
    EXPECT_NEAR(change(-5)/atRest, 0.5, 1e-3);
    EXPECT_NEAR(change(-10)/atRest, 0, 1e-9);
    EXPECT_NEAR(change(-20)/atRest, 0, 1e-9);
    EXPECT_EQ(change(5), atRest);
}


// So does a solid, which takes up what it gives
TEST(PressureAtWalls, solidCarriesTheWeight)
{
    const smoothingKernel::kernelType kernel =
        smoothingKernel::kernelType::wendlandC2;
    particleCloud cloud(lattice{{9, 12, 9}, 0.01, kernel, 1.3});

    pressureCase test(cloud, 0);
    sphSystem& s = test.scheme.system;
    particles& f = s.fluid;
    s.g = {0, -10, 0};
    const double rho0 = s.thermo.rho();
    f.body.resize(f.size());
    s.solid.resize(f.size());
    for (int i = 0; i < f.size(); ++i)
    {
        s.solid[i] = f.y[i] < 0.03;
        f.body[i] = s.solid[i] ? 0 : -1;
        f.rho[i] = rho0*(s.solid[i] ? 1 : 1 + 10*(0.12 - f.y[i])/400);
        f.V[i] = f.m[i]/f.rho[i];
    }
    s.near.setSolids(f.body);
    test.pressure.update(0);

    const vectorArray force(test.force(vectorArray(f.size()), 1));
    double sum = 0, largest = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        sum += force.y[i];
        largest = std::max(largest, std::abs(force.y[i]));
        if (std::abs(f.x[i] - 0.045) < 1e-6 && std::abs(f.z[i] - 0.045) < 1e-6
         && f.y[i] > 0.03 && f.y[i] < 0.08)
        {
            EXPECT_NEAR(force.y[i]/(10*f.m[i]), 1, 0.03) << f.y[i];
        }
    }
    EXPECT_NEAR(sum, 0, 1e-12*largest*f.size());
}


// A wall does not pull, but melt under tension that comes nearer to it is
// compressed as melt under pressure is
TEST(PressureAtWalls, comesNearUnderTension)
{
    particleCloud cloud(densityLump(8));
    cloud.addWall(1, false);
    cloud.build();
    const int n = cloud.size();

    // Of a lump that moves across the wall as one
    const auto lowestDivergence = [&](const double share, const double speed)
    {
        pressureCase test(cloud, 0);
        particles& f = test.scheme.system.fluid;
        f.rho.assign(n, share*test.scheme.system.thermo.rho());
        f.u = f.w = std::vector<double>(n, 0);
        f.v.assign(n, speed);
        test.pressure.update(0);
        std::vector<double> divergence(n);
        test.pressure.divergence(divergence);
        const int lowest = int
        (
            std::min_element(f.y.begin(), f.y.end()) - f.y.begin()
        );
        return divergence[lowest]/test.support(lowest);
    };

    const double pressed = lowestDivergence(1.01, -1);
    EXPECT_LT(pressed, -0.1);
    EXPECT_NEAR(lowestDivergence(0.99, -1), pressed, 1e-9*std::abs(pressed));
    EXPECT_NEAR(lowestDivergence(1.01, 1), -pressed, 1e-9*std::abs(pressed));
    EXPECT_NEAR(lowestDivergence(0.99, 1), 0, 1e-9*std::abs(pressed));
}


// Melt slides along walls as if their particles were a smooth layer
TEST(PressureAtWalls, slidingIsNoStrain)
{
    const smoothingKernel::kernelType kernel =
        smoothingKernel::kernelType::wendlandC2;
    particleCloud cloud(lattice{{9, 9, 9}, 0.01, kernel, 1.2, 0.3});
    cloud.addWall(0, false);
    cloud.addWall(1, false);
    cloud.build();
    pressureCase test(cloud, 0);
    particles& f = test.scheme.system.fluid;
    const int n = f.size();
    std::vector<double> divergence(n);

    f.u = f.v = std::vector<double>(n, 0);
    f.w = std::vector<double>(n, 1);
    test.pressure.divergence(divergence);
    for (const double each : divergence)
    {
        ASSERT_NEAR(each, 0, 1e-10);
    }

    // With the walls
    wallState& walls = test.scheme.system.walls;
    walls.wallU.assign(walls.size(), 1);
    walls.wallW.assign(walls.size(), 3);
    f.u = f.w;
    f.w.assign(n, 2);
    test.pressure.update(0);
    test.pressure.divergence(divergence);
    for (const double each : divergence)
    {
        ASSERT_NEAR(each, 0, 1e-10);
    }

    walls.wallU.assign(walls.size(), 0);
    test.pressure.update(0);
    test.pressure.divergence(divergence);
    EXPECT_GT(*std::max_element(divergence.begin(), divergence.end()), 10);
}


// Of a strain along a wall a particle beside it feels as much as one far away;
// of one towards it the row at the wall a fifth more
TEST(PressureAtWalls, strainAtAWall)
{
    const smoothingKernel::kernelType kernel =
        smoothingKernel::kernelType::wendlandC2;
    particleCloud cloud(lattice{{9, 9, 9}, 0.01, kernel, 1.2});
    cloud.addWall(1, false);
    cloud.build();
    pressureCase test(cloud, 0);
    particles& f = test.scheme.system.fluid;
    const int n = f.size();
    const vectorArray zero(n);

    std::vector<double> along(n), towards(n);
    f.u = f.x;
    f.v = zero.y;
    f.w = zero.z;
    test.pressure.divergence(along);
    f.u = zero.x;
    f.v = f.y;
    test.pressure.divergence(towards);

    for (int i = 0; i < n; ++i)
    {
        if (std::abs(f.x[i] - 0.045) < 1e-6 && std::abs(f.z[i] - 0.045) < 1e-6
         && f.y[i] < 0.05)
        {
            EXPECT_NEAR(along[i], 1, 0.01) << f.y[i];
            EXPECT_NEAR(towards[i], f.y[i] < 0.01 ? 1.22 : 1, 0.02)
                << f.y[i];
        }
    }
}


// How far the correction of the particle at x, y and the middle of z, of a block of
// so many layers on a floor, is from that of a lattice
scalar correctionAt
(
    const int layers,
    const scalar x,
    const scalar y,
    const std::array<double, 3>& g
)
{
    const smoothingKernel::kernelType kernel =
        smoothingKernel::kernelType::wendlandC2;
    particleCloud cloud(lattice{{9, layers, 9}, 0.01, kernel, 1.2});
    cloud.addWall(1, false);
    cloud.build();
    pressureCase test(cloud, 0);
    sphSystem& s = test.scheme.system;
    s.g = g;
    symmetricArrays A;
    surfaceCorrection(s, 8, A);

    const double onLattice = 1/latticeMoment(s.near.kernel(), s.spacing);
    const particles& f = s.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        if (std::abs(f.x[i] - x) < 1e-6 && std::abs(f.y[i] - y) < 1e-6
         && std::abs(f.z[i] - 0.045) < 1e-6)
        {
            scalar furthest = 0;
            for (const int a : {0, 3, 5})
            {
                furthest = std::max(furthest, std::abs(A[a][i] - onLattice));
            }
            return furthest;
        }
    }
    ADD_FAILURE() << "no particle at " << x << ' ' << y;
    return 0;
}


// Rates that surfaces correct are those of no function of the positions: not so
// where a surface meets a wall that carries weight along it
TEST(PressureAtWalls, noCorrectionWhereASurfaceMeetsASideWall)
{
    const std::array<double, 3> onFloor{0, -10, 0}, alongWall{-10, 0, 0};
    const scalar ofFace = correctionAt(9, 0.005, 0.045, onFloor);
    EXPECT_GT(ofFace, 0.1);
    EXPECT_GT(correctionAt(9, 0.005, 0.005, onFloor), 0.5*ofFace);
    EXPECT_LT(correctionAt(9, 0.005, 0.005, alongWall), 0.3*ofFace);
    // A film on a wall has it
    EXPECT_GT(correctionAt(1, 0.045, 0.005, alongWall), 0.5*ofFace);
}

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
