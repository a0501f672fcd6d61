/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/mesh/hexMesh.H"
#include "meltUnitTests.H"
#include "indexedOctree.H"
#include "mathematicalConstants.H"
#include "SubField.H"
#include "transform.H"
#include "treeDataCell.H"
#include "wallParticleGenerator.H"
#include "wendlandC2.H"

#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;

namespace
{

// Support radius in spacings
constexpr scalar support = 2.5;

const wordList walls(6, "wall");

const wordList openTop({"wall", "wall", "wall", "wall", "wall", "patch"});


wallParticles particlesOf(const polyMesh& mesh, const scalar dx)
{
    return wallParticleGenerator::generate
    (
        mesh,
        wallParticleGenerator::wallPatches(mesh),
        dx,
        support*dx,
        mesh.bounds()
    );
}


point position(const wallParticles& w, const std::size_t i)
{
    return point(w.x[i], w.y[i], w.z[i]);
}


vector normal(const wallParticles& w, const std::size_t i)
{
    return vector(w.nx[i], w.ny[i], w.nz[i]);
}


// Distance behind the particle's own plane
scalar depth(const wallParticles& w, const std::size_t i)
{
    return w.offset[i] - (normal(w, i) & position(w, i));
}


void expectDepthsInLayers
(
    const wallParticles& w,
    const scalar dx,
    const scalar tolerance
)
{
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        const scalar layer = depth(w, i)/dx - 0.5;
        EXPECT_NEAR(layer, std::round(layer), tolerance/dx) << i;
        EXPECT_GE(layer, -tolerance/dx);
        EXPECT_NEAR(mag(normal(w, i)), 1, 1e-14);
    }
}


void expectOutsideAndApart
(
    const polyMesh& mesh,
    const wallParticles& w,
    const scalar least
)
{
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        const point p(position(w, i));
        EXPECT_EQ(mesh.cellTree().findInside(p), -1) << i;

        for (std::size_t j = 0; j < i; ++j)
        {
            ASSERT_GE(mag(p - position(w, j)), least) << i;
        }
    }
}


scalar kernelVolume(const point& p, const point& q, const scalar v, scalar dx)
{
    const wendlandC2 kernel(support*dx/2, 3);
    return v*kernel.value(magSqr(p - q));
}


// Sum of V W at p over the wall particles
scalar wallSum(const wallParticles& w, const point& p, const scalar dx)
{
    scalar sum = 0;
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        sum += kernelVolume(p, position(w, i), w.volume[i], dx);
    }
    return sum;
}


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
        unitTest::boxMesh(labelVector(3, 2, 4), vector(0.1, 0.08, 0.12))
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
        unitTest::boxMesh(labelVector(3, 2, 4), vector(0.1037, 0.0829, 0.1262))
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
        unitTest::hexMesh
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
        unitTest::boxMesh(labelVector(2, 2, 2), vector(0.1, 0.1, 0.1))
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


TEST(WallParticles, noneBehindAnOpenPatch)
{
    const scalar dx = 0.01;
    const autoPtr<polyMesh> mesh
    (
        unitTest::boxMesh(labelVector(2, 2, 2), vector(0.1, 0.1, 0.1), openTop)
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
        unitTest::boxMesh(labelVector(2, 2, 2), vector(1, 1, 1))
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
        unitTest::boxMesh(labelVector(3, 2, 4), vector(0.1037, 0.0829, 0.1262))
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
        unitTest::hexMesh
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


TEST(WallParticles, cylinderFromInside)
{
    // A facetted wall, as arcs of blockMesh make it
    const scalar dx = 0.01;
    const scalar radius = 0.1;
    const scalar height = 0.08;
    const label nFacets = 48;

    const autoPtr<polyMesh> mesh
    (
        unitTest::hexMesh
        (
            labelVector(nFacets/4, nFacets/4, 4),
            [&](const point& p)
            {
                // Concentric squares become concentric circles
                const scalar a = 2*p.x() - 1;
                const scalar b = 2*p.y() - 1;
                const scalar r = max(mag(a), mag(b));
                if (r == 0)
                {
                    return point(0, 0, height*p.z());
                }
                const scalar quarter = constant::mathematical::piByTwo/2;
                const scalar phi =
                    mag(a) >= mag(b)
                  ? (a > 0 ? 0 : 4*quarter) + quarter*b/a
                  : (b > 0 ? 2*quarter : -2*quarter) - quarter*a/b;
                return point
                (
                    radius*r*std::cos(phi), radius*r*std::sin(phi), height*p.z()
                );
            },
            openTop
        )
    );
    const wallParticles w(particlesOf(mesh(), dx));
    expectOutsideAndApart(mesh(), w, 0.5*dx);

    // The facets are off the circle by radius*(1 - cos(pi/nFacets))
    const scalar sagitta =
        radius*(1 - std::cos(constant::mathematical::pi/nFacets));
    std::size_t nSide = 0;
    scalar volume = 0;
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        EXPECT_LT(w.z[i], height);
        const point p(position(w, i));
        if (p.z() > 0)
        {
            const scalar r = std::hypot(p.x(), p.y());
            const scalar layer = (r - radius)/dx - 0.5;
            EXPECT_NEAR(layer, std::round(layer), 1.001*sagitta/dx);
            EXPECT_NEAR((normal(w, i) & p)/r, -1, 0.01);
            volume += w.volume[i];
            ++nSide;
        }
    }

    // Layers of 8 rows and of 2 pi (r + dx/2) and 2 pi (r + 3 dx/2) around
    EXPECT_NEAR(scalar(nSide), 8*(66 + 72), 0.02*8*(66 + 72));
    const scalar shell =
        constant::mathematical::pi*height*(sqr(radius + 2*dx) - sqr(radius));
    EXPECT_NEAR(volume, shell, 0.01*shell);

    // Half a spacing off the wall the kernel sees the volume beyond it
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<scalar> angle(0, 2*constant::mathematical::pi);
    scalar lowest = GREAT;
    scalar highest = 0;
    for (label i = 0; i < 50; ++i)
    {
        const scalar phi = angle(generator);
        const point p
        (
            (radius - dx/2)*std::cos(phi),
            (radius - dx/2)*std::sin(phi),
            height/2
        );

        // By a lattice ten times finer
        scalar beyond = 0;
        const label m = 10;
        for (label c = -3*m; c < 3*m; ++c)
        for (label b = -3*m; b < 3*m; ++b)
        for (label a = -3*m; a < 3*m; ++a)
        {
            const vector d(dx/m*vector(a + 0.5, b + 0.5, c + 0.5));
            const point q(p + d);
            if (std::hypot(q.x(), q.y()) > radius)
            {
                beyond += kernelVolume(p, q, pow3(dx/m), dx);
            }
        }
        const scalar ratio = wallSum(w, p, dx)/beyond;
        EXPECT_NEAR(ratio, 1, 0.1) << phi;
        lowest = min(lowest, ratio);
        highest = max(highest, ratio);
    }

    // A seam where the layers close would show as a difference
    EXPECT_LT(highest - lowest, 0.05);
}


TEST(WallParticles, badLengthsAreFatal)
{
    const autoPtr<polyMesh> mesh
    (
        unitTest::boxMesh(labelVector(1, 1, 1), vector::one)
    );
    EXPECT_THROW(particlesOf(mesh(), 0), error);
    EXPECT_THROW(particlesOf(mesh(), -1), error);
    EXPECT_THROW(particlesOf(mesh(), std::nan("")), error);
}


// ************************************************************************* //
