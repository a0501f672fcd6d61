/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "occupancyGrid.H"
#include "mathematicalConstants.H"
#include "meltUnitTests.H"
#include "Random.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

const scalar pi = constant::mathematical::pi;

//- Cubes of an edge that fill a box, at a temperature that rises with x
meltParcels boxOfCubes
(
    const point& low,
    const point& high,
    const scalar edge,
    const scalar T0 = 300
)
{
    meltParcels parcels;
    const vector n((high - low)/edge);
    for (label i = 0; i < label(n.x() + 0.5); ++i)
    {
        for (label j = 0; j < label(n.y() + 0.5); ++j)
        {
            for (label k = 0; k < label(n.z() + 0.5); ++k)
            {
                const point corner(low + edge*vector(i, j, k));
                parcels.append
                (
                    boundBox(corner, corner + edge*vector::one),
                    pow3(edge),
                    T0 + corner.x()
                );
            }
        }
    }
    return parcels;
}


//- Cubes whose centres are within a ball, or at random in it
meltParcels ball
(
    const point& centre,
    const scalar radius,
    const scalar edge,
    const scalar disorder = 0
)
{
    Random random(12345);
    meltParcels parcels;
    const label n = label(radius/edge) + 1;
    for (label i = -n; i < n; ++i)
    {
        for (label j = -n; j < n; ++j)
        {
            for (label k = -n; k < n; ++k)
            {
                vector at(edge*vector(i + 0.5, j + 0.5, k + 0.5));
                if (mag(at) < radius)
                {
                    for (direction d = 0; d < 3; ++d)
                    {
                        at[d] +=
                            disorder*edge*(random.sample01<scalar>() - 0.5);
                    }
                    const vector half(0.5*edge*vector::one);
                    parcels.append
                    (
                        boundBox(centre + at - half, centre + at + half),
                        pow3(edge),
                        300
                    );
                }
            }
        }
    }
    return parcels;
}


scalar enclosed(const triSurface& surface)
{
    scalar volume = 0;
    for (const labelledTri& f : surface)
    {
        const pointField& p = surface.points();
        volume += (p[f[0]] & (p[f[1]] ^ p[f[2]]))/6;
    }
    return mag(volume);
}

} // End anonymous namespace


TEST(OccupancyGrid, boxOnTheCellsIsExactButForItsCorners)
{
    const meltParcels box(boxOfCubes(point(0, 0, 0), point(1, 1, 1), 0.1));
    const occupancyGrid grid(box, box.bounds(), 0.1);

    // The filter takes the 8 corners: (3/4)^3 < 1/2 <= (3/4)^2
    EXPECT_EQ(grid.nOccupied(), 1000 - 8);
    EXPECT_NEAR(grid.occupiedVolume(), 0.992, 1e-12);
}


TEST(OccupancyGrid, filterKeepsTheVolume)
{
    // Cubes across the cells
    const meltParcels box
    (
        boxOfCubes(point(0.03, 0.01, 0.02), point(1.03, 0.91, 0.82), 0.1)
    );
    const occupancyGrid grid(box, boundBox(point::zero, 2*point::one), 0.07);

    EXPECT_NEAR(sum(grid.fraction())*pow3(0.07), 0.72, 1e-12);
}


TEST(OccupancyGrid, volumeOfABall)
{
    // 10, 20 cells a radius
    for (const scalar edge : {0.1, 0.05})
    {
        const meltParcels parcels(ball(point(1, 2, 3), 1, edge));
        const occupancyGrid grid(parcels, parcels.bounds(), edge);
        const scalar exact = 4*pi/3;

        EXPECT_NEAR(grid.occupiedVolume(), exact, 0.3*edge*exact);
        EXPECT_NEAR(enclosed(grid.surface()), exact, 0.3*edge*exact);
    }
}


TEST(OccupancyGrid, disorderedParticlesAreOccupiedWithoutHoles)
{
    const meltParcels order(ball(point::zero, 1, 0.1));
    const meltParcels disorder(ball(point::zero, 1, 0.1, 0.8));
    boundBox bounds(order.bounds());
    bounds.add(disorder.bounds());
    const occupancyGrid a(order, bounds, 0.1);
    const occupancyGrid b(disorder, bounds, 0.1);

    // Displaced by up to 0.4 of a spacing: clipped where they overlap
    EXPECT_GT(occupancyGrid::intersectionOverUnion(a, b), 0.86);
    const triSurface surface(b.surface());
    for (const point& p : surface.points())
    {
        EXPECT_GT(mag(p), 0.8);
    }
}


TEST(OccupancyGrid, intersectionOverUnionOfShiftedBoxes)
{
    // Boxes of 20 x 20 x 20 cells, one shifted by 5: 3/4 over 5/4
    const meltParcels a(boxOfCubes(point(0, 0, 0), point(1, 1, 1), 0.05));
    const meltParcels b(boxOfCubes(point(0.25, 0, 0), point(1.25, 1, 1), 0.05));
    boundBox bounds(a.bounds());
    bounds.add(b.bounds());
    const occupancyGrid gridA(a, bounds, 0.05);
    const occupancyGrid gridB(b, bounds, 0.05);

    EXPECT_NEAR
    (
        occupancyGrid::intersectionOverUnion(gridA, gridB), 0.6, 1e-9
    );
    EXPECT_EQ(occupancyGrid::intersectionOverUnion(gridA, gridA), 1);

    const meltParcels none;
    const occupancyGrid empty(none, bounds, 0.05);
    EXPECT_EQ(occupancyGrid::intersectionOverUnion(gridA, empty), 0);
    EXPECT_EQ(occupancyGrid::intersectionOverUnion(empty, empty), 1);
}


TEST(OccupancyGrid, temperatureDifference)
{
    const meltParcels a(boxOfCubes(point(0, 0, 0), point(1, 1, 1), 0.1));
    meltParcels b(boxOfCubes(point(0, 0, 0), point(1, 1, 1), 0.1, 303));
    const occupancyGrid gridA(a, a.bounds(), 0.1);

    const Pair<scalar> uniform
    (
        occupancyGrid::TDifference(gridA, occupancyGrid(b, a.bounds(), 0.1))
    );
    EXPECT_NEAR(uniform.first(), 3, 1e-9);
    EXPECT_NEAR(uniform.second(), 3, 1e-9);

    // Half of the cells differ by 5: root mean square 5/sqrt(2)
    forAll(b.T, i)
    {
        b.T[i] = a.T[i] + (b.box[i].min().x() < 0.45 ? 5 : 0);
    }
    const Pair<scalar> half
    (
        occupancyGrid::TDifference(gridA, occupancyGrid(b, a.bounds(), 0.1))
    );
    EXPECT_NEAR(half.first(), 5/std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(half.second(), 5, 1e-9);
}


TEST(OccupancyGrid, partlyFilledBoxesCountByTheirVolume)
{
    // A layer of voxels filled by 0.6 and one by 0.3: the lower is there
    meltParcels film(boxOfCubes(point(0, 0, 0), point(1, 1, 0.3), 0.1));
    forAll(film.volume, i)
    {
        film.volume[i] *= film.box[i].min().z() > 0.15 ? 0.3 : 1;
    }
    const occupancyGrid grid(film, film.bounds(), 0.1);

    EXPECT_NEAR(grid.occupiedVolume(), 0.2, 0.01);
}


TEST(OccupancyGrid, refusesAGridBeyondMemory)
{
    const meltParcels box(boxOfCubes(point(0, 0, 0), point(1, 1, 1), 0.5));
    EXPECT_THROW(occupancyGrid(box, box.bounds(), 1e-4), Foam::error);
}


// ************************************************************************* //
