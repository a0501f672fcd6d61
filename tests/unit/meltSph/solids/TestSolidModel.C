/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/particleCloud/cloudVectors.H"
#include "solidCase.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

scalar heatOf(const particles& f)
{
    return blockSum(f.size(), [&](const int i) { return f.m[i]*f.h[i]; });
}


void expectSame(const momenta& a, const momenta& b, const particles& f)
{
    const scalar size = f.m[0]*f.size();
    EXPECT_LT(mag(a.linear - b.linear), 1e-13*size);
    EXPECT_LT(mag(a.angular - b.angular), 1e-14*size);
}

} // End anonymous namespace


// A random part of the lump is solid, in pieces
TEST(SolidModel, updateKeepsMomentaAndHeatAndGainsNoEnergy)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        particleCloud cloud(movingLump(seed));
        solidCase test(cloud);
        test.setSolid
        (
            [&](double, double, double) { return cloud.random(0, 1) < 0.3; }
        );
        const momenta before(test.f);
        const scalar heat = heatOf(test.f);

        test.model->update();
        EXPECT_GT(test.nBodies(), 1);
        const momenta after(test.f);
        expectSame(before, after, test.f);
        EXPECT_LT(after.energy, before.energy);
        EXPECT_EQ(heatOf(test.f), heat);

        // Rigid already: nothing is lost any more
        test.model->update();
        EXPECT_NEAR(momenta(test.f).energy, after.energy, 1e-13*after.energy);
    }
}


// Two pieces of different motion; what lies between them freezes. They go on
// as one, by an inelastic collision
TEST(SolidModel, freezingJoinsPieces)
{
    solidCase test(movingLump(2, {10, 4, 4}));
    particles& f = test.f;
    const auto between = [](double x, double, double)
    {
        return x > 0.04 && x < 0.06;
    };
    test.setSolid
    (
        [&](double x, double y, double z) { return !between(x, y, z); }
    );
    for (int i = 0; i < f.size(); ++i)
    {
        f.u[i] = f.x[i] < 0.05 ? 1 : -2;
        f.v[i] = 3;
    }
    test.model->update();
    EXPECT_EQ(test.nBodies(), 2);

    test.setSolid([](double, double, double) { return true; });
    const momenta before(f);
    const scalar heat = heatOf(f);
    test.model->update();
    EXPECT_EQ(test.nBodies(), 1);
    const momenta after(f);
    expectSame(before, after, f);
    EXPECT_LT(after.energy, before.energy);
    EXPECT_EQ(heatOf(f), heat);

    // One motion: that of the common momenta
    scalar mass = 0;
    vector centre(Zero);
    for (int i = 0; i < f.size(); ++i)
    {
        mass += f.m[i];
        centre += f.m[i]*vector(f.x[i], f.y[i], f.z[i]);
    }
    centre /= mass;
    solidBody whole;
    for (int i = 0; i < f.size(); ++i)
    {
        whole.members.push_back(i);
    }
    whole.setGeometry(f);
    whole.setMotion(f, f.u, f.v, f.w);
    EXPECT_LT(mag(whole.U - before.linear/mass), 1e-13);
    for (int i = 0; i < f.size(); i += 7)
    {
        const vector exact(whole.U + (whole.omega() ^ whole.arm(f, i)));
        EXPECT_LT(mag(vector(f.u[i], f.v[i], f.w[i]) - exact), 1e-12);
    }
}


// A neck melts: each half goes on as it moved
TEST(SolidModel, meltingSplitsPiecesWithoutLoss)
{
    solidCase test(movingLump(3, {10, 4, 4}));
    particles& f = test.f;
    test.model->update();
    EXPECT_EQ(test.nBodies(), 1);

    const momenta before(f);
    const particles start(f);
    test.setSolid
    (
        [](double x, double, double) { return x < 0.04 || x > 0.06; }
    );
    test.model->update();
    EXPECT_EQ(test.nBodies(), 2);
    const momenta after(f);
    expectSame(before, after, f);
    EXPECT_NEAR(after.energy, before.energy, 1e-13*before.energy);
    for (int i = 0; i < f.size(); ++i)
    {
        ASSERT_NEAR(f.u[i], start.u[i], 1e-13);
    }
}


TEST(SolidModel, frozenStandsWhileLiquidMoves)
{
    solidCase test(movingLump(4), "type frozen;");
    particles& f = test.f;
    test.setSolid([](double x, double, double) { return x < 0.03; });
    const particles start(f);
    test.model->update();
    std::fill(f.ax.begin(), f.ax.end(), 5);
    std::fill(f.dRho.begin(), f.dRho.end(), 7);
    test.model->projectRates();
    test.model->collide(0.1);
    test.model->move(0.1);
    for (int i = 0; i < f.size(); ++i)
    {
        if (f.x[i] < 0.03)
        {
            ASSERT_EQ(f.u[i], 0);
            ASSERT_EQ(f.ax[i], 0);
            ASSERT_EQ(f.dRho[i], 0);
        }
        else
        {
            ASSERT_EQ(f.u[i], start.u[i]);
            ASSERT_EQ(f.ax[i], 5);
            ASSERT_EQ(f.dRho[i], 7);
        }
        ASSERT_EQ(f.x[i], start.x[i]);
    }
}


TEST(SolidModel, forcesBecomeThoseOfRigidMotion)
{
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        particleCloud cloud(movingLump(seed));
        solidCase test(cloud);
        test.setSolid
        (
            [&](double, double, double) { return cloud.random(0, 1) < 0.4; }
        );
        test.model->update();

        const particles& f = test.f;
        const auto overMass = [&](vectorArray a)
        {
            for (int i = 0; i < a.size(); ++i)
            {
                a.x[i] /= f.m[i];
                a.y[i] /= f.m[i];
                a.z[i] /= f.m[i];
            }
            return a;
        };
        const auto sums = [&](const vectorArray& force)
        {
            const vectorArray a(overMass(force));
            return momenta(f, a.x, a.y, a.z);
        };
        const vectorArray a(randomVelocity(cloud)), b(randomVelocity(cloud));
        vectorArray Pa(a), Pb(b);
        test.model->project(Pa);
        test.model->project(Pb);

        const scalar size = norm(a);
        EXPECT_LT(mag(sums(Pa).linear - sums(a).linear), 1e-13*size);
        EXPECT_LT(mag(sums(Pa).angular - sums(a).angular), 1e-13*size);
        EXPECT_LT(sums(Pa).energy, sums(a).energy);

        // Symmetric in the metric 1/m, and a projection
        const scalar aPb = dot(a, overMass(Pb));
        EXPECT_NEAR(dot(b, overMass(Pa)), aPb, 1e-12*mag(aPb) + 1e-9);
        vectorArray again(Pa);
        test.model->project(again);
        again.add(-1, Pa);
        EXPECT_LT(norm(again), 1e-12*size);
    }
}


TEST(SolidModel, badInput)
{
    for
    (
        const std::string entries :
        {
            "",
            "type floating;",
            "type frozen; bondingDistance 0.5;",
            "type frozen; bondingDistance 2.5;",
            "type frozen; bondingDistance [0 1 0 0 0 0 0] 1;",
            "type rigid; friction -0.1;",
            "type rigid; friction high;",
            "type rigid; contactSweeps 0;",
            "type rigid; contactSweeps 1.5;",
            "type rigid; sticking perhaps;"
        }
    )
    {
        EXPECT_THROW(solidCase(movingLump(1), entries), Foam::IOerror)
            << entries;
    }
}


// The message names the schemes that go with solids
TEST(SolidModel, explicitForcesAreRefused)
{
    for (const std::string type : {"frozen", "rigid"})
    {
        try
        {
            schemeCase
            (
                movingLump(1),
                pressureAndViscosity() + " solids { type " + type + "; }"
            );
            FAIL() << type;
        }
        catch (const Foam::IOerror& error)
        {
            const std::string message(error.message());
            EXPECT_NE(message.find("incompressible"), std::string::npos);
        }
    }
    schemeCase
    (
        movingLump(1), pressureAndViscosity() + " solids { type viscous; }"
    );
}


TEST(SolidModel, viscousIsNoModel)
{
    particleCloud cloud(movingLump(1));
    schemeCase scheme(cloud, springAndDamper(1, 0));
    EXPECT_FALSE
    (
        solidModel::New
        (
            dictionary(IStringStream("type viscous;")()), scheme.system
        ).valid()
    );
}

// ************************************************************************* //
