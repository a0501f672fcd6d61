/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallParticleChecks.H"
#include "mathematicalConstants.H"

#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;
using constant::mathematical::pi;

namespace
{

constexpr scalar dx = 0.01;

// What the kernel sum of an exact lattice lacks at dx/2 in front of a plane
constexpr scalar planeError = -0.0235;


// Points by a function of three uniform random numbers from 0 to 1
pointField randomPoints
(
    const std::function<point(scalar, scalar, scalar)>& at
)
{
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<scalar> uniform(0, 1);
    pointField points(40);

    for (point& p : points)
    {
        const scalar a = uniform(generator);
        const scalar b = uniform(generator);
        const scalar c = uniform(generator);
        p = at(a, b, c);
    }

    return points;
}


point onCylinder(const scalar radius, const scalar angle, const scalar z)
{
    return point(radius*std::cos(angle), radius*std::sin(angle), z);
}


// Cylinder around the z axis, open at the top
autoPtr<polyMesh> cylinderMesh
(
    const scalar radius,
    const scalar height,
    const label nFacets
)
{
    return hexMesh
    (
        labelVector(nFacets/4, nFacets/4, 4),
        [=](const point& p)
        {
            // Concentric squares become concentric circles
            const scalar a = 2*p.x() - 1;
            const scalar b = 2*p.y() - 1;
            const scalar r = max(mag(a), mag(b));
            if (r == 0)
            {
                return point(0, 0, height*p.z());
            }
            const scalar eighth = pi/4;
            const scalar angle =
                mag(a) >= mag(b)
              ? (a > 0 ? 0 : 4*eighth) + eighth*b/a
              : (b > 0 ? 2*eighth : -2*eighth) - eighth*a/b;
            return onCylinder(radius*r, angle, height*p.z());
        },
        openTop
    );
}

} // End anonymous namespace


TEST(CurvedWallParticles, cylinder)
{
    const scalar radius = 0.1;
    const scalar height = 0.08;
    const label nFacets = 48;
    const autoPtr<polyMesh> mesh(cylinderMesh(radius, height, nFacets));
    const wallParticles w(particlesOf(mesh(), dx));
    expectOutsideAndApart(mesh(), w, 0.5*dx);

    // The facets are off the circle by this
    const scalar sagitta = radius*(1 - std::cos(pi/nFacets));
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

    // Two layers of 8 rows, 2 pi (r + dx/2) and 2 pi (r + 3 dx/2) around
    EXPECT_NEAR(scalar(nSide), 8*(66 + 72), 0.02*8*(66 + 72));
    const scalar shell = pi*height*(sqr(radius + 2*dx) - sqr(radius));
    EXPECT_NEAR(volume, shell, 0.01*shell);

    const auto inDomain = [&](const point& p)
    {
        return p.z() > 0 && std::hypot(p.x(), p.y()) < radius;
    };

    const scalarMinMax side
    (
        kernelSumErrors
        (
            w, dx, inDomain, randomPoints
            (
                [&](scalar a, scalar, scalar)
                {
                    return onCylinder(radius - dx/2, 2*pi*a, height/2);
                }
            )
        )
    );
    EXPECT_GT(side.min(), planeError - 0.02);
    EXPECT_LT(side.max(), planeError + 0.02);

    const scalarMinMax edge
    (
        kernelSumErrors
        (
            w, dx, inDomain, randomPoints
            (
                [&](scalar a, scalar, scalar)
                {
                    return onCylinder(radius - dx/2, 2*pi*a, dx/2);
                }
            )
        )
    );
    EXPECT_GT(edge.min(), planeError - 0.04);
    EXPECT_LT(edge.max(), planeError + 0.04);
}


TEST(CurvedWallParticles, troughHasNoSeamAtItsOpenEdges)
{
    // Lower half of a cylinder, walls at both ends
    const scalar radius = 0.1;
    const scalar length = 0.1;
    const autoPtr<polyMesh> mesh
    (
        hexMesh
        (
            labelVector(24, 4, 6),
            [&](const point& p)
            {
                const scalar r = radius*(1 - 0.8*p.y());
                return onCylinder(r, pi + pi*p.x(), length*p.z());
            },
            wordList({"patch", "patch", "wall", "patch", "wall", "wall"})
        )
    );
    const wallParticles w(particlesOf(mesh(), dx));
    expectOutsideAndApart(mesh(), w, 0.5*dx);

    for (std::size_t i = 0; i < w.size(); ++i)
    {
        EXPECT_LT(w.y[i], 0);
    }

    const scalarMinMax errors
    (
        kernelSumErrors
        (
            w,
            dx,
            [&](const point& p)
            {
                return p.y() > 0 || std::hypot(p.x(), p.y()) < radius;
            },
            randomPoints
            (
                [&](scalar a, scalar b, scalar)
                {
                    const scalar angle = pi*(1.02 + 0.96*a);
                    return onCylinder(radius - dx/2, angle, length*(1 + b)/3);
                }
            )
        )
    );
    EXPECT_GT(errors.min(), planeError - 0.02);
    EXPECT_LT(errors.max(), planeError + 0.02);
}


TEST(CurvedWallParticles, ball)
{
    const scalar radius = 0.1;
    const autoPtr<polyMesh> mesh
    (
        hexMesh
        (
            labelVector(20, 20, 20),
            [&](const point& p)
            {
                // Concentric cubes become concentric spheres
                const vector a(2*p - vector::one);
                const scalar m = cmptMax(cmptMag(a));
                if (m == 0)
                {
                    return point(Zero);
                }
                const vector t
                (
                    std::tan(pi/4*a.x()/m),
                    std::tan(pi/4*a.y()/m),
                    std::tan(pi/4*a.z()/m)
                );
                return point(radius*m*normalised(t));
            }
        )
    );
    const wallParticles w(particlesOf(mesh(), dx));
    expectOutsideAndApart(mesh(), w, 0.7*dx);

    const scalarMinMax errors
    (
        kernelSumErrors
        (
            w,
            dx,
            [&](const point& p) { return mag(p) < radius; },
            randomPoints
            (
                [&](scalar a, scalar b, scalar)
                {
                    const scalar z = 2*a - 1;
                    const scalar r = std::sqrt(1 - sqr(z));
                    return (radius - dx/2)*onCylinder(r, 2*pi*b, z);
                }
            )
        )
    );
    EXPECT_GT(errors.min(), planeError - 0.05);
    EXPECT_LT(errors.max(), planeError + 0.05);
}


TEST(CurvedWallParticles, edgesOfAnyAngle)
{
    for (const label nSides : {3, 4, 5, 6, 8})
    {
        // Two walls with the angle of a regular polygon, edge along y
        const scalar angle = pi*(nSides - 2)/nSides;
        const vector side(std::cos(angle), 0, std::sin(angle));
        const scalar size = 0.15;
        const autoPtr<polyMesh> mesh
        (
            hexMesh
            (
                labelVector(3, 3, 3),
                [&](const point& p)
                {
                    return point
                    (
                        size*(vector(p.x(), p.y(), 0) + p.z()*side)
                    );
                },
                wordList({"wall", "patch", "patch", "patch", "wall", "patch"})
            )
        );
        const wallParticles w(particlesOf(mesh(), dx));
        expectOutsideAndApart(mesh(), w, 0.5*dx);

        // Half a spacing from both
        const vector n0(0, 0, 1);
        const vector n1(std::sin(angle), 0, -std::cos(angle));
        const vector corner(dx/2*(n0 + n1)/(1 + (n0 & n1)));

        const scalarMinMax errors
        (
            kernelSumErrors
            (
                w,
                dx,
                [&](const point& p) { return (p & n0) > 0 && (p & n1) > 0; },
                randomPoints
                (
                    [&](scalar a, scalar, scalar)
                    {
                        return corner + point(0, size*(1 + a)/3, 0);
                    }
                )
            )
        );
        EXPECT_GT(errors.min(), planeError - 0.06) << nSides;
        EXPECT_LT(errors.max(), planeError + 0.06) << nSides;
    }
}


// ************************************************************************* //
