/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidCase.H"
#include "solidContact.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

//- Two bodies that meet in the plane x = 0.03
struct contactCase
{
    solidCase scene;
    std::vector<solidBody> bodies{2};
    std::vector<int> bodyOf;

    explicit contactCase(const particleCloud& cloud)
    :
        scene(cloud)
    {
        const particles& f = scene.f;
        for (int i = 0; i < f.size(); ++i)
        {
            bodyOf.push_back(f.x[i] > 0.03);
            bodies[bodyOf[i]].members.push_back(i);
        }
        for (solidBody& body : bodies)
        {
            body.setGeometry(f);
        }
    }

    void push(const scalar friction, const label sweeps, const scalar deltaT)
    {
        solidContact(scene.system, friction, sweeps).push
        (
            bodies, bodyOf, deltaT
        );
    }

    vector linear() const
    {
        return bodies[0].mass*bodies[0].U + bodies[1].mass*bodies[1].U;
    }

    vector angular() const
    {
        vector sum(Zero);
        for (const solidBody& body : bodies)
        {
            sum += (body.centre ^ (body.mass*body.U)) + body.L;
        }
        return sum;
    }

    scalar energy() const
    {
        scalar sum = 0;
        for (const solidBody& body : bodies)
        {
            if (!body.fixed)
            {
                sum +=
                    0.5*body.mass*magSqr(body.U)
                  + 0.5*(body.L & (body.inverseInertia & body.L));
            }
        }
        return sum;
    }
};


vector randomVector(particleCloud& cloud)
{
    const double x = cloud.random(-1, 1);
    const double y = cloud.random(-1, 1);
    return vector(x, y, cloud.random(-1, 1));
}

} // End anonymous namespace


TEST(SolidContact, keepsMomentaAndGainsNoEnergyWhateverTheMotion)
{
    label nTouched = 0;
    for (unsigned seed = 1; seed <= 40; ++seed)
    {
        particleCloud cloud(movingLump(seed, {6, 4, 4}));
        contactCase test(cloud);
        for (solidBody& body : test.bodies)
        {
            body.U = randomVector(cloud);
            body.L = body.inertia & (50*randomVector(cloud));
        }
        const vector linear(test.linear()), angular(test.angular());
        const scalar energy = test.energy();
        const scalar size = test.bodies[0].mass;

        test.push(cloud.random(0, 1), seed%2 ? 100 : 3, 1e-3);
        EXPECT_LT(mag(test.linear() - linear), 1e-13*size);
        EXPECT_LT(mag(test.angular() - angular), 1e-14*size);
        EXPECT_LE(test.energy(), energy*(1 + 1e-12)) << seed;
        nTouched += test.energy() < energy;
    }
    EXPECT_GT(nTouched, 10);
}


// Equal blocks, one particle's size apart, go on with their mean velocity
TEST(SolidContact, headOnIsPlastic)
{
    contactCase test
    (
        particleCloud
        (
            lattice
            {
                {6, 4, 4}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3, 0
            }
        )
    );
    test.bodies[0].U = vector(1, 0, 0);
    test.bodies[1].U = vector(-0.5, 0, 0);
    test.push(0.5, 200, 1e-3);
    for (const solidBody& body : test.bodies)
    {
        EXPECT_LT(mag(body.U - vector(0.25, 0, 0)), 1e-6);
        EXPECT_LT(mag(body.omega()), 1e-4);
    }
}


TEST(SolidContact, thoseThatPartAreNotTouched)
{
    contactCase test(movingLump(1, {6, 4, 4}));
    test.bodies[0].U = vector(-10, 0, 0);
    test.bodies[1].U = vector(10, 0, 0);
    test.push(0.5, 100, 1e-3);
    EXPECT_EQ(test.bodies[0].U, vector(-10, 0, 0));
}


// Without friction a body slides along a fixed one, and loses nothing but the
// speed towards it
TEST(SolidContact, fixedBodiesStopWhatHitsThem)
{
    for (const scalar friction : {0.0, 10.0})
    {
        contactCase test
        (
            particleCloud
            (
                lattice
                {
                    {6, 4, 4}, 0.01,
                    smoothingKernel::kernelType::wendlandC2, 1.3, 0
                }
            )
        );
        test.bodies[0].fixed = true;
        test.bodies[1].U = vector(-1, 0.2, 0);
        const scalar energy = test.energy();
        test.push(friction, 200, 1e-3);
        EXPECT_GT(test.bodies[1].U.x(), -1e-3);
        EXPECT_LT(test.energy(), energy);
        if (friction > 0)
        {
            EXPECT_LT(mag(test.bodies[1].U.y()), 0.1);
        }
        else
        {
            EXPECT_NEAR(test.bodies[1].U.y(), 0.2, 1e-12);
        }
    }
}

// ************************************************************************* //
