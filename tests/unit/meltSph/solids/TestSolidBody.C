/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidCase.H"

#include <gtest/gtest.h>
#include <numeric>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

solidBody bodyOf(const particles& f)
{
    solidBody body;
    body.members.resize(f.size());
    std::iota(body.members.begin(), body.members.end(), 0);
    body.setGeometry(f);
    return body;
}


vector randomVector(particleCloud& cloud, const double size)
{
    const double x = cloud.random(-size, size);
    const double y = cloud.random(-size, size);
    return vector(x, y, cloud.random(-size, size));
}


scalar spinEnergy(const solidBody& body)
{
    return 0.5*(body.L & (body.inverseInertia & body.L));
}

} // End anonymous namespace


// n points a distance d apart along an edge have M d^2 (n^2 - 1)/12 about
// their middle: a box of edges a, b, c less the particles' own extent
TEST(SolidBody, massCentreAndInertiaOfABox)
{
    const double d = 0.01;
    const std::array<int, 3> n{7, 4, 3};
    const particleCloud cloud
    (
        lattice{n, d, smoothingKernel::kernelType::wendlandC2, 1.3, 0}
    );
    const solidBody body(bodyOf(cloud.fluid));

    const double M = 1000*d*d*d*7*4*3;
    EXPECT_NEAR(body.mass, M, 1e-13*M);
    EXPECT_LT(mag(body.centre - vector(0.035, 0.02, 0.015)), 1e-15);

    std::array<double, 3> moment;
    for (int a = 0; a < 3; ++a)
    {
        moment[a] = M*d*d*(n[a]*n[a] - 1)/12;
    }
    const symmTensor exact
    (
        moment[1] + moment[2], 0, 0,
        moment[0] + moment[2], 0,
        moment[0] + moment[1]
    );
    EXPECT_LT(mag(body.inertia - exact), 1e-13*mag(exact));
    EXPECT_LT
    (
        mag((body.inertia & body.inverseInertia) - tensor::I), 1e-13
    );
}


TEST(SolidBody, motionOfARandomRigidMotion)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        particleCloud cloud(movingLump(seed));
        particles& f = cloud.fluid;
        solidBody body(bodyOf(f));
        const vector V(randomVector(cloud, 2));
        const vector omega(randomVector(cloud, 30));
        body.U = V;
        body.L = body.inertia & omega;
        body.setVelocities(f, f.u, f.v, f.w);

        for (const int i : {0, f.size()/2, f.size() - 1})
        {
            const vector exact(V + (omega ^ body.arm(f, i)));
            EXPECT_LT(mag(vector(f.u[i], f.v[i], f.w[i]) - exact), 1e-13);
        }
        body.setMotion(f, f.u, f.v, f.w);
        EXPECT_LT(mag(body.U - V), 1e-13);
        EXPECT_LT(mag(body.omega() - omega), 1e-11);
    }
}


TEST(SolidBody, projectionKeepsMomentaLosesEnergyAndIsIdempotent)
{
    for (unsigned seed = 1; seed <= 30; ++seed)
    {
        particleCloud cloud(movingLump(seed));
        particles& f = cloud.fluid;
        const momenta before(f);
        const scalar size = std::sqrt(2*before.energy*f.m[0]*f.size());

        solidBody body(bodyOf(f));
        body.setMotion(f, f.u, f.v, f.w);
        body.setVelocities(f, f.u, f.v, f.w);
        const momenta after(f);
        EXPECT_LT(mag(after.linear - before.linear), 1e-13*size);
        EXPECT_LT(mag(after.angular - before.angular), 1e-14*size);
        EXPECT_LT(after.energy, before.energy);

        const std::vector<double> u(f.u);
        body.setMotion(f, f.u, f.v, f.w);
        body.setVelocities(f, f.u, f.v, f.w);
        for (int i = 0; i < f.size(); ++i)
        {
            ASSERT_NEAR(f.u[i], u[i], 1e-14);
        }
    }
}


// One particle does not spin, a row of them not about itself
TEST(SolidBody, degenerateInertia)
{
    for (const int n : {1, 2, 5})
    {
        particleCloud cloud(movingLump(n, {n, 1, 2}));
        particles& f = cloud.fluid;
        solidBody body;
        for (int i = 0; i < f.size(); ++i)
        {
            if (f.id[i] < n)
            {
                f.x[i] = 0.01*f.id[i];
                f.y[i] = 2*f.x[i];
                f.z[i] = -f.x[i];
                body.members.push_back(i);
            }
        }
        body.setGeometry(f);
        const symmTensor& I = body.inertia;
        const tensor again(I & body.inverseInertia & I);
        EXPECT_LT(mag(again - I), 1e-12*mag(I) + VSMALL);

        body.setMotion(f, f.u, f.v, f.w);
        const vector U(body.U);
        body.setVelocities(f, f.u, f.v, f.w);
        for (const int i : body.members)
        {
            EXPECT_TRUE(std::isfinite(f.u[i] + f.v[i] + f.w[i]));
        }
        body.setMotion(f, f.u, f.v, f.w);
        EXPECT_LT(mag(body.U - U), 1e-14);
    }
}


TEST(SolidBody, movesWithoutChangeOfShape)
{
    particleCloud cloud(movingLump(5));
    particles& f = cloud.fluid;
    solidBody body(bodyOf(f));
    body.U = vector(1, 2, 3);
    body.L = body.inertia & vector(20, -30, 40);
    const particles start(f);
    const vector centre(body.centre);
    for (int step = 0; step < 50; ++step)
    {
        body.move(f, 0.01);
    }

    const auto distance = [](const particles& p, const int i, const int j)
    {
        return std::hypot(p.x[i] - p.x[j], p.y[i] - p.y[j], p.z[i] - p.z[j]);
    };
    for (int i = 1; i < f.size(); ++i)
    {
        ASSERT_NEAR(distance(f, 0, i), distance(start, 0, i), 1e-14);
    }
    EXPECT_LT(mag(body.centre - centre - 0.5*vector(1, 2, 3)), 1e-13);
    const solidBody fresh(bodyOf(f));
    EXPECT_LT(mag(fresh.centre - body.centre), 1e-13);
    EXPECT_LT(mag(fresh.inertia - body.inertia), 1e-12*mag(body.inertia));
}


// A box that tumbles about its middle axis: the angular momentum stands, and
// the energy errs by the square of the step
TEST(SolidBody, tumblesWithSecondOrder)
{
    const auto error = [](const label n)
    {
        particleCloud cloud(movingLump(1, {8, 5, 2}));
        particles& f = cloud.fluid;
        solidBody body(bodyOf(f));
        body.L = body.inertia & vector(0.3, 10, 0.2);
        const scalar before = spinEnergy(body);
        for (label step = 0; step < n; ++step)
        {
            body.move(f, 0.5/n);
        }
        return mag(spinEnergy(body)/before - 1);
    };
    const scalar coarse = error(40);
    EXPECT_LT(coarse, 1e-2);
    const scalar ratio = coarse/error(160);
    EXPECT_GT(ratio, 10);
    EXPECT_LT(ratio, 25);
}

// ************************************************************************* //
