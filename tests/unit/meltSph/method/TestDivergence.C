/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "divergence.H"
#include "meltSph/timeStep/schemeCase.H"

#include <limits>
#include <stdexcept>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;
using namespace Foam::melt::unitTest;

namespace
{

particleCloud lump()
{
    return particleCloud
    (
        lattice{{4, 4, 4}, 0.01, smoothingKernel::kernelType::wendlandC2, 1.2}
    );
}

//- The message with which a run ends whose particles are these
std::string message(const particles& f)
{
    try
    {
        endDivergedRun(f, 0.25, "the reason");
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "";
}

} // End anonymous namespace


TEST(Divergence, namesTheParticleThatIsNotANumber)
{
    for (particles::array particles::* a : {&particles::y, &particles::w})
    {
        particleCloud cloud(lump());
        particles& f = cloud.fluid;
        f.x[5] = 100;
        (f.*a)[17] = std::numeric_limits<double>::quiet_NaN();
        f.id[17] = 4711;
        EXPECT_EQ(divergedParticle(f), 17);

        const std::string text(message(f));
        for (const char* part : {"4711", "0.25 s", "the reason", "as they were"})
        {
            EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
        }
    }
}


TEST(Divergence, namesTheFarthestParticle)
{
    particleCloud cloud(lump());
    particles& f = cloud.fluid;
    f.z[40] = -1e30;
    EXPECT_EQ(divergedParticle(f), 40);
    EXPECT_NE(message(f).find("-1e+30"), std::string::npos);
}


TEST(Divergence, namesTheParticleWithoutDensity)
{
    for (const double rho : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()})
    {
        particleCloud cloud(lump());
        EXPECT_TRUE(densityIsPositive(cloud.fluid));
        cloud.fluid.rho[31] = rho;
        EXPECT_FALSE(densityIsPositive(cloud.fluid));
        EXPECT_EQ(divergedParticle(cloud.fluid), 31);
    }
}


TEST(Divergence, noParticles)
{
    EXPECT_EQ(divergedParticle(particles()), -1);
    EXPECT_NE(message(particles()).find("the reason"), std::string::npos);
}


// What sphMethod catches: a scheme cannot go on without lists of neighbours
TEST(Divergence, schemeThrowsWhenAParticleHasLeftTheScene)
{
    for (const double speed : {1e200, std::numeric_limits<double>::infinity()})
    {
        schemeCase scheme(lump(), springAndDamper(0, 0));
        scheme.scheme->start();
        scheme.system.fluid.u[3] = speed;
        EXPECT_THROW(scheme.scheme->advance(1e-3), std::runtime_error);
    }
}

// ************************************************************************* //
