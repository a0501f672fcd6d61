/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceDistance.H"
#include "meltUnitTests.H"
#include "occupancyGrid.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

//- Sphere of nRings x 2 nRings quadrilaterals, cut in two
triSurface sphere(const point& centre, const scalar radius, const label nRings)
{
    const scalar pi = std::acos(-1.0);
    const label n = 2*nRings;
    pointField points((nRings + 1)*n);
    for (label i = 0; i <= nRings; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            const scalar theta = pi*i/nRings;
            const scalar phi = 2*pi*j/n;
            points[i*n + j] = centre + radius*vector
            (
                std::sin(theta)*std::cos(phi),
                std::sin(theta)*std::sin(phi),
                std::cos(theta)
            );
        }
    }

    List<labelledTri> triangles;
    for (label i = 0; i < nRings; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            const label a = i*n + j;
            const label b = i*n + (j + 1) % n;
            triangles.append(labelledTri(a, a + n, b, 0));
            triangles.append(labelledTri(b, a + n, b + n, 0));
        }
    }
    return triSurface(triangles, points);
}

} // End anonymous namespace


TEST(SurfaceDistance, concentricSpheres)
{
    const surfaceDistance d
    (
        sphere(point(1, 2, 3), 1, 40), sphere(point(1, 2, 3), 1.2, 40)
    );

    // Facets of 40 rings are within 0.4 % of the sphere
    EXPECT_NEAR(d.mean, 0.2, 0.004);
    EXPECT_NEAR(d.Hausdorff, 0.2, 0.005);
}


TEST(SurfaceDistance, HausdorffOfTwoSpheresIsTheirShiftAndDifferenceOfRadius)
{
    const surfaceDistance d
    (
        sphere(point::zero, 1, 40), sphere(point(0, 0, 0.3), 1.1, 40)
    );

    EXPECT_NEAR(d.Hausdorff, 0.4, 0.005);
    EXPECT_LT(d.mean, d.Hausdorff);
}


TEST(SurfaceDistance, isSymmetricAndZeroToItself)
{
    const triSurface a(sphere(point::zero, 1, 20));
    const triSurface b(sphere(point(0.1, 0, 0), 0.7, 15));
    const surfaceDistance ab(a, b), ba(b, a), aa(a, a);

    EXPECT_EQ(ab.mean, ba.mean);
    EXPECT_EQ(ab.Hausdorff, ba.Hausdorff);
    EXPECT_NEAR(aa.mean, 0, 1e-12);
    EXPECT_NEAR(aa.Hausdorff, 0, 1e-12);
}


TEST(SurfaceDistance, ofNothing)
{
    const triSurface none;
    const triSurface a(sphere(point::zero, 1, 10));

    EXPECT_EQ(surfaceDistance(none, none).Hausdorff, 0);
    EXPECT_EQ(surfaceDistance(a, none).Hausdorff, GREAT);
    EXPECT_EQ(surfaceDistance(none, a).mean, GREAT);
}


// ************************************************************************* //
