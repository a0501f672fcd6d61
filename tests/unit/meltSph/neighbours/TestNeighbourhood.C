/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/neighbours/pointCloud.H"
#include "meltSph/particleCloud/particleCloud.H"
#include "meltUnitTests.H"

#include <cmath>
#include <set>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

//- Pairs target, source
std::set<std::pair<int, int>> pairs(const neighbourTable& table)
{
    std::set<std::pair<int, int>> all;
    for (int i = 0; i < int(table.size()); ++i)
    {
        for (const int j : table[i])
        {
            all.insert({i, j});
        }
    }
    return all;
}


std::set<std::pair<int, int>> fluidPairs(const particleCloud& cloud)
{
    return pairs(sorted(selfRows(cloud.near.fluid(), cloud.size())));
}

} // End anonymous namespace


TEST(Neighbourhood, pairsAreMutualAndWithoutSelf)
{
    for (const int nz : {1, 7})
    {
        particleCloud cloud(lattice{{12, 9, nz}, 0.01, kernelType::wendlandC2, 1.2, 0.3});
        const auto all = fluidPairs(cloud);
        ASSERT_FALSE(all.empty());
        for (const auto& [i, j] : all)
        {
            ASSERT_NE(i, j);
            ASSERT_TRUE(all.count({j, i}));
        }
    }
}


TEST(Neighbourhood, passesOverListsAreCounted)
{
    particleCloud cloud(lattice{{12, 9, 3}, 0.01, kernelType::wendlandC2, 1.2, 0.3});
    const std::uint64_t n = fluidPairs(cloud).size();
    EXPECT_EQ(cloud.near.pairVisits(), 0u);
    cloud.near.countPass(cloud.near.fluid());
    cloud.near.countPass(cloud.near.walls());
    EXPECT_EQ(cloud.near.pairVisits(), n);
}


TEST(Neighbourhood, listHoldsWithinHalfTheSkin)
{
    particleCloud cloud(lattice{{12, 10, 8}, 0.01, kernelType::wendlandC2, 1.2, 0.3});
    particles& f = cloud.fluid;
    const double support = cloud.near.kernel().support();
    const double skin = cloud.near.radius() - support;
    EXPECT_NEAR(skin, 0.1*support, 1e-12);
    const auto listed = fluidPairs(cloud);

    // Steps of various length, together half the skin
    const double share[] = {0.1, 0.55, 0.3499};
    for (const double s : share)
    {
        for (int i = 0; i < f.size(); ++i)
        {
            const double angle = cloud.random(0, 2*M_PI);
            const double way = 0.5*s*skin;
            f.x[i] += way*std::cos(angle);
            f.y[i] += way*std::sin(angle);
        }
        EXPECT_FALSE(cloud.near.outdated(0.5*s*skin));
    }
    for (int i = 0; i < f.size(); ++i)
    {
        for (int j = 0; j < f.size(); ++j)
        {
            const double r = std::hypot
            (
                f.x[i] - f.x[j], f.y[i] - f.y[j], f.z[i] - f.z[j]
            );
            if (i != j && r < support)
            {
                ASSERT_TRUE(listed.count({i, j}));
            }
        }
    }
    EXPECT_TRUE(cloud.near.outdated(0.01*skin));

    const auto nBuilds = cloud.near.nBuilds();
    cloud.build();
    EXPECT_EQ(cloud.near.nBuilds(), nBuilds + 1);
    EXPECT_FALSE(cloud.near.outdated(0.49*skin));
}


TEST(Neighbourhood, sortingKeepsTheParticlesTogether)
{
    particleCloud cloud(lattice{{9, 8, 7}, 0.01, kernelType::wendlandC2, 1.2, 0.3});
    particles& f = cloud.fluid;

    // Marks every array by what the particle is, then shuffles it
    std::vector<int> order(f.size());
    for (int i = 0; i < f.size(); ++i)
    {
        order[i] = (i*101 + 7) % f.size();
        f.T[i] = f.id[i];
        f.S[3][i] = f.x[i];
        f.u[i] = f.z[i];
    }
    f.permute(order);
    EXPECT_NE(f.id[0], 0);
    cloud.build();

    std::set<int> ids;
    for (int i = 0; i < f.size(); ++i)
    {
        ids.insert(f.id[i]);
        ASSERT_EQ(f.T[i], f.id[i]);
        ASSERT_EQ(f.S[3][i], f.x[i]);
        ASSERT_EQ(f.u[i], f.z[i]);
    }
    EXPECT_EQ(int(ids.size()), f.size());
}


TEST(Neighbourhood, wallsSeeWhatSeesThem)
{
    particleCloud cloud(lattice{{8, 7, 6}, 0.01, kernelType::wendlandC2, 1.2, 0.3});
    EXPECT_TRUE(cloud.near.walls().empty());
    EXPECT_EQ(cloud.near.walls().sourcesOf(5).size(), 0);

    cloud.addWall(2, false);
    cloud.addWall(0, true);
    const particles& f = cloud.fluid;
    wallState& walls = cloud.walls;
    for (std::size_t i = 0; i < walls.size(); ++i)
    {
        walls.wallV[i] = walls.x[i];
        walls.T[i] = walls.y[i];
        walls.face[i] = i;
        walls.slip[i] = walls.patch[i] == 1;
    }
    cloud.build();

    std::set<int> faces;
    for (std::size_t i = 0; i < walls.size(); ++i)
    {
        faces.insert(walls.face[i]);
        ASSERT_EQ(walls.wallV[i], walls.x[i]);
        ASSERT_EQ(walls.T[i], walls.y[i]);
        ASSERT_EQ(bool(walls.slip[i]), walls.patch[i] == 1);
        ASSERT_EQ(walls.nx[i], walls.patch[i] == 1 ? -1 : 0);
        ASSERT_EQ(walls.nz[i], walls.patch[i] == 1 ? 0 : 1);
    }
    EXPECT_EQ(faces.size(), walls.size());

    const auto ofFluid = pairs(sourceRows(cloud.near.walls(), f.size()));
    const auto ofWalls =
        pairs(sourceRows(cloud.near.fluidOfWalls(), walls.size()));
    std::size_t nNear = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        for (int j = 0; j < int(walls.size()); ++j)
        {
            const bool isNear = cloud.near.radius() > std::hypot
            (
                f.x[i] - walls.x[j], f.y[i] - walls.y[j], f.z[i] - walls.z[j]
            );
            nNear += isNear;
            ASSERT_EQ(isNear, ofFluid.count({i, j}) == 1);
            ASSERT_EQ(isNear, ofWalls.count({j, i}) == 1);
        }
    }
    EXPECT_EQ(ofFluid.size(), nNear);
    EXPECT_GT(nNear, 1000u);
}

// ************************************************************************* //
