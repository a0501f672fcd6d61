/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeSymbol.H"
#include "meltUnitTests.H"
#include "pressureForce.H"
#include "wallExtrapolation.H"

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
    {{11, 12, 13}, 0.01, kernelType::quinticSpline, 1.2},
    {{11, 10, 9}, 0.02, kernelType::wendlandC2, 1.2}
};

} // End anonymous namespace


TEST(PressureForce, linearPressureOnLattice)
{
    for (const lattice& points : lattices)
    {
        particleCloud cloud(points);
        particles& f = cloud.fluid;
        const double gain = gradientGain(points, 0);
        const bool plane = points.dimensions() == 2;
        const vector3 gradient{300, -500, plane ? 0.0 : 700};

        for (int i = 0; i < cloud.size(); ++i)
        {
            f.p[i] =
                100 + gradient[0]*f.x[i] + gradient[1]*f.y[i]
              + gradient[2]*f.z[i];
            f.ax[i] = 1;
        }
        addPressureForce(cloud.near, cloud.walls, f);

        for (int i = 0; i < cloud.size(); ++i)
        {
            if (cloud.inside(i, cloud.near.kernel().support()))
            {
                ASSERT_NEAR(f.ax[i], 1 - gain*gradient[0]/1000, 1e-12);
                ASSERT_NEAR(f.ay[i], -gain*gradient[1]/1000, 1e-12);
                ASSERT_NEAR(f.az[i], -gain*gradient[2]/1000, 1e-12);
            }
        }
    }
}


// Pressure drives particles at a free surface outwards
TEST(PressureForce, pushesApart)
{
    particleCloud cloud(lattice{{2, 1, 1}, 0.01});
    cloud.fluid.p = {5, 7};
    addPressureForce(cloud.near, cloud.walls, cloud.fluid);

    const quinticSpline W(0.013, 2);
    const double force = -1e-4*12*W.gradientOverR(1e-4)*0.01/1000;
    EXPECT_GT(force, 0);
    EXPECT_DOUBLE_EQ(cloud.fluid.ax[0], -force);
    EXPECT_DOUBLE_EQ(cloud.fluid.ax[1], force);
    EXPECT_EQ(cloud.fluid.ay[0], 0);
}


// Melt at rest under gravity: with the walls' extrapolated pressure every
// particle but those near the other sides is held as one in the interior is
TEST(PressureForce, wallCarriesHydrostaticPressure)
{
    for (const lattice& points : lattices)
    {
        const int vertical = points.dimensions() - 1;
        particleCloud cloud(points);
        cloud.addWall(vertical, false);
        cloud.build();
        particles& f = cloud.fluid;
        const particles::array& height = vertical == 2 ? f.z : f.y;
        const particles::array& a = vertical == 2 ? f.az : f.ay;

        const double g = 9.81;
        const double H = points.n[vertical]*points.spacing;
        for (int i = 0; i < cloud.size(); ++i)
        {
            f.p[i] = f.rho[i]*g*(H - height[i]);
        }
        vector3 gravity{0, 0, 0};
        gravity[vertical] = -g;
        wallExtrapolation(cloud.near, f, gravity, cloud.walls);
        addPressureForce(cloud.near, cloud.walls, f);

        const double gain = gradientGain(points, 0);
        const double support = cloud.near.kernel().support();
        int nAtWall = 0;
        for (int i = 0; i < cloud.size(); ++i)
        {
            const double x = f.x[i], y = vertical == 2 ? f.y[i] : support;
            const double Ly =
                vertical == 2 ? points.n[1]*points.spacing : 2*support;
            if
            (
                x > support && x < points.n[0]*points.spacing - support
             && y >= support && y <= Ly - support
             && height[i] < H - support
            )
            {
                nAtWall += height[i] < points.spacing;
                ASSERT_NEAR(a[i], gain*g, 1e-9) << "height " << height[i];
                ASSERT_NEAR(f.ax[i], 0, 1e-9);
            }
        }
        EXPECT_GT(nAtWall, 8);
    }
}


// Drawn-apart melt at a wall: its pressure is negative, the wall does not pull
TEST(PressureForce, wallDoesNotPull)
{
    const lattice points
    {
        {6, 6, 6}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.2
    };
    particleCloud atWall(points);
    atWall.addWall(1, false);
    atWall.build();
    particleCloud alone(points);

    for (particleCloud* cloud : {&atWall, &alone})
    {
        particles& f = cloud->fluid;
        std::fill(f.p.begin(), f.p.end(), -100);
        wallExtrapolation(cloud->near, f, {0, 0, 0}, cloud->walls);
        addPressureForce(cloud->near, cloud->walls, f);
    }
    for (int i = 0; i < alone.size(); ++i)
    {
        ASSERT_EQ(atWall.fluid.id[i], alone.fluid.id[i]);
        ASSERT_NEAR(atWall.fluid.ay[i], alone.fluid.ay[i], 1e-12);
    }
}

// ************************************************************************* //
