/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writtenFiles.H"
#include "meltUnitTests.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "vectorIOField.H"

#include <fstream>

using namespace Foam;
using namespace Foam::melt;

namespace
{

class WrittenFiles
:
    public testing::Test
{
protected:

    const fileName directory_;

    WrittenFiles()
    :
        directory_(unitTest::runTime().path()/"writtenFiles")
    {
        mkDir(directory_/"lagrangian"/"melt");
    }

    ~WrittenFiles()
    {
        rmDir(directory_);
    }

    //- A field as OpenFOAM writes it, cut to a share of its length
    fileName write(const IOstream::streamFormat format, const double share)
    {
        const Time& time = unitTest::runTime();

        const vectorIOField field
        (
            IOobject("U", "writtenFiles", "lagrangian/melt", time),
            vectorField(100, vector(1, 2, 3))
        );
        const fileName file(field.objectPath());
        {
            OFstream os(file, format);
            field.writeHeader(os);
            field.writeData(os);
            IOobject::writeEndDivider(os);
        }

        std::ifstream is(file, std::ios::binary);
        const std::string content
        (
            (std::istreambuf_iterator<char>(is)),
            std::istreambuf_iterator<char>()
        );
        std::ofstream(file, std::ios::binary)
            << content.substr(0, std::size_t(share*content.size()));

        return file;
    }
};

} // End anonymous namespace


TEST_F(WrittenFiles, wholeFilesAreComplete)
{
    EXPECT_TRUE(writtenFiles::complete(write(IOstream::ASCII, 1)));
    EXPECT_TRUE(writtenFiles::complete(write(IOstream::BINARY, 1)));
    EXPECT_TRUE(writtenFiles::firstIncomplete(directory_).empty());
}


TEST_F(WrittenFiles, cutFilesAreFoundBelowTheDirectory)
{
    for (const auto format : {IOstream::ASCII, IOstream::BINARY})
    {
        for (const double share : {0., 0.3, 0.7, 0.999})
        {
            const fileName file(write(format, share));

            EXPECT_FALSE(writtenFiles::complete(file)) << share;
            EXPECT_EQ(writtenFiles::firstIncomplete(directory_), file);
        }
    }
}


TEST_F(WrittenFiles, othersMayEndAsTheyLike)
{
    OFstream(directory_/"note")() << "end";

    EXPECT_TRUE(writtenFiles::complete(directory_/"note"));
    EXPECT_FALSE(writtenFiles::complete(directory_/"missing"));
}


// ************************************************************************* //
