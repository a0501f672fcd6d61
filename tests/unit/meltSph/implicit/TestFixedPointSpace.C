/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fixedPointSpace.H"

#include <gtest/gtest.h>

#include <random>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;

namespace
{

particles along(const std::vector<double>& x)
{
    particles f;
    f.resize(int(x.size()));
    f.x = x;
    return f;
}


double difference(const fixedPointSpace& space, const double a, const double b)
{
    return space.unit(0)*std::int32_t(space.place(a, 0) - space.place(b, 0));
}

} // End anonymous namespace


// As fine a kilometre from the origin as at it
TEST(FixedPointSpace, differencesAreFine)
{
    for (const double origin : {0.0, -1000.0})
    {
        const std::vector<double> x
            {origin, origin + 0.3, origin + 0.3001, origin + 1};
        const fixedPointSpace space(along(x), periodicBox());
        for (const double a : x)
        {
            for (const double b : x)
            {
                EXPECT_NEAR(difference(space, a, b), a - b, 1.0/(1 << 30));
                EXPECT_EQ(difference(space, a, b), -difference(space, b, a));
            }
        }
    }
}


// A scene mirrored in a plane has differences that are exactly mirrored, but where
// round-off of the coordinates turns one the other way
TEST(FixedPointSpace, mirroredCoordinatesHaveMirroredPlaces)
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> coordinate(0, 0.3);
    std::vector<double> x;
    for (int i = 0; i < 1000; ++i)
    {
        x.push_back(coordinate(generator));
        x.push_back(-x.back());
    }
    const fixedPointSpace space(along(x), periodicBox());
    const std::uint32_t sum = space.place(x[0], 0) + space.place(x[1], 0);
    for (std::size_t i = 0; i < x.size(); i += 2)
    {
        EXPECT_EQ(space.place(x[i], 0) + space.place(x[i + 1], 0), sum) << x[i];
    }
}


TEST(FixedPointSpace, differencesAreThoseOfNearestImages)
{
    const periodicBox box({-1, 0, 0}, {3, 0, 0});
    const fixedPointSpace space(along({-0.9, 1.9}), box);
    EXPECT_NEAR(difference(space, -0.9, 1.9), 0.2, 1e-8);
    EXPECT_NEAR(difference(space, 1.9, -0.9), -0.2, 1e-8);
    EXPECT_NEAR(difference(space, 1, -0.4), 1.4, 1e-8);
    EXPECT_NEAR(difference(space, 1.2, -0.4), -1.4, 1e-8);
}


// All particles in one plane
TEST(FixedPointSpace, aPlaneHasNoExtent)
{
    const fixedPointSpace space(along({0.5, 0.5}), periodicBox());
    EXPECT_EQ(difference(space, 0.5, 0.5), 0);
}


TEST(FixedPointSpace, noParticles)
{
    EXPECT_EQ(fixedPointSpace(along({}), periodicBox()).unit(0), 1);
}

// ************************************************************************* //
