/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Cloud.H"
#include "cloudFile.H"
#include "meltSph/mesh/hexMesh.H"
#include "meltUnitTests.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "passiveParticle.H"
#include "sphCloud.H"

#include <numeric>
#include <random>
#include <unistd.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::melt;

namespace
{

struct arrays
{
    std::vector<double> x, y, z, u, v, w, T, h;
    std::vector<int> id;

    // Random particles in the unit cube
    explicit arrays(const std::size_t n = 0, const unsigned seed = 1)
    {
        std::mt19937_64 generator(seed);
        std::uniform_real_distribution<double> uniform(0, 1);

        for (std::vector<double>* a : {&x, &y, &z, &u, &v, &w, &T, &h})
        {
            a->resize(n);
            for (double& value : *a)
            {
                value = uniform(generator);
            }
        }

        id.resize(n);
        std::iota(id.rbegin(), id.rend(), 7);
    }

    bool operator==(const arrays& b) const
    {
        return
            x == b.x && y == b.y && z == b.z && u == b.u && v == b.v
         && w == b.w && T == b.T && h == b.h && id == b.id;
    }
};


class SphCloud
:
    public testing::Test
{
protected:

    autoPtr<polyMesh> mesh;
    instant start;

    SphCloud()
    :
        mesh(unitTest::boxMesh(labelVector(3, 4, 5), vector::one)),
        start(unitTest::runTime().value(), unitTest::runTime().timeName())
    {}

    ~SphCloud()
    {
        rmDir(directory(), true);
        rmDir(unitTest::runTime().timePath()/"uniform", true);
    }

    fileName directory() const
    {
        return unitTest::runTime().timePath()/"lagrangian";
    }

    autoPtr<sphCloud> bind(arrays& a) const
    {
        auto cloud = autoPtr<sphCloud>::New(mesh(), "melt", a.x, a.y, a.z);
        cloud->addVector("U", a.u, a.v, a.w);
        cloud->addScalar("T", a.T);
        cloud->addScalar("h", a.h, false);
        cloud->addLabel("origId", a.id);
        return cloud;
    }

    bool write(sphCloud& cloud, const IOstream::streamFormat format) const
    {
        #if OPENFOAM >= 2006
        return cloud.writeObject(IOstreamOption(format), true);
        #else
        return cloud.writeObject
        (
            format, IOstream::currentVersion, IOstream::UNCOMPRESSED, true
        );
        #endif
    }

    void expectRoundTrip(const IOstream::streamFormat format) const
    {
        arrays written(1000);
        EXPECT_TRUE(write(bind(written)(), format));

        arrays read;
        autoPtr<sphCloud> cloud(bind(read));
        EXPECT_TRUE(cloud->read());
        EXPECT_TRUE(written == read);
        EXPECT_TRUE(cloud->wasRead("h"));
        EXPECT_EQ(cloud->nParcels(), 1000);
    }
};

} // End anonymous namespace


TEST_F(SphCloud, binaryRoundTripIsBitwise)
{
    expectRoundTrip(IOstream::BINARY);
}


TEST_F(SphCloud, asciiRoundTripIsBitwiseWith17Digits)
{
    const unsigned before = IOstream::defaultPrecision(17);
    expectRoundTrip(IOstream::ASCII);
    IOstream::defaultPrecision(before);
}


TEST_F(SphCloud, readsNothingWhereThereIsNoCloud)
{
    arrays a(3);
    const arrays before(a);
    EXPECT_FALSE(bind(a)->read());
    EXPECT_TRUE(a == before);
}


TEST_F(SphCloud, emptyCloudIsReadAsEmpty)
{
    arrays none;
    EXPECT_TRUE(write(bind(none)(), IOstream::BINARY));

    arrays read(5);
    EXPECT_TRUE(bind(read)->read());
    EXPECT_TRUE(read == none);
}


TEST_F(SphCloud, missingRequiredFieldIsFatalAndNamed)
{
    arrays a(10);
    write(bind(a)(), IOstream::BINARY);
    rm(directory()/"melt"/"T");

    arrays read;
    try
    {
        bind(read)->read();
        FAIL() << "no error";
    }
    catch (const error& e)
    {
        EXPECT_NE(e.message().find("lagrangian/melt/T"), std::string::npos)
            << e.message();
    }
}


TEST_F(SphCloud, missingOptionalFieldIsZero)
{
    arrays a(10);
    write(bind(a)(), IOstream::BINARY);
    rm(directory()/"melt"/"h");

    arrays read;
    autoPtr<sphCloud> cloud(bind(read));
    EXPECT_TRUE(cloud->read());
    EXPECT_FALSE(cloud->wasRead("h"));
    EXPECT_EQ(read.h, std::vector<double>(10, 0.0));
    EXPECT_EQ(read.T, a.T);
}


TEST_F(SphCloud, missingPositionsAreFatal)
{
    arrays a(10);
    write(bind(a)(), IOstream::BINARY);
    rm(directory()/"melt"/"positions");
    rm(directory()/"melt"/"coordinates");

    EXPECT_THROW(bind(a)->read(), error);
}


TEST_F(SphCloud, truncatedFileIsFatal)
{
    arrays a(1000);
    write(bind(a)(), IOstream::BINARY);
    const fileName file(directory()/"melt"/"U");
    ASSERT_EQ(truncate(file.c_str(), 9000), 0);

    arrays read;
    EXPECT_THROW(bind(read)->read(), error);
}


TEST_F(SphCloud, sizesThatDisagreeAreFatal)
{
    arrays a(10);
    write(bind(a)(), IOstream::BINARY);
    const fileName kept(directory()/"T");
    mv(directory()/"melt"/"T", kept);
    arrays b(11);
    write(bind(b)(), IOstream::BINARY);
    mv(kept, directory()/"melt"/"T");

    arrays read;
    EXPECT_THROW(bind(read)->read(), error);

    a.T.pop_back();
    EXPECT_THROW(write(bind(a)(), IOstream::BINARY), error);
}


TEST_F(SphCloud, notANumberIsFatal)
{
    arrays a(10);
    a.T[4] = std::nan("");
    write(bind(a)(), IOstream::BINARY);
    EXPECT_THROW(bind(a)->read(), error);

    a.y[4] = std::nan("");
    EXPECT_THROW(write(bind(a)(), IOstream::BINARY), error);
}


TEST_F(SphCloud, coordinatesAloneGivePositionsToRoundOff)
{
    arrays a(1000);
    write(bind(a)(), IOstream::BINARY);
    rm(directory()/"melt"/"positions");

    arrays read;
    EXPECT_TRUE(bind(read)->read());
    for (std::size_t i = 0; i < a.x.size(); ++i)
    {
        EXPECT_NEAR(read.x[i], a.x[i], 1e-15);
        EXPECT_NEAR(read.y[i], a.y[i], 1e-15);
        EXPECT_NEAR(read.z[i], a.z[i], 1e-15);
    }
}


TEST_F(SphCloud, particlesOutsideAreCountedAndKept)
{
    arrays a(100);
    a.z[10] = -0.3;
    a.x[20] = 7;
    a.y[20] = -5;

    {
        autoPtr<sphCloud> cloud(bind(a));
        EXPECT_TRUE(write(cloud(), IOstream::BINARY));
        EXPECT_EQ(cloud->outside(), 2);
    }

    // As OpenFOAM's programs read it
    {
        const Cloud<passiveParticle> cloud(mesh(), "melt", false);
        EXPECT_EQ(cloud.size(), 100);
        label i = 0;
        for (const passiveParticle& p : cloud)
        {
            EXPECT_GE(p.cell(), 0);
            EXPECT_NEAR(p.position().x(), a.x[i], 1e-14);
            EXPECT_NEAR(p.position().y(), a.y[i], 1e-14);
            EXPECT_NEAR(p.position().z(), a.z[i], 1e-14);
            ++i;
        }
    }

    arrays read;
    EXPECT_TRUE(bind(read)->read());
    EXPECT_TRUE(read == a);
}


TEST_F(SphCloud, derivedFieldsAreWrittenOnly)
{
    arrays a(50);
    {
        autoPtr<sphCloud> cloud(bind(a));
        cloud->addDerivedScalar
        (
            "twiceT",
            [&](double* values)
            {
                for (std::size_t i = 0; i < a.T.size(); ++i)
                {
                    values[i] = 2*a.T[i];
                }
            }
        );
        write(cloud(), IOstream::BINARY);

        objectRegistry obr(IOobject("obr", unitTest::runTime()));
        cloud->writeObjects(obr);
        const auto& twiceT = cloud::lookupIOField<scalar>("twiceT", obr);
        EXPECT_EQ(twiceT[49], 2*a.T[49]);
        EXPECT_EQ(cloud::findIOPosition(obr)->size(), 50);
        EXPECT_EQ(cloud::lookupIOField<vector>("U", obr)[3].y(), a.v[3]);
    }

    arrays read;
    std::vector<double> twiceT;
    {
        autoPtr<sphCloud> cloud(bind(read));
        cloud->addScalar("twiceT", twiceT);
        cloud->read();
        EXPECT_EQ(twiceT[7], 2*a.T[7]);
    }
}


TEST_F(SphCloud, nameTakenTwiceIsFatal)
{
    arrays a(1);
    autoPtr<sphCloud> cloud(bind(a));
    EXPECT_THROW(cloud->addScalar("U", a.h), error);
    EXPECT_THROW(cloud->addScalar("positions", a.h), error);
}


TEST_F(SphCloud, fileThatCannotBeWrittenIsReported)
{
    arrays a(1000);
    mkDir(directory()/"melt"/"T");
    EXPECT_FALSE(write(bind(a)(), IOstream::BINARY));
}


TEST_F(SphCloud, fullDiskIsReportedHoweverSmallTheFile)
{
    const cloudFile file
    (
        IOobject("small", "0", unitTest::runTime()),
        "scalarField",
        [](Ostream& os) { os << scalarField(2, 1.0); }
    );

    OFstream full("/dev/full");
    EXPECT_FALSE(file.writeData(full));

    OStringStream large;
    EXPECT_TRUE(file.writeData(large));
}


// ************************************************************************* //
