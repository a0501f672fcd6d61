/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "adjointViscosity.H"
#include "meltSph/particleCloud/cloudVectors.H"
#include "meltSph/timeStep/schemeCase.H"
#include "pressureOperator.H"
#include "velocityProduct.H"

#include <gtest/gtest.h>

namespace Foam
{
namespace melt
{
namespace unitTest
{
namespace
{

//- Viscosity, central or adjoint, and pressure over a disordered lump
struct productCase
{
    particleCloud cloud;
    schemeCase scheme;
    autoPtr<viscousOperator> viscosity;
    pressureOperator pressure;
    velocityProduct product;

    productCase(const particleCloud& points, const std::string& type)
    :
        cloud(points),
        scheme(cloud, springAndDamper(1, 0)),
        viscosity
        (
            viscousOperator::New
            (
                dictionary
                (
                    IStringStream
                    (
                        "operator " + type
                      + "; centralShare 0.1; maxCondition 100;"
                    )()
                ),
                scheme.system
            )
        ),
        pressure(scheme.system, true, 100)
    {
        scheme.system.near = cloud.near;
        scheme.system.walls = cloud.walls;
        scheme.system.fluid = cloud.fluid;
        scheme.system.soundSpeed = 10;

        viscosity->update(1e-3);
        pressure.update(1e-3);
        implicitParts parts;
        EXPECT_TRUE(viscosity->describe(parts));
        EXPECT_TRUE(pressure.describe(parts));
        product.build(scheme.system, parts);
    }

    vectorArray apply(const vectorArray& v)
    {
        vectorArray Kv(v.size());
        product.apply(v, Kv);
        return Kv;
    }
};


particleCloud lump
(
    const unsigned seed,
    const bool wall,
    const smoothingKernel::kernelType kernel =
        smoothingKernel::kernelType::wendlandC2
)
{
    particleCloud cloud(lattice{{7, 8, 6}, 0.01, kernel, 1.3, 0.2}, seed);
    cloud.randomiseDensity(0.01);
    for (double& eta : cloud.fluid.eta)
    {
        eta = std::pow(10.0, cloud.random(-1, 3));
    }
    if (wall)
    {
        cloud.addWall(1, false);
        cloud.build();
    }
    return cloud;
}


class VelocityProduct
:
    public testing::TestWithParam<std::string>
{};

INSTANTIATE_TEST_SUITE_P
(
    Both, VelocityProduct, testing::Values("adjoint", "central")
);

} // End anonymous namespace


TEST_P(VelocityProduct, isThatOfTheOperatorsToSinglePrecision)
{
    for (const bool wall : {false, true})
    {
        productCase test(lump(3, wall), GetParam());
        const vectorArray v(randomVelocity(test.cloud));

        vectorArray expected(v.size());
        test.viscosity->addForce(v, 0, expected);
        test.pressure.addForce(v, 0, expected);
        const double scale = norm(expected);

        vectorArray difference(test.apply(v));
        difference.add(1, expected);
        EXPECT_GT(scale, 0);
        EXPECT_LT(norm(difference), 2e-6*scale);
    }
}


// The quintic spline falls to 1e-30 of itself before its support ends
TEST_P(VelocityProduct, isFiniteAtTheEndOfTheSupport)
{
    particleCloud cloud
    (
        lump(9, false, smoothingKernel::kernelType::quinticSpline)
    );
    double& x = cloud.fluid.x[0];
    const double support = cloud.near.kernel().support();
    for (const double share : {1 - 1e-5, 1 - 1e-7, 1 - 1e-10})
    {
        x = cloud.fluid.x[1] + share*support;
        cloud.fluid.y[0] = cloud.fluid.y[1];
        cloud.fluid.z[0] = cloud.fluid.z[1];
        productCase test(cloud, GetParam());
        const vectorArray Kv(test.apply(randomVelocity(cloud)));
        EXPECT_TRUE(std::isfinite(dot(Kv, Kv))) << share;
    }
}


// Pairs across the periods, and far from the origin
TEST_P(VelocityProduct, isThatOfTheOperatorsInAPeriodicBox)
{
    particleCloud cloud
    (
        lattice
        {
            {9, 8, 10}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3, 0.2,
            {true, false, true}
        },
        5
    );
    cloud.randomiseDensity(0.01);
    cloud.randomise(cloud.fluid.eta, 1, 100);
    productCase test(cloud, GetParam());
    const vectorArray v(randomVelocity(test.cloud));

    vectorArray expected(v.size());
    test.viscosity->addForce(v, 0, expected);
    test.pressure.addForce(v, 0, expected);

    vectorArray difference(test.apply(v));
    difference.add(1, expected);
    EXPECT_LT(norm(difference), 2e-6*norm(expected));
}


// Nothing of a pair
TEST_P(VelocityProduct, holdsLittle)
{
    productCase test(lump(6, false), GetParam());
    EXPECT_LE(test.product.bytes(), 80*test.cloud.size());
}


TEST_P(VelocityProduct, isSymmetricAndLetsALumpMove)
{
    productCase test(lump(4, false), GetParam());
    const vectorArray a(randomVelocity(test.cloud));
    const vectorArray b(randomVelocity(test.cloud));
    const vectorArray Ka(test.apply(a));
    const vectorArray Kb(test.apply(b));
    EXPECT_NEAR(dot(a, Kb), dot(b, Ka), 1e-6*norm(a)*norm(Kb));

    // A third is no float
    vectorArray translation(test.cloud.size());
    std::fill(translation.x.begin(), translation.x.end(), 1.0/3);
    EXPECT_EQ(norm(test.apply(translation)), 0);
}

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
