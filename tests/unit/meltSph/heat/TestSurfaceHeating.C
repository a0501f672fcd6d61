/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/timeStep/schemeCase.H"
#include "meltUnitTests.H"
#include "StringStream.H"
#include "surfaceHeating.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

//- A block of 0.24 x 0.24 x 0.12 m
const lattice block{{24, 24, 12}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3};

const double a = 0.24, c = 0.12;

dictionary scene(const string& sources)
{
    return dictionary(IStringStream("heatSources { " + sources + " }")());
}


//- At 300 K
void prepare(sphSystem& s)
{
    particles& f = s.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        f.V[i] = f.m[i]/f.rho[i];
        f.T[i] = 300;
        f.h[i] = s.thermo.enthalpy().h(300);
    }
}

} // End anonymous namespace


TEST(SurfaceHeating, areasAndNormalsOfABlock)
{
    particleCloud cloud(block);
    schemeCase test(cloud, springAndDamper(1, 0));
    prepare(test.system);
    const dictionary none;
    surfaceHeating heating(none, test.system);
    EXPECT_FALSE(heating.active());

    const surfaceElements e(heating.elements());
    // Edges and corners are rounded
    EXPECT_NEAR(sum(e.area)/(2*a*a + 4*a*c), 1, 0.12);

    // Below a square in the middle of the top
    scalar top = 0;
    forAll(e.position, k)
    {
        const point& p = e.position[k];
        if (mag(p.x() - a/2) < 0.05 && mag(p.y() - a/2) < 0.05 && p.z() > c/2)
        {
            top += e.area[k];
            EXPECT_NEAR(e.normal[k].z(), 1, 1e-6);
        }
    }
    EXPECT_NEAR(top/0.01, 1, 1e-9);
}


// A lamp high above the block lights the top by its solid angle, and the sides
// and the bottom not at all
TEST(SurfaceHeating, lampLightsTheTop)
{
    particleCloud cloud(block);
    schemeCase test(cloud, springAndDamper(1, 0));
    sphSystem& s = test.system;
    prepare(s);
    const dictionary lamp
    (
        scene("lamp { type pointSource; position (0.12 0.12 1.12); power 50; }")
    );
    surfaceHeating heating(lamp, s);
    const scalar power = heating.heat(0, 1);

    const scalar angle = 4*std::asin(sqr(a/2)/(sqr(a/2) + 1));
    EXPECT_NEAR(power/(50*angle/(4*M_PI)), 1, 0.1);

    scalar total = 0, below = 0;
    for (int i = 0; i < s.fluid.size(); ++i)
    {
        const scalar q =
            (s.fluid.h[i] - s.thermo.enthalpy().h(300))*s.fluid.m[i];
        total += q;
        below += s.fluid.z[i] < c/2 ? q : 0;
    }
    EXPECT_NEAR(total/power, 1, 1e-10);
    EXPECT_LT(below, 1e-3*power);
}


TEST(SurfaceHeating, ovenAndVolume)
{
    particleCloud cloud(block);
    schemeCase test(cloud, springAndDamper(1, 0));
    sphSystem& s = test.system;
    prepare(s);
    const dictionary oven(scene("air { type oven; temperature 400; h 10; }"));
    EXPECT_NEAR
    (
        surfaceHeating(oven, s).heat(0, 1e-6)/(1e-3*(2*a*a + 4*a*c)), 1, 0.12
    );
    const dictionary volume
    (
        scene
        (
            "v { type volumetricSource; box ((-1 -1 -1) (1 1 1));"
            " powerDensity 100; }"
        )
    );
    EXPECT_NEAR
    (
        surfaceHeating(volume, s).heat(0, 1)/(100*a*a*c), 1, 1e-9
    );
}

// ************************************************************************* //
