/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidCase.H"
#include "solidGroups.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

const double distance = 0.013;

//- By looking at every pair until nothing changes
std::vector<int> expected(const particles& f)
{
    const int n = f.size();
    std::vector<int> body(n, -1);
    for (int i = 0; i < n; ++i)
    {
        body[i] = f.h[i] <= 0 ? f.id[i] : -1;
    }
    for (bool changed = true; changed; )
    {
        changed = false;
        for (int i = 0; i < n; ++i)
        {
            for (int j = 0; j < n; ++j)
            {
                const bool bonded =
                    body[i] >= 0 && body[j] >= 0
                 && std::hypot
                    (
                        f.x[i] - f.x[j], f.y[i] - f.y[j], f.z[i] - f.z[j]
                    ) < distance
                 && (
                        f.body[i] == f.body[j]
                     || f.body[i] < 0 || f.body[j] < 0
                    );
                if (bonded && body[j] < body[i])
                {
                    body[i] = body[j];
                    changed = true;
                }
            }
        }
    }
    return body;
}

} // End anonymous namespace


TEST(SolidGroups, areThoseOfBruteForceThroughRandomChanges)
{
    for (unsigned seed = 1; seed <= 6; ++seed)
    {
        particleCloud cloud(movingLump(seed));
        particles& f = cloud.fluid;
        f.body.assign(f.size(), -1);

        for (const double solid : {0.25, 0.35, 0.3, 0.5, 0.2})
        {
            // A third of them is decided anew
            for (double& h : f.h)
            {
                if (cloud.random(0, 1) < 0.33)
                {
                    h = cloud.random(0, 1) < solid ? -1 : 1;
                }
            }
            const std::vector<int> exact(expected(f));
            EXPECT_TRUE(groupSolids(cloud.near, distance, f));
            EXPECT_EQ(f.body, exact) << seed;
        }
    }
}


TEST(SolidGroups, nothingIsDoneWhereNothingChanges)
{
    particleCloud cloud(movingLump(3));
    particles& f = cloud.fluid;
    f.h.assign(f.size(), -1);
    f.body.assign(f.size(), -1);
    EXPECT_TRUE(groupSolids(cloud.near, distance, f));
    EXPECT_FALSE(groupSolids(cloud.near, distance, f));
    f.h[7] = 1;
    EXPECT_TRUE(groupSolids(cloud.near, distance, f));
    EXPECT_EQ(f.body[7], -1);
}


// Two that touch stay two, until what lies between them freezes
TEST(SolidGroups, touchingIsNoBond)
{
    particleCloud cloud
    (
        lattice{{9, 3, 3}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3, 0}
    );
    particles& f = cloud.fluid;
    f.body.resize(f.size());
    for (int i = 0; i < f.size(); ++i)
    {
        f.h[i] = -1;
        f.body[i] = f.x[i] < 0.04 ? 1000 : 2000;
    }
    const int changes = int
    (
        std::find_if
        (
            f.x.begin(), f.x.end(), [](const double x) { return x > 0.08; }
        ) - f.x.begin()
    );
    f.h[changes] = 1;
    groupSolids(cloud.near, distance, f);
    const auto bodies = [&]()
    {
        std::set<int> names(f.body.begin(), f.body.end());
        names.erase(-1);
        return names.size();
    };
    EXPECT_EQ(bodies(), 2u);

    for (int i = 0; i < f.size(); ++i)
    {
        f.body[i] = f.x[i] > 0.035 && f.x[i] < 0.05 ? -1 : f.body[i];
    }
    groupSolids(cloud.near, distance, f);
    EXPECT_EQ(bodies(), 1u);
}

// ************************************************************************* //
