/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleSurface.H"
#include "meltUnitTests.H"
#include "StringStream.H"

using namespace Foam;
using melt::particleSurface;

namespace
{

//- A block of n^3 particles with spacing 1, and one far away
struct block
{
    pointField positions;
    scalarField volumes;

    explicit block(const label n)
    :
        positions(n*n*n + 1),
        volumes(n*n*n + 1, scalar(1))
    {
        for (label i = 0; i < n*n*n; ++i)
        {
            positions[i] = point(i % n, i/n % n, i/n/n);
        }
        positions.last() = point(5*n, 0, 0);
    }
};

}

TEST(particleSurface, drawsTheBlockAndListsTheLonelyParticle)
{
    const block particles(8);
    const particleSurface surface
    (
        dictionary(), particles.positions, particles.volumes
    );
    EXPECT_EQ(surface.mesh().nBadEdges(), 0u);
    // Edges and corners are rounded
    EXPECT_NEAR(surface.mesh().volume()/512, 1, 0.08);
    EXPECT_EQ(surface.lonely(), labelList(1, 512));
    EXPECT_EQ(surface.points().size(), label(surface.mesh().nPoints()));
    EXPECT_EQ(surface.faces().size(), label(surface.mesh().nTriangles()));
}

TEST(particleSurface, normalsPointOutwards)
{
    const block particles(8);
    const particleSurface surface
    (
        dictionary(), particles.positions, particles.volumes
    );
    const pointField points(surface.points());
    const vectorField normals(surface.normals());
    ASSERT_GT(points.size(), 0);
    forAll(points, i)
    {
        EXPECT_NEAR(mag(normals[i]), 1, 1e-12);
        EXPECT_GT(normals[i] & (points[i] - point(3.5, 3.5, 3.5)), 0);
    }
}

TEST(particleSurface, interpolatesWithinTheParticlesRange)
{
    const block particles(8);
    const particleSurface surface
    (
        dictionary(), particles.positions, particles.volumes
    );
    const scalarField height(particles.positions.component(vector::Z));
    const scalarField values(surface.interpolate(height));
    const pointField points(surface.points());
    forAll(points, i)
    {
        EXPECT_GE(values[i], 0);
        EXPECT_LE(values[i], 7);
        EXPECT_NEAR(values[i], points[i].z(), 1.5);
    }
}

TEST(particleSurface, noParticlesNoSurface)
{
    const particleSurface surface{dictionary(), pointField(), scalarField()};
    EXPECT_EQ(surface.mesh().nTriangles(), 0u);
    EXPECT_TRUE(surface.lonely().empty());
}

TEST(particleSurface, refusesBadEntries)
{
    const block particles(2);
    for
    (
        const char* text :
        {"radius 0;", "voxel 0;", "voxel nan;", "level 1;", "shading 0;"}
    )
    {
        IStringStream is(text);
        const dictionary dict(is);
        EXPECT_THROW
        (
            particleSurface(dict, particles.positions, particles.volumes),
            Foam::IOerror
        ) << text;
    }
}
