/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "adjointViscosity.H"
#include "meltSph/particleCloud/cloudVectors.H"
#include "pressureOperator.H"
#include "solidCase.H"
#include "velocityProduct.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

//- The implicit forces on liquid around a solid core
struct coreCase
{
    particleCloud cloud;
    solidCase scene;
    autoPtr<viscousOperator> viscosity;
    pressureOperator pressure;

    coreCase
    (
        const particleCloud& points,
        const word& type,
        const std::function<bool(double, double, double)>& core
    )
    :
        cloud(points),
        scene(cloud),
        pressure(scene.system, true, 100)
    {
        particles& f = scene.f;
        f.require({&f.eta, &f.dH});
        scene.setSolid(core);
        scene.system.soundSpeed = 10;
        scene.model->update();
        for (double& eta : f.eta)
        {
            eta = std::pow(10.0, cloud.random(-1, 3));
        }
        scene.model->setProperties();
        viscosity = viscousOperator::New
        (
            dictionary
            (
                IStringStream
                (
                    "operator " + type
                  + "; centralShare 0.1; maxCondition 100;"
                )()
            ),
            scene.system
        );
    }

    int nIdle() const
    {
        int n = 0;
        for (int i = 0; i < scene.f.size(); ++i)
        {
            n += scene.system.near.idle(i);
        }
        return n;
    }

    //- Forces of velocities that are rigid within the core
    vectorArray force(const vectorArray& v)
    {
        vectorArray F(v.size());
        viscosity->update(1e-3);
        pressure.update(1e-3);
        viscosity->addForce(v, 1, F);
        pressure.addForce(v, 1, F);
        return F;
    }

    vectorArray product(const vectorArray& v)
    {
        implicitParts parts;
        viscosity->describe(parts);
        pressure.describe(parts);
        velocityProduct product;
        product.build(scene.system, parts);
        vectorArray Kv(v.size());
        product.apply(v, Kv);
        return Kv;
    }
};


class ActiveSet
:
    public testing::TestWithParam<std::string>
{};

INSTANTIATE_TEST_SUITE_P(Both, ActiveSet, testing::Values("adjoint", "central"));

} // End anonymous namespace


TEST_P(ActiveSet, forcesAreThoseOfAllPairs)
{
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
        coreCase test
        (
            movingLump(seed, {13, 12, 11}),
            GetParam(),
            [](const double x, const double y, const double z)
            {
                return
                    std::hypot(x - 0.065, y - 0.06, z - 0.055) < 0.052;
            }
        );
        const particles& f = test.scene.f;
        EXPECT_GT(test.nIdle(), 30);

        vectorArray v(f.size());
        v.x = f.u;
        v.y = f.v;
        v.z = f.w;
        const neighbourhood& near = test.scene.system.near;
        const std::uint64_t start = near.pairVisits();
        const vectorArray active(test.force(v));
        const std::uint64_t visits = near.pairVisits() - start;
        vectorArray product(test.product(v));

        // Every solid particle a body of its own: none is idle
        std::vector<int> body(f.body);
        for (int i = 0; i < f.size(); ++i)
        {
            body[i] = body[i] < 0 ? -1 : i;
        }
        test.scene.system.near.setSolids(body);
        const vectorArray all(test.force(v));
        EXPECT_LT(visits, near.pairVisits() - start - visits);
        EXPECT_GT(norm(all), 0);
        for (int i = 0; i < f.size(); ++i)
        {
            ASSERT_NEAR(active.x[i], all.x[i], 1e-13*norm(all));
            ASSERT_NEAR(active.y[i], all.y[i], 1e-13*norm(all));
        }

        // Without sources; of a body its sums alone count
        vectorArray expected(f.size());
        test.viscosity->addForce(v, 0, expected);
        test.pressure.addForce(v, 0, expected);
        product.add(1, expected);
        test.scene.model->project(product);
        EXPECT_LT(norm(product), 3e-6*norm(expected));
    }
}


// Shear of a layer of liquid on a solid, which must take the stress. Of the
// linear profile given here central passes on 0.86, adjoint, whose gradient is
// that of both sides of the kink, 0.50: a slip of about a spacing. Both momenta
// stay
TEST_P(ActiveSet, solidsTakeTheStressOfLiquid)
{
    const double spacing = 0.01, eta = 10, surface = 0.06;
    coreCase test
    (
        particleCloud
        (
            lattice
            {
                {13, 12, 13}, spacing,
                smoothingKernel::kernelType::wendlandC2, 1.3, 0
            }
        ),
        GetParam(),
        [&](double, const double y, double) { return y < surface; }
    );
    particles& f = test.scene.f;
    std::fill(f.eta.begin(), f.eta.end(), eta);
    test.scene.model->setProperties();

    vectorArray v(f.size());
    for (int i = 0; i < f.size(); ++i)
    {
        v.x[i] = max(f.y[i] - surface, 0.0);
    }
    vectorArray F(f.size());
    test.viscosity->update(1e-3);
    test.viscosity->addForce(v, 0, F);

    // Of 5 x 5 columns in the middle
    double onSolid = 0;
    vector sum(Zero), torque(Zero);
    for (int i = 0; i < f.size(); ++i)
    {
        const vector force(F.x[i], F.y[i], F.z[i]);
        sum += force;
        torque += vector(f.x[i], f.y[i], f.z[i]) ^ force;
        if
        (
            test.scene.model->solid(i)
         && mag(f.x[i] - 0.065) < 0.025 && mag(f.z[i] - 0.065) < 0.025
        )
        {
            onSolid += force.x();
        }
    }
    const double exact = eta*sqr(5*spacing);
    EXPECT_GT(onSolid, (GetParam() == "central" ? 0.8 : 0.45)*exact);
    EXPECT_LT(onSolid, 1.3*exact);
    EXPECT_LT(mag(sum), 1e-12*exact);
    EXPECT_LT(mag(torque), 1e-13*exact);
}

// ************************************************************************* //
