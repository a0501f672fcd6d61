/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltSph/particleCloud/cloudSums.H"
#include "meltUnitTests.H"
#include "particleCollision.H"
#include "schemeCase.H"

#include <cmath>
#include <omp.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

constexpr double spacing = 0.01;

//- Longest step in which nothing moves by more than half a spacing
constexpr double deltaT = 0.005;


schemeCase still(const particleCloud& cloud, const std::string& more = "")
{
    return schemeCase(cloud, springAndDamper(0, 0) + more);
}


//- Two particles at -r/2 and r/2 along x [m] with their velocities along it
schemeCase pairOf(const double r, const double left, const double right)
{
    particleCloud cloud(lattice{{2, 1, 2}, spacing});
    particles& f = cloud.fluid;
    f.x = {-r/2, r/2, 1, 2};
    f.y = {0, 0, 0, 0};
    f.z = {0, 0, 0, 0};
    f.u = {left, right, 0, 0};
    cloud.build();
    return still(cloud);
}


//- Disorder with pairs at any distance, masses that differ by up to 3
particleCloud crowd
(
    const unsigned seed,
    const std::array<bool, 3>& periodic = {false, false, false}
)
{
    lattice points{{9, 8, 7}, spacing};
    points.jitter = 0.6;
    points.periodic = periodic;
    particleCloud cloud(points, seed);
    cloud.randomiseVelocity(0.5);
    for (int i = 0; i < cloud.fluid.size(); ++i)
    {
        cloud.fluid.m[i] *= 1 + cloud.fluid.id[i]%3;
    }
    return cloud;
}


void collide
(
    sphSystem& system,
    const std::string& entries = "",
    const double dt = deltaT
)
{
    const dictionary dict{IStringStream(entries)()};
    particleCollision(dict, system).collide(dt);
}


double kineticEnergy(const particles& f)
{
    double sum = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        sum += 0.5*f.m[i]*(sqr(f.u[i]) + sqr(f.v[i]) + sqr(f.w[i]));
    }
    return sum;
}


vector3 angularMomentum(const particles& f)
{
    vector3 sum{};
    for (int i = 0; i < f.size(); ++i)
    {
        sum[0] += f.m[i]*(f.y[i]*f.w[i] - f.z[i]*f.v[i]);
        sum[1] += f.m[i]*(f.z[i]*f.u[i] - f.x[i]*f.w[i]);
        sum[2] += f.m[i]*(f.x[i]*f.v[i] - f.y[i]*f.u[i]);
    }
    return sum;
}


//- By how much the worst pair gets nearer within dt [s] than 0.4 spacings, or
//  than it is [spacings]
double trespass(const particles& f, const double dt)
{
    double worst = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        for (int j = i + 1; j < f.size(); ++j)
        {
            const double x = f.x[i] - f.x[j], u = f.u[i] - f.u[j];
            const double y = f.y[i] - f.y[j], v = f.v[i] - f.v[j];
            const double z = f.z[i] - f.z[j], w = f.w[i] - f.w[j];
            const double before = std::sqrt(x*x + y*y + z*z);
            const double after = std::sqrt
            (
                sqr(x + dt*u) + sqr(y + dt*v) + sqr(z + dt*w)
            );
            worst = std::max
            (
                worst,
                (std::min(before, 0.4*spacing) - after)/spacing
            );
        }
    }
    return worst;
}

} // End anonymous namespace


// Inelastic, whatever the masses: the pair goes on together
TEST(ParticleCollision, stopsAPairThatIsTooNear)
{
    schemeCase scheme(pairOf(0.3*spacing, 1, -0.5));
    particles& f = scheme.system.fluid;
    const int left = scheme.indexOf(0), right = scheme.indexOf(1);
    f.m[right] *= 3;
    f.v[left] = 0.2;
    collide(scheme.system);
    EXPECT_NEAR(f.u[left], (1 - 3*0.5)/4, 1e-14);
    EXPECT_NEAR(f.u[right], (1 - 3*0.5)/4, 1e-14);
    EXPECT_EQ(f.v[left], 0.2);
    EXPECT_EQ(f.v[right], 0);
}


TEST(ParticleCollision, letsAPairComeAsNearAsTheDistance)
{
    schemeCase scheme(pairOf(0.7*spacing, 0.5, -0.5));
    const particles& f = scheme.system.fluid;
    collide(scheme.system, "distance 0.4;");
    EXPECT_NEAR
    (
        deltaT*(f.u[scheme.indexOf(0)] - f.u[scheme.indexOf(1)]),
        0.3*spacing,
        1e-14
    );
}


TEST(ParticleCollision, leavesWhatDoesNotMeet)
{
    const auto unchanged = [](schemeCase scheme)
    {
        const particles before = scheme.system.fluid;
        collide(scheme.system);
        return scheme.system.fluid.u == before.u
         && scheme.system.fluid.v == before.v;
    };
    // They part; do not get there in this step; are together; are at one point
    EXPECT_TRUE(unchanged(pairOf(0.3*spacing, -0.5, 0.5)));
    EXPECT_TRUE(unchanged(pairOf(0.7*spacing, 0.02, -0.02)));
    EXPECT_TRUE(unchanged(pairOf(0.3*spacing, 0.7, 0.7)));
    EXPECT_TRUE(unchanged(pairOf(0, 0.5, -0.5)));

    // They pass each other
    schemeCase passing(pairOf(0.9*spacing, 0.5, -0.5));
    passing.system.fluid.v[passing.indexOf(0)] = 1;
    EXPECT_TRUE(unchanged(std::move(passing)));
}


// Up to a dozen contacts a particle
TEST(ParticleCollision, keepsBothMomentaAndGainsNoEnergy)
{
    for (const unsigned seed : {1, 2, 3})
    {
        for (const char* sweeps : {"1", "2", "20"})
        {
            schemeCase scheme(still(crowd(seed)));
            particles& f = scheme.system.fluid;
            const auto momentum = massSum(f, f.u, f.v, f.w);
            const auto spin = angularMomentum(f);
            const double scale = massSumMag(f, f.u, f.v, f.w);
            const double energy = kineticEnergy(f);

            collide
            (
                scheme.system,
                std::string("distance 1; sweeps ") + sweeps + ";"
            );

            const auto after = massSum(f, f.u, f.v, f.w);
            const auto spinAfter = angularMomentum(f);
            for (int a = 0; a < 3; ++a)
            {
                EXPECT_NEAR(after[a], momentum[a], 1e-14*scale);
                EXPECT_NEAR(spinAfter[a], spin[a], 1e-15*scale);
            }
            EXPECT_LT(kineticEnergy(f), energy*(1 - 1e-3));
        }
    }
}


TEST(ParticleCollision, keepsAllPairsApart)
{
    double before = 0, worst = 0;
    for (const unsigned seed : {1, 2, 3})
    {
        schemeCase scheme(still(crowd(seed)));
        before = std::max(before, trespass(scheme.system.fluid, deltaT));
        collide(scheme.system, "sweeps 100;");
        worst = std::max(worst, trespass(scheme.system.fluid, deltaT));
    }
    RecordProperty("before", std::to_string(before));
    RecordProperty("trespass", std::to_string(worst));
    EXPECT_GT(before, 0.3);
    EXPECT_LT(worst, 0.02);
}


TEST(ParticleCollision, leavesSolids)
{
    schemeCase scheme(pairOf(0.3*spacing, 0.5, -0.5));
    std::vector<int> body(4, -1);
    body[scheme.indexOf(1)] = 0;
    scheme.system.near.setSolids(body);
    const particles before = scheme.system.fluid;
    collide(scheme.system);
    EXPECT_EQ(scheme.system.fluid.u, before.u);
}


// Across the ends of a domain that repeats itself: another origin, same collisions
TEST(ParticleCollision, knowsNearestImages)
{
    const std::array<bool, 3> periodic{true, true, true};
    schemeCase a(still(crowd(1, periodic))), b(still(crowd(1, periodic)));
    for (double& x : b.system.fluid.x)
    {
        x += 4.5*spacing;
    }
    b.system.near.build(b.system.fluid, b.system.walls);
    const double energy = kineticEnergy(a.system.fluid);
    collide(a.system);
    collide(b.system);
    EXPECT_LT(kineticEnergy(a.system.fluid), 0.999*energy);
    for (int id = 0; id < a.system.fluid.size(); ++id)
    {
        ASSERT_NEAR
        (
            a.system.fluid.u[a.indexOf(id)], b.system.fluid.u[b.indexOf(id)],
            1e-10
        );
    }
}


TEST(ParticleCollision, sameBytesWithAnyNumberOfThreads)
{
    const int before = omp_get_max_threads();
    std::vector<particles> results;
    for (const int nThreads : {1, 2, 3})
    {
        omp_set_num_threads(nThreads);
        schemeCase scheme(still(crowd(1)));
        collide(scheme.system);
        results.push_back(scheme.system.fluid);
    }
    omp_set_num_threads(before);
    for (const particles& f : results)
    {
        EXPECT_EQ(f.u, results[0].u);
        EXPECT_EQ(f.w, results[0].w);
    }
}


// Two particles without forces that run into each other
TEST(ParticleCollision, isPartOfTheSchemes)
{
    const auto least = [](const std::string& scheme, const std::string& effects)
    {
        particleCloud cloud(lattice{{2, 1, 2}, spacing});
        particles& f = cloud.fluid;
        f.x = {0, spacing, 1, 2};
        f.y = {0, 0, 0, 0};
        f.z = {0, 0, 0, 0};
        f.u = {0.5, -0.5, 0, 0};
        cloud.build();
        schemeCase run(cloud, scheme + " collision { distance 0.4; }", effects);
        run.run(0.01, 20);
        const particles& end = run.system.fluid;
        return (end.x[run.indexOf(1)] - end.x[run.indexOf(0)])/spacing;
    };
    for
    (
        const std::string& scheme :
        {
            springAndDamper(0, 0),
            std::string("scheme semiImplicit;") + springAndDamper(0, 0)
        }
    )
    {
        EXPECT_NEAR(least(scheme, "particleCollision on;"), 0.4, 1e-10);
        EXPECT_NEAR(least(scheme, ""), 0.4, 1e-10);
        EXPECT_NEAR(least(scheme, "particleCollision off;"), 0, 1e-10);
    }
}


TEST(ParticleCollision, rejectsBadInput)
{
    schemeCase scheme(pairOf(0.3*spacing, 0.5, -0.5));
    for (const char* entry : {"distance 0;", "distance 1.5;", "sweeps 0;"})
    {
        EXPECT_THROW(collide(scheme.system, entry), IOerror) << entry;
    }
}

// ************************************************************************* //
