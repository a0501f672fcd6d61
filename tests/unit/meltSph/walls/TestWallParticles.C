/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallParticleChecks.H"
#include "HashSet.H"
#include "SubField.H"
#include "transform.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

// Sum of V W over the unbounded lattice, at one of its points
scalar fullSum(const scalar dx)
{
    scalar sum = 0;
    for (label k = -4; k <= 4; ++k)
    for (label j = -4; j <= 4; ++j)
    for (label i = -4; i <= 4; ++i)
    {
        sum += kernelVolume(Zero, dx*vector(i, j, k), pow3(dx), dx);
    }
    return sum;
}


// Sum of V W at the corner particle of a lattice that fills, from the origin,
// a box of three or more particles along each side
scalar cornerSum(const wallParticles& w, const scalar dx)
{
    const point p(dx/2, dx/2, dx/2);
    scalar sum = wallSum(w, p, dx);

    for (label k = 0; k < 3; ++k)
    for (label j = 0; j < 3; ++j)
    for (label i = 0; i < 3; ++i)
    {
        sum += kernelVolume(p, p + dx*vector(i, j, k), pow3(dx), dx);
    }

    return sum;
}


// Lattice sites around n[0] x n[1] x n[2] cells that are nearer than the
// support radius; none above them if they are open at the top
std::size_t sitesAround(const labelVector& n, const bool open = false)
{
    std::size_t count = 0;
    for (label k = -3; k < n.z() + (open ? 0 : 3); ++k)
    for (label j = -3; j < n.y() + 3; ++j)
    for (label i = -3; i < n.x() + 3; ++i)
    {
        const vector p(i + 0.5, j + 0.5, k + 0.5);
        const vector size(n.x(), n.y(), n.z());
        const vector nearest(min(max(p, vector::zero), size));
        const scalar distance = mag(p - nearest);
        count += distance > 0 && distance < support;
    }
    return count;
}

} // End anonymous namespace


TEST(WallParticles, alignedBoxIsTheLattice)
{
    const scalar dx = 0.01;
    const autoPtr<polyMesh> mesh
    (
        boxMesh(labelVector(3, 2, 4), vector(0.1, 0.08, 0.12))
    );
    const wallParticles w(particlesOf(mesh(), dx));

    EXPECT_EQ(w.size(), sitesAround(labelVector(10, 8, 12)));
    expectDepthsInLayers(w, dx, 1e-14);
    expectOutsideAndApart(mesh(), w, 0.999*dx);

    for (std::size_t i = 0; i < w.size(); ++i)
    {
        for (const scalar c : {w.x[i], w.y[i], w.z[i]})
        {
            EXPECT_NEAR(c/dx - 0.5, std::round(c/dx - 0.5), 1e-11);
        }
        EXPECT_NEAR(w.volume[i], pow3(dx), 1e-12*pow3(dx));
    }

    EXPECT_NEAR(cornerSum(w, dx), fullSum(dx), 1e-12);
}


TEST(WallParticles, boxThatSpacingDoesNotDivide)
{
    const scalar dx = 0.01;
    const autoPtr<polyMesh> mesh
    (
        boxMesh(labelVector(3, 2, 4), vector(0.1037, 0.0829, 0.1262))
    );
    const wallParticles w(particlesOf(mesh(), dx));

    // As many as around the box that it divides next: 10 x 8 x 13
    EXPECT_EQ(w.size(), sitesAround(labelVector(10, 8, 13)));
    expectDepthsInLayers(w, dx, 1e-14);
    expectOutsideAndApart(mesh(), w, 0.9*dx);

    EXPECT_NEAR(cornerSum(w, dx), fullSum(dx), 0.01*fullSum(dx));
}


TEST(WallParticles, turnedBoxIsTheTurnedLattice)
{
    const scalar dx = 0.01;
    const tensor R(rotationTensor(vector(1, 0, 0), normalised(vector(1, 2, 3))));
    const vector size(0.1037, 0.0829, 0.1262);
    const autoPtr<polyMesh> mesh
    (
        hexMesh
        (
            labelVector(3, 2, 4),
            [&](const point& p) { return R & point(cmptMultiply(p, size)); }
        )
    );
    const wallParticles w(particlesOf(mesh(), dx));

    EXPECT_EQ(w.size(), sitesAround(labelVector(10, 8, 13)));
    expectDepthsInLayers(w, dx, 1e-12);
    expectOutsideAndApart(mesh(), w, 0.9*dx);
}


TEST(WallParticles, patchAndFaceAreThoseOfTheFoot)
{
    const scalar dx = 0.01;
    const autoPtr<polyMesh> mesh
    (
        boxMesh(labelVector(2, 2, 2), vector(0.1, 0.1, 0.1))
    );
    const wallParticles w(particlesOf(mesh(), dx));

    for (std::size_t i = 0; i < w.size(); ++i)
    {
        const polyPatch& patch = mesh->boundaryMesh()[w.patch[i]];
        ASSERT_LT(w.face[i], patch.size());

        const vector n(-normalised(patch.faceAreas()[w.face[i]]));
        EXPECT_NEAR(n & normal(w, i), 1, 1e-12);
        EXPECT_NEAR(n & patch.faceCentres()[w.face[i]], w.offset[i], 1e-14);

        // Inside the face, where the particle is behind one wall only
        const point foot(position(w, i) + depth(w, i)*normal(w, i));
        if (mesh->bounds().contains(foot))
        {
            const scalar distance = patch[w.face[i]].nearestPoint
            (
                foot, patch.points()
            ).distance();
            EXPECT_LT(distance, 1e-14);
        }
    }
}


// The walls of a box that a particle is behind are those it is outside of
TEST(WallParticles, behindEdgesAndCornersAreSeveralWalls)
{
    const autoPtr<polyMesh> mesh
    (
        boxMesh(labelVector(2, 2, 2), vector(0.1, 0.1, 0.1))
    );
    const wallParticles w(particlesOf(mesh(), 0.01));

    std::size_t several = 0;
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        labelHashSet expected;
        for (const polyPatch& patch : mesh->boundaryMesh())
        {
            const vector outwards(patch.faceAreas()[0]);
            if (((position(w, i) - patch.faceCentres()[0]) & outwards) > 0)
            {
                expected.insert(patch.index());
            }
        }
        labelHashSet behind;
        behind.insert(w.patch[i]);
        for (const int other : w.otherPatches[i])
        {
            if (other >= 0)
            {
                behind.insert(other);
            }
        }
        EXPECT_EQ(behind, expected);
        several += behind.size() > 1;
    }
    EXPECT_GT(several, 12*10u);
}


TEST(WallParticles, noneBehindAnOpenPatch)
{
    const scalar dx = 0.01;
    const autoPtr<polyMesh> mesh
    (
        boxMesh(labelVector(2, 2, 2), vector(0.1, 0.1, 0.1), openTop)
    );
    const wallParticles w(particlesOf(mesh(), dx));

    EXPECT_EQ(w.size(), sitesAround(labelVector(10, 10, 10), true));

    for (std::size_t i = 0; i < w.size(); ++i)
    {
        EXPECT_LT(w.z[i], 0.1);
        EXPECT_NE(mesh->boundaryMesh()[w.patch[i]].name(), "zMax");
    }
}


TEST(WallParticles, regionLimitsThem)
{
    const scalar dx = 0.01;
    const autoPtr<polyMesh> mesh
    (
        boxMesh(labelVector(2, 2, 2), vector(1, 1, 1))
    );
    const boundBox region(point(0.4, 0.4, 0), point(0.6, 0.6, 0.3));
    const wallParticles w
    (
        wallParticleGenerator::generate
        (
            mesh(),
            wallParticleGenerator::wallPatches(mesh()),
            dx,
            support*dx,
            region
        )
    );

    // Layers at dx/2, 3/2 dx below a square, columns with rounded edges
    std::size_t expected = 0;
    for (label k = 0; k < 2; ++k)
    for (label j = -3; j < 23; ++j)
    for (label i = -3; i < 23; ++i)
    {
        const vector p(i + 0.5, j + 0.5, k + 0.5);
        const vector nearest(min(max(p, vector::zero), vector(20, 20, 0)));
        expected += mag(p - nearest) < support;
    }

    EXPECT_EQ(w.size(), expected);
    EXPECT_GT(w.size(), 800);
}


TEST(WallParticles, sameAgain)
{
    const autoPtr<polyMesh> mesh
    (
        boxMesh(labelVector(3, 2, 4), vector(0.1037, 0.0829, 0.1262))
    );
    const wallParticles a(particlesOf(mesh(), 0.01));
    const wallParticles b(particlesOf(mesh(), 0.01));
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(a.z, b.z);
    EXPECT_EQ(a.patch, b.patch);
}


TEST(WallParticles, obstacleInTheDomainIsFilled)
{
    // A solid cube of 6.3 spacings within a box, its walls seen from outside
    const scalar dx = 0.01;
    const scalar side = 0.063;
    const autoPtr<polyMesh> mesh
    (
        hexMesh
        (
            labelVector(3, 3, 3),
            [&](const point& p) { return 3*side*p; },
            wordList(6, "patch"),
            [](label i, label j, label k) { return i == 1 && j == 1 && k == 1; }
        )
    );
    const wallParticles w(particlesOf(mesh(), dx));
    expectOutsideAndApart(mesh(), w, 0.5*dx);
    expectDepthsInLayers(w, dx, 1e-14);

    // Two layers: the outer 6 x 6 x 6 without the inner 2 x 2 x 2
    EXPECT_NEAR(scalar(w.size()), 208, 21);

    for (std::size_t i = 0; i < w.size(); ++i)
    {
        const boundBox cube(point::uniform(side), point::uniform(2*side));
        EXPECT_TRUE(cube.contains(position(w, i)));
    }
}


TEST(WallParticles, badLengthsAreFatal)
{
    const autoPtr<polyMesh> mesh
    (
        boxMesh(labelVector(1, 1, 1), vector::one)
    );
    EXPECT_THROW(particlesOf(mesh(), 0), error);
    EXPECT_THROW(particlesOf(mesh(), -1), error);
    EXPECT_THROW(particlesOf(mesh(), std::nan("")), error);
}


// ************************************************************************* //
