/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeSymbol.H"
#include "meltUnitTests.H"
#include "velocityGradient.H"

#include <cmath>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

using kernelType = smoothingKernel::kernelType;

const lattice lattices[] =
{
    {{22, 20, 1}, 0.01, kernelType::quinticSpline, 1.3},
    {{22, 20, 1}, 0.02, kernelType::wendlandC2, 1.7},
    {{11, 12, 13}, 0.01, kernelType::quinticSpline, 1.2},
    {{11, 10, 9}, 0.02, kernelType::wendlandC2, 1.2}
};

//- Velocity gradient without symmetry; the third row and column are left out
//  in two dimensions
double gradient(const lattice& points, const int a, const int b)
{
    static const double A[3][3] = {{3, -1, 2}, {5, -4, 0.5}, {1.5, -2, 2.5}};
    return a < points.dimensions() && b < points.dimensions() ? A[a][b] : 0;
}


void setLinearVelocity(particleCloud& cloud)
{
    cloud.setVelocity
    (
        [&](double x, double y, double z)
        {
            vector3 U{0.3, -0.7, 0};
            for (int a = 0; a < 3; ++a)
            {
                U[a] +=
                    gradient(cloud.points(), a, 0)*x
                  + gradient(cloud.points(), a, 1)*y
                  + gradient(cloud.points(), a, 2)*z;
            }
            return U;
        }
    );
}

//- Components of S
const int component[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};

} // End anonymous namespace


TEST(VelocityGradient, linearFieldOnLattice)
{
    for (const lattice& points : lattices)
    {
        const int d = points.dimensions();
        const double gain = gradientGain(points, 0);
        const bool quintic = points.kernel == kernelType::quinticSpline;
        EXPECT_NEAR(gain, 1, quintic ? 2e-3 : 0.02);

        particleCloud cloud(points);
        setLinearVelocity(cloud);
        const particles& f = cloud.fluid;
        velocityGradient(cloud.near, cloud.walls, cloud.fluid, true);

        double trace = 0;
        for (int a = 0; a < d; ++a)
        {
            trace += gradient(points, a, a);
        }
        int nInside = 0;
        for (int i = 0; i < cloud.size(); ++i)
        {
            if (!cloud.inside(i, cloud.near.kernel().support()))
            {
                continue;
            }
            ++nInside;
            ASSERT_NEAR(f.dRho[i], -f.rho[i]*gain*trace, 1e-9);
            for (int c = 0; c < 6; ++c)
            {
                const int a = component[c][0], b = component[c][1];
                const double D =
                    gradient(points, a, b) + gradient(points, b, a)
                  - (a == b && a < d ? 2*trace/d : 0);
                ASSERT_NEAR(f.S[c][i], gain*D, 1e-12) << "component " << c;
            }
        }
        EXPECT_GT(nInside, 20);
    }
}


// Disorder must not change the gain in the mean
TEST(VelocityGradient, linearFieldOnDisorderedLattice)
{
    for (lattice points : lattices)
    {
        points.jitter = 0.2;
        particleCloud cloud(points, 17);
        cloud.setVelocity
        (
            [&](double x, double, double) { return vector3{0, 2*x, 0}; }
        );
        velocityGradient(cloud.near, cloud.walls, cloud.fluid, true);

        double sum = 0;
        int n = 0;
        for (int i = 0; i < cloud.size(); ++i)
        {
            if (cloud.inside(i, cloud.near.kernel().support()))
            {
                sum += cloud.fluid.S[1][i];
                ++n;
            }
        }
        EXPECT_NEAR(sum/n, 2, 0.08);
    }
}


TEST(VelocityGradient, rigidMotionDoesNotDeform)
{
    for (const lattice& points : lattices)
    {
        particleCloud cloud(points);
        const double a = points.dimensions() == 2 ? 0 : 3;
        cloud.setVelocity
        (
            [&](double x, double y, double z)
            {
                return vector3{1 - 5*y + a*z, 5*x - 2*a*z, 2*a*y - a*x};
            }
        );
        velocityGradient(cloud.near, cloud.walls, cloud.fluid, true);

        for (int i = 0; i < cloud.size(); ++i)
        {
            if (cloud.inside(i, cloud.near.kernel().support()))
            {
                ASSERT_NEAR(cloud.fluid.dRho[i], 0, 1e-9);
                for (int c = 0; c < 6; ++c)
                {
                    ASSERT_NEAR(cloud.fluid.S[c][i], 0, 1e-12);
                }
            }
        }

        // Translation alone anywhere, also at the free surface
        cloud.setVelocity
        (
            [&](double, double, double) { return vector3{1, -2, 3}; }
        );
        cloud.fluid.S[1].assign(cloud.size(), 7);
        for (const double stress : {7, 0})
        {
            velocityGradient(cloud.near, cloud.walls, cloud.fluid, stress == 0);
            for (int i = 0; i < cloud.size(); ++i)
            {
                ASSERT_EQ(cloud.fluid.dRho[i], 0);
                ASSERT_EQ(cloud.fluid.S[1][i], stress);
            }
        }
    }
}


// Of the same velocities
TEST(VelocityGradient, givesTheShearRateAlone)
{
    particleCloud cloud(lattices[0], 3);
    setLinearVelocity(cloud);
    particles& f = cloud.fluid;
    velocityGradient(cloud.near, cloud.walls, f, true);
    const auto D = f.S;

    f.S = {};
    velocityGradient(cloud.near, cloud.walls, f, true);
    for (int i = 0; i < cloud.size(); ++i)
    {
        double square = 0;
        for (int c = 0; c < 6; ++c)
        {
            const bool diagonal = component[c][0] == component[c][1];
            square += (diagonal ? 0.5 : 1)*D[c][i]*D[c][i];
        }
        ASSERT_NEAR(f.shearRate[i], std::sqrt(square), 1e-12);
    }
}

// ************************************************************************* //
