/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coarseLevel.H"
#include "meltSph/particleCloud/cloudVectors.H"
#include "meltSph/timeStep/schemeCase.H"
#include "particles.H"

#include <gtest/gtest.h>

namespace Foam
{
namespace melt
{
namespace unitTest
{
namespace
{

constexpr double cellSize = 0.037;

particleCloud lump(const unsigned seed)
{
    return particleCloud
    (
        lattice
        {
            {9, 8, 7}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3, 0.2
        },
        seed
    );
}


particleCloud periodicLump(const unsigned seed)
{
    return particleCloud
    (
        lattice
        {
            {9, 8, 10}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3, 0.2,
            {true, false, true}
        },
        seed
    );
}


//- Of viscosities over eight decades and a stiff pressure
struct levelCase
{
    schemeCase scheme;
    std::vector<double> eta, stiffness;
    implicitParts parts;
    coarseLevel level;

    explicit levelCase(particleCloud& cloud)
    :
        scheme(cloud, springAndDamper(1, 0)),
        eta(cloud.size()),
        stiffness(cloud.size(), 50)
    {
        scheme.system.near = cloud.near;
        scheme.system.fluid = cloud.fluid;
        for (double& e : eta)
        {
            e = std::pow(10.0, cloud.random(-2, 6));
        }
        parts.eta = &eta;
        parts.stiffness = &stiffness;
        EXPECT_TRUE
        (
            level.build(scheme.system, parts, 1e-2, cellSize)
        );
    }

    vectorArray correct(const vectorArray& r)
    {
        vectorArray z(r.size());
        level.addCorrection(r, z);
        return z;
    }
};

} // End anonymous namespace


TEST(TrilinearGrid, functionsAddUpToOneAndEachParticleHasOneCell)
{
    particleCloud cloud(lump(1));
    const particles& f = cloud.fluid;
    trilinearGrid grid;
    grid.build(f, cellSize);

    int nMembers = 0;
    std::vector<int> visits(f.size(), 0);
    for (int cell = 0; cell < grid.nCells(); ++cell)
    {
        grid.forMembers(f, cell, [&](const int i, const trilinearGrid::shape& s)
        {
            ++nMembers;
            ++visits[i];
            double sum = 0;
            double slope[3] = {};
            for (int c = 0; c < trilinearGrid::nCorners; ++c)
            {
                EXPECT_GE(s.N[c], 0);
                sum += s.N[c];
                for (int d = 0; d < 3; ++d)
                {
                    slope[d] += s.gradient[c][d];
                }
            }
            EXPECT_NEAR(sum, 1, 1e-14);
            for (int d = 0; d < 3; ++d)
            {
                EXPECT_NEAR(slope[d]*cellSize, 0, 1e-13);
            }
        });
    }
    EXPECT_EQ(nMembers, f.size());
    EXPECT_EQ(*std::min_element(visits.begin(), visits.end()), 1);
}


TEST(TrilinearGrid, transfersAreTransposesOfEachOther)
{
    particleCloud cloud(lump(2));
    trilinearGrid grid;
    grid.build(cloud.fluid, cellSize);

    const vectorArray r(randomVelocity(cloud));
    std::vector<double> nodes(3*grid.nNodes()), restricted(nodes.size());
    cloud.randomise(nodes, -1, 1);
    vectorArray prolonged(cloud.size());
    grid.addProlonged(cloud.fluid, nodes.data(), prolonged);
    grid.restrict(cloud.fluid, r, restricted.data());

    double product = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
        product += nodes[k]*restricted[k];
    }
    EXPECT_NEAR(product, dot(prolonged, r), 1e-12*norm(prolonged)*norm(r));
}


// Three cells of 0.03 m along x, and the particles where they are as well as a
// period away
TEST(TrilinearGrid, goesOnAcrossPeriods)
{
    particleCloud cloud(periodicLump(5));
    const periodicBox& box = cloud.near.box();
    particles moved(cloud.fluid);
    for (int i = 0; i < moved.size(); ++i)
    {
        moved.x[i] += (i%3 - 1)*box.period(0);
    }
    trilinearGrid grid, other;
    grid.build(cloud.fluid, cellSize, box);
    other.build(moved, cellSize, box);
    EXPECT_EQ(grid.nCells(), 3*3*3);
    EXPECT_EQ(grid.nNodes(), 3*4*3);
    ASSERT_EQ(other.nNodes(), grid.nNodes());

    std::vector<double> nodes(3*grid.nNodes());
    cloud.randomise(nodes, -1, 1);
    vectorArray a(cloud.size()), b(cloud.size());
    grid.addProlonged(cloud.fluid, nodes.data(), a);
    other.addProlonged(moved, nodes.data(), b);
    const double size = norm(a);
    b.add(-1, a);
    EXPECT_LT(norm(b), 1e-13*size);

    // Two particles on both sides of the seam have nearly the same value
    particles& f = cloud.fluid;
    f.x[0] = box.lowest(0) + 1e-9;
    f.x[1] = box.lowest(0) + box.period(0) - 1e-9;
    f.y[1] = f.y[0];
    f.z[1] = f.z[0];
    grid.build(f, cellSize, box);
    a.zero();
    grid.addProlonged(f, nodes.data(), a);
    EXPECT_NEAR(a.x[0], a.x[1], 1e-6);
    EXPECT_NEAR(a.z[0], a.z[1], 1e-6);
}


// Moves as one whatever the viscosities, in each direction
TEST(CoarseLevel, movesPeriodicMeltAsOne)
{
    particleCloud cloud(periodicLump(6));
    levelCase test(cloud);
    const particles& f = test.scheme.system.fluid;
    vectorArray v(f.size()), r(f.size());
    for (int i = 0; i < f.size(); ++i)
    {
        v.x[i] = 0.3;
        v.y[i] = -0.2;
        v.z[i] = 0.5;
        r.x[i] = f.m[i]*v.x[i];
        r.y[i] = f.m[i]*v.y[i];
        r.z[i] = f.m[i]*v.z[i];
    }
    vectorArray error(test.correct(r));
    error.add(-1, v);
    EXPECT_LT(norm(error), 1e-4*norm(v));
}


// A free body of any viscosities: the impulse of a rigid motion gives that
// motion, to round-off of the ratio of the viscosities
TEST(CoarseLevel, solvesRigidMotionsExactly)
{
    particleCloud cloud(lump(3));
    levelCase test(cloud);
    const particles& f = test.scheme.system.fluid;
    const double U[3] = {0.3, -0.2, 0.5}, omega[3] = {2, -1, 3};

    vectorArray v(f.size()), r(f.size());
    for (int i = 0; i < f.size(); ++i)
    {
        v.x[i] = U[0] + omega[1]*f.z[i] - omega[2]*f.y[i];
        v.y[i] = U[1] + omega[2]*f.x[i] - omega[0]*f.z[i];
        v.z[i] = U[2] + omega[0]*f.y[i] - omega[1]*f.x[i];
        r.x[i] = f.m[i]*v.x[i];
        r.y[i] = f.m[i]*v.y[i];
        r.z[i] = f.m[i]*v.z[i];
    }
    vectorArray error(test.correct(r));
    error.add(-1, v);
    EXPECT_LT(norm(error), 1e-4*norm(v));
}


TEST(CoarseLevel, isSymmetricAndPositive)
{
    particleCloud cloud(lump(4));
    levelCase test(cloud);
    for (int repeat = 0; repeat < 5; ++repeat)
    {
        const vectorArray a(randomVelocity(cloud));
        const vectorArray b(randomVelocity(cloud));
        const vectorArray za(test.correct(a));
        const vectorArray zb(test.correct(b));
        EXPECT_NEAR(dot(a, zb), dot(b, za), 1e-9*norm(a)*norm(zb));
        EXPECT_GT(dot(a, za), 0);
    }
}


// Particles fewer than the functions of their cell
TEST(CoarseLevel, takesSingleParticles)
{
    particleCloud cloud(lattice{{2, 1, 1}, 0.05});
    levelCase test(cloud);
    const vectorArray z(test.correct(randomVelocity(cloud)));
    EXPECT_TRUE(std::isfinite(norm(z)));
}

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
