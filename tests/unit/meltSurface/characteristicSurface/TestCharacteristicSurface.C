/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "characteristicSurface.H"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

using namespace Foam::melt;

namespace
{

const double spacing = 0.1;
const double spacing3 = spacing*spacing*spacing;

//- Particles on a lattice inside a sphere
std::vector<double> ball(const double radius)
{
    std::vector<double> x;
    const int n = int(radius/spacing) + 1;
    for (int i = -n; i < n; ++i)
    {
        for (int j = -n; j < n; ++j)
        {
            for (int k = -n; k < n; ++k)
            {
                const double a = (i + 0.5)*spacing;
                const double b = (j + 0.5)*spacing;
                const double c = (k + 0.5)*spacing;
                if (a*a + b*b + c*c < radius*radius)
                {
                    x.insert(x.end(), {a, b, c});
                }
            }
        }
    }
    return x;
}

triangleMesh surface(const std::vector<double>& x)
{
    const std::vector<double> volume(x.size()/3, spacing3);
    return characteristicSurface
    (
        volume.size(), x.data(), volume.data(), 3*spacing, spacing/2, 0.5
    );
}

}

TEST(characteristicSurface, ballEnclosesItsParticlesVolume)
{
    const std::vector<double> x = ball(1);
    const triangleMesh mesh = surface(x);
    EXPECT_EQ(mesh.nBadEdges(), 0u);
    // Radius of 10 spacings: within 3 % of the particles' volume
    EXPECT_NEAR(mesh.volume()/(x.size()/3*spacing3), 1, 0.03);
}

TEST(characteristicSurface, ballIsRound)
{
    const triangleMesh mesh = surface(ball(1));
    ASSERT_GT(mesh.nPoints(), 0u);
    for (std::size_t i = 0; i < mesh.nPoints(); ++i)
    {
        const double* p = &mesh.points[3*i];
        const double r = std::sqrt(p[0]*p[0] + p[1]*p[1] + p[2]*p[2]);
        EXPECT_NEAR(r, 1, spacing/2);
    }
}

TEST(characteristicSurface, volumeErrorFallsWithTheSize)
{
    double lastError = 1;
    for (const double radius : {0.4, 0.8, 1.2})
    {
        const std::vector<double> x = ball(radius);
        const double error =
            std::abs(surface(x).volume()/(x.size()/3*spacing3) - 1);
        EXPECT_LT(error, lastError);
        lastError = error;
    }
}

TEST(characteristicSurface, twoBallsGiveTwoClosedPieces)
{
    std::vector<double> x = ball(0.5);
    const std::size_t n = x.size();
    const double one = surface(x).volume();
    for (std::size_t i = 0; i < n; ++i)
    {
        x.push_back(x[i] + (i % 3 == 0 ? 2 : 0));
    }
    const triangleMesh mesh = surface(x);
    EXPECT_EQ(mesh.nBadEdges(), 0u);
    EXPECT_NEAR(mesh.volume(), 2*one, 1e-5*one);
}

TEST(characteristicSurface, noParticlesNoSurface)
{
    EXPECT_EQ(surface({}).nTriangles(), 0u);
}

TEST(characteristicSurface, refusesBadArguments)
{
    const double x[3] = {0, 0, 0};
    const double v = 1;
    EXPECT_THROW(characteristicSurface(1, x, &v, 1, 0, 1), std::invalid_argument);
    EXPECT_THROW(characteristicSurface(1, x, &v, 1, 2, 1), std::invalid_argument);
    EXPECT_THROW(characteristicSurface(1, x, &v, 1, 1, 0), std::invalid_argument);
}
