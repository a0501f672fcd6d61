/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "blockSum.H"
#include "meltSph/particleCloud/cloudSums.H"
#include "meltSph/timeStep/schemeCase.H"
#include "meltUnitTests.H"

#include <cmath>
#include <omp.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

constexpr double spacing = 0.01;

const std::string shifting("shifting { type concentrationGradient; ");

//- Shifting alone: no forces
schemeCase shiftedOnly(const particleCloud& cloud, const std::string& more = "")
{
    return schemeCase
    (
        cloud,
        springAndDamper(0, 0) + shifting + more + " }",
        "particleShifting on;"
    );
}


particleCloud box
(
    const std::array<int, 3>& n,
    const double jitter,
    const std::array<bool, 3>& periodic
)
{
    lattice points{n, spacing};
    points.kernel = smoothingKernel::kernelType::wendlandC2;
    points.jitter = jitter;
    points.periodic = periodic;
    return particleCloud(points, 3);
}


double speed(const particles& f, const int i)
{
    return std::sqrt(f.du[i]*f.du[i] + f.dv[i]*f.dv[i] + f.dw[i]*f.dw[i]);
}


//- Move the particles as shifting says, over that many steps of dt [s] while
//  their velocities stay what they are
void relax(schemeCase& scheme, const int nSteps, const double dt)
{
    particles& f = scheme.system.fluid;
    for (int step = 0; step < nSteps; ++step)
    {
        scheme.scheme->start();
        for (int i = 0; i < f.size(); ++i)
        {
            f.x[i] += dt*f.du[i];
            f.y[i] += dt*f.dv[i];
            f.z[i] += dt*f.dw[i];
        }
        scheme.system.near.build(f, scheme.system.walls);
    }
}


//- Root of the mean square of C - 1, C = sum_j V_j W_ij with the particle itself
double disorder(const schemeCase& scheme)
{
    const particles& f = scheme.system.fluid;
    const neighbourhood& near = scheme.system.near;
    double sum = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        double C = 0;
        near.visit([&](const auto& W, const auto& space)
        {
            for (int j = 0; j < f.size(); ++j)
            {
                double dx = f.x[i] - f.x[j];
                double dy = f.y[i] - f.y[j];
                double dz = f.z[i] - f.z[j];
                space.nearestImage(dx, dy, dz);
                C += f.m[j]/f.rho[j]*W.value(dx*dx + dy*dy + dz*dz);
            }
        });
        sum += (C - 1)*(C - 1);
    }
    return std::sqrt(sum/f.size());
}


double highest(const particles::array& a)
{
    return *std::max_element(a.begin(), a.end());
}


double lowest(const particles::array& a)
{
    return *std::min_element(a.begin(), a.end());
}


std::string incompressibleNumerics()
{
    return
        "scheme incompressible;"
        " pressure { type implicitPressure; speedOfSound 10; }"
        " viscosity { type implicitViscosity; operator central; }"
        " implicit { tolerance 1e-6; maxIterations 4000; }"
        " timeStep { force 1; advective 1e6; density 1e6; }";
}

} // End anonymous namespace


TEST(ParticleShifting, leavesALatticeThatIsSheared)
{
    particleCloud cloud(box({7, 8, 6}, 0, {true, true, true}));
    cloud.randomiseVelocity(1);
    schemeCase scheme(shiftedOnly(cloud));
    scheme.scheme->start();
    EXPECT_LT(highest(scheme.system.fluid.du), 1e-12);
    EXPECT_GT(lowest(scheme.system.fluid.dw), -1e-12);
}


// In any frame of reference: what falls and turns
TEST(ParticleShifting, leavesWhatMovesAsABody)
{
    particleCloud cloud(box({7, 7, 6}, 0.2, {false, false, false}));
    cloud.setVelocity
    (
        [](double x, double y, double)
        {
            return vector3{1 - 3*y, -2 + 3*x, 0.5};
        }
    );
    schemeCase scheme(shiftedOnly(cloud));
    scheme.scheme->start();
    const particles& f = scheme.system.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        ASSERT_LT(speed(f, i), 1e-12);
    }
}


TEST(ParticleShifting, ordersADisturbedLattice)
{
    for (const int nz : {6, 1})
    {
        particleCloud cloud(box({8, 7, nz}, 0.25, {true, true, nz > 1}));
        cloud.setVelocity
        (
            [](double x, double, double)
            {
                return vector3{0, std::sin(2*M_PI*x/0.08), 0};
            }
        );
        schemeCase scheme(shiftedOnly(cloud));
        const double before = disorder(scheme);
        relax(scheme, 40, 0.1*spacing);
        const double after = disorder(scheme);
        RecordProperty
        (
            nz > 1 ? "space" : "plane", std::to_string(after/before)
        );
        EXPECT_LT(after, 0.25*before) << nz;
    }
}


TEST(ParticleShifting, isLimited)
{
    particleCloud cloud(box({8, 7, 6}, 0.3, {false, false, true}));
    cloud.randomiseVelocity(0.5);
    schemeCase scheme
    (
        shiftedOnly(cloud, "coefficient 1000; maxSpeed 0.25;")
    );
    scheme.scheme->start();
    const particles& f = scheme.system.fluid;
    double fastest = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        // Differences of two velocities of components within 0.5
        ASSERT_LE(speed(f, i), 0.25*std::sqrt(3.0)*(1 + 1e-12));
        fastest = std::max(fastest, speed(f, i));
    }
    EXPECT_GT(fastest, 0.2);
}


// A slab between two free surfaces, disturbed and sheared: it gets order inside
// and does not get thicker
TEST(ParticleShifting, keepsAFreeSurfaceFlat)
{
    const auto slab = [](const std::string& more, const double jitter)
    {
        particleCloud cloud(box({7, 7, 10}, jitter, {true, true, false}));
        cloud.setVelocity
        (
            [](double, double, double z) { return vector3{10*z, 0, 0}; }
        );
        return shiftedOnly(cloud, more);
    };
    const auto thickness = [](const schemeCase& scheme)
    {
        return highest(scheme.system.fluid.z) - lowest(scheme.system.fluid.z);
    };

    // Flat: to round-off
    schemeCase flat(slab("", 0));
    relax(flat, 40, 0.3*spacing);
    EXPECT_NEAR(thickness(flat)/spacing, 9, 1e-10);

    schemeCase disturbed(slab("", 0.1));
    const double before = thickness(disturbed);
    relax(disturbed, 40, 0.3*spacing);
    const double growth = (thickness(disturbed) - before)/spacing;
    RecordProperty("growth", std::to_string(growth));
    EXPECT_LT(growth, 0.1);

    // Without the surface it would
    schemeCase blownUp(slab("surface 0;", 0.1));
    relax(blownUp, 40, 0.3*spacing);
    EXPECT_GT((thickness(blownUp) - before)/spacing, 1);
}


TEST(ParticleShifting, leavesSolids)
{
    particleCloud cloud(box({6, 6, 6}, 0.2, {true, true, true}));
    cloud.randomiseVelocity(1);
    schemeCase scheme(shiftedOnly(cloud));
    particles& f = scheme.system.fluid;
    f.body.assign(f.size(), -1);
    f.body[17] = 3;
    scheme.scheme->start();
    EXPECT_EQ(speed(f, 17), 0);
    EXPECT_GT(speed(f, 18), 0);
}


// Linear momentum is exact; positions alone are shifted, so that angular momentum
// changes by sum m du x v
TEST(ParticleShifting, keepsLinearMomentum)
{
    const auto angularMomentum = [](const particles& f)
    {
        double sum = 0;
        for (int i = 0; i < f.size(); ++i)
        {
            sum += f.m[i]*(f.x[i]*f.v[i] - f.y[i]*f.u[i]);
        }
        return sum;
    };
    particleCloud cloud(box({7, 7, 7}, 0.1, {false, false, false}));
    cloud.setVelocity
    (
        [](double x, double y, double)
        {
            return vector3{-3*(y - 0.035), x - 0.035, 0};
        }
    );
    schemeCase scheme
    (
        cloud,
        incompressibleNumerics() + shifting + "}",
        "particleShifting on;"
    );
    const particles& f = scheme.system.fluid;
    const auto momentum = massSum(f, f.u, f.v, f.w);
    const double scale = massSumMag(f, f.u, f.v, f.w);
    const double turning = angularMomentum(f);
    scheme.run(0.2, 20);

    const auto after = massSum(f, f.u, f.v, f.w);
    for (int a = 0; a < 3; ++a)
    {
        EXPECT_NEAR(after[a], momentum[a], 1e-12*scale);
    }
    const double change = angularMomentum(f)/turning - 1;
    RecordProperty("angularMomentum", std::to_string(change));
    EXPECT_LT(std::abs(change), 0.03);
    EXPECT_NE(change, 0);
}


TEST(ParticleShifting, sameBytesWithAnyNumberOfThreads)
{
    const int before = omp_get_max_threads();
    std::vector<particles> results;
    for (const int nThreads : {1, 2, 3})
    {
        omp_set_num_threads(nThreads);
        particleCloud cloud(box({9, 7, 8}, 0.2, {true, true, false}));
        cloud.randomiseVelocity(0.3);
        schemeCase scheme
        (
            cloud,
            incompressibleNumerics() + shifting + "}",
            "particleShifting on;"
        );
        scheme.run(0.02, 3);
        results.push_back(scheme.system.fluid);
    }
    omp_set_num_threads(before);
    for (const particles& f : results)
    {
        EXPECT_EQ(f.x, results[0].x);
        EXPECT_EQ(f.dw, results[0].dw);
    }
}


TEST(ParticleShifting, isOffUnlessAskedFor)
{
    const particleCloud cloud(box({5, 5, 5}, 0, {false, false, false}));
    const std::string numerics(springAndDamper(0, 0) + shifting + "}");
    EXPECT_TRUE(schemeCase(cloud, numerics).system.fluid.du.empty());
    EXPECT_FALSE
    (
        schemeCase(cloud, numerics, "particleShifting on;")
       .system.fluid.du.empty()
    );
}


TEST(ParticleShifting, rejectsBadInput)
{
    const particleCloud cloud(box({5, 5, 5}, 0, {false, false, false}));
    const auto make = [&](const std::string& numerics, const std::string& effects)
    {
        schemeCase(cloud, springAndDamper(0, 0) + numerics, effects);
    };
    const std::string on("particleShifting on;");
    for (const char* entry : {"coefficient 0;", "maxSpeed 2;", "surface -1;"})
    {
        EXPECT_THROW(make(shifting + entry + "}", on), IOerror) << entry;
    }
    EXPECT_THROW(make("shifting { type unheardOf; }", on), IOerror);
    EXPECT_THROW(make("", on), IOerror);
    EXPECT_THROW
    (
        make
        (
            shifting + "} XSPH { type monaghanXSPH; epsilon 0.5; }",
            on + "XSPH on;"
        ),
        IOerror
    );
}

// ************************************************************************* //
