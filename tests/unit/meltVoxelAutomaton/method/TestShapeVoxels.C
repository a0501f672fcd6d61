/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltScene/shapes/shapeTestTools.H"
#include "meltUnitTests.H"
#include "Random.H"
#include "shapeVoxels.H"

#include <map>

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

const voxelFrame frame
(
    boundBox(point::zero, 24*vector::one), vector(0, 0, -9.81), 1
);

std::string text(const vector& v)
{
    return
        '(' + std::to_string(v.x()) + ' ' + std::to_string(v.y()) + ' '
      + std::to_string(v.z()) + ')';
}


//- Volume filled over that of the shape
scalar volumeRatio(const shape& body)
{
    scalar sum = 0;
    const shapeVoxels voxels(body, frame);
    for (const shapeVoxels::filledVoxel& f : voxels.filled())
    {
        EXPECT_GT(f.share, 0);
        EXPECT_LE(f.share, 1 + 1e-12);
        sum += f.share;
    }
    return sum/body.volume();
}

} // End anonymous namespace


// Wherever its sides are: to 1/512 across them, at its edges to an eighth of a
// voxel
TEST(ShapeVoxels, volumeOfABox)
{
    Random random(7);
    for (label i = 0; i < 20; ++i)
    {
        const vector low(5*vector::one + random.sample01<vector>());
        const vector span(8*vector::one + random.sample01<vector>());
        const autoPtr<shape> box
        (
            shapeOf
            (
                "type box; min " + text(low) + "; max " + text(low + span) + ';'
            )
        );
        const scalar edges = 4*(span.x() + span.y() + span.z());
        EXPECT_NEAR(volumeRatio(*box), 1, edges/8/box->volume())
            << text(low) << text(span);
    }
}


TEST(ShapeVoxels, boxBetweenCellsIsExact)
{
    EXPECT_NEAR
    (
        volumeRatio(*shapeOf("type box; min (3 4 5); max (9 8 7);")), 1, 1e-12
    );
    EXPECT_NEAR
    (
        volumeRatio(*shapeOf("type box; min (3.5 4.5 5.5); max (9.5 8.5 7.5);")),
        1,
        1e-12
    );
}


TEST(ShapeVoxels, volumeOfASphere)
{
    Random random(9);
    for (const scalar radius : {2.3, 5.3, 9.7})
    {
        const vector centre(11.5*vector::one + random.sample01<vector>());
        const autoPtr<shape> sphere
        (
            shapeOf
            (
                "type sphere; centre " + text(centre) + "; radius "
              + std::to_string(radius) + ';'
            )
        );
        const scalar ratio = volumeRatio(*sphere);
        std::cout << "    R = " << radius << ": " << ratio << '\n';
        EXPECT_NEAR(ratio, 1, 0.02/sqr(radius));
    }
}


// Turned by a right angle, and mirrored, exactly
TEST(ShapeVoxels, symmetryIsKept)
{
    const autoPtr<shape> sphere
    (
        shapeOf("type sphere; centre (12 12 12); radius 6.3;")
    );
    std::map<std::array<int, 3>, double> shares;
    const shapeVoxels voxels(*sphere, frame);
    for (const shapeVoxels::filledVoxel& f : voxels.filled())
    {
        shares[f.v] = f.share;
    }
    for (const auto& voxel : shares)
    {
        const std::array<int, 3>& v = voxel.first;
        EXPECT_DOUBLE_EQ((shares[{23 - v[0], v[1], v[2]}]), voxel.second);
        EXPECT_DOUBLE_EQ((shares[{v[1], v[0], v[2]}]), voxel.second);
        EXPECT_DOUBLE_EQ((shares[{v[2], v[1], v[0]}]), voxel.second);
    }
}

// ************************************************************************* //
