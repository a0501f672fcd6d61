/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseRun.H"
#include "meltUnitTests.H"
#include "OFstream.H"
#include "OSspecific.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

//- A case with results in a directory of its own, removed at the end
class someCase
{
public:

    const fileName root;
    const fileName path;

    someCase()
    :
        root(unitTest::runTime().path()/"cases"),
        path(root/"block")
    {
        set("0/T", "T");
        set("0/lagrangian/melt/T", "result");
        set("0.5/T", "result");
        set("constant/g", "g");
        set("constant/geometry/block.off", "off");
        set("constant/polyMesh/faces", "faces");
        set("constant/eulerian/polyMesh/faces", "faces");
        set("postProcessing/meltRun/0/meltRun.dat", "result");
        set("system/controlDict", "endTime 1;");
        set("system/blockMeshDict", "blocks");
    }

    ~someCase()
    {
        rmDir(root);
    }

    void set(const fileName& file, const std::string& text) const
    {
        mkDir((path/file).path());
        OFstream os(path/file);
        os << text.c_str();
    }
};

} // End anonymous namespace


TEST(CaseRun, cloneHasTheInputAndNoResults)
{
    const someCase block;
    chMod(block.path/"constant/geometry/block.off", 0755);
    const caseRun run(block.path, "sph");
    run.clone();

    EXPECT_EQ(run.dir(), block.root/"block.sph");
    EXPECT_EQ(mode(run.dir()/"constant/geometry/block.off") & 0777, 0755);
    for (const char* file : {"0/T", "constant/g", "system/controlDict"})
    {
        EXPECT_TRUE(isFile(run.dir()/file)) << file;
    }
    EXPECT_TRUE(isFile(run.dir()/"constant/geometry/block.off"));
    for (const char* dir : {"0/lagrangian", "0.5", "postProcessing"})
    {
        EXPECT_FALSE(isDir(run.dir()/dir)) << dir;
    }

    // Each method makes its own mesh
    EXPECT_FALSE(isDir(run.dir()/"constant/polyMesh"));
    EXPECT_FALSE(isDir(run.dir()/"constant/eulerian"));
}


TEST(CaseRun, meshThatNoDictionaryMakesIsCloned)
{
    const someCase block;
    rm(block.path/"system/blockMeshDict");
    const caseRun run(block.path, "sph", 0.25);
    run.clone();

    EXPECT_EQ(run.dir(), block.root/"block.sph.0.25");
    EXPECT_TRUE(isFile(run.dir()/"constant/polyMesh/faces"));
}


TEST(CaseRun, cloneHasToAgreeWithTheCase)
{
    const someCase block;
    const caseRun run(block.path, "sph");
    run.clone();

    // What a run adds to the clone does no harm
    {
        OFstream os(run.dir()/"log.meltFoam");
    }
    EXPECT_NO_THROW(run.clone());

    block.set("constant/g", "another g");
    EXPECT_THROW(run.clone(), Foam::error);
    block.set("constant/g", "g");
    EXPECT_NO_THROW(run.clone());

    // What is asked of the results may change
    block.set("system/meltCompareDict", "other");
    EXPECT_NO_THROW(run.clone());
    EXPECT_TRUE(isFile(run.dir()/"system/meltCompareDict"));

    block.set("constant/more", "more");
    EXPECT_THROW(run.clone(), Foam::error);
}


TEST(CaseRun, refusesWhatIsNoCase)
{
    EXPECT_THROW(caseRun("/nowhere/block", "sph"), Foam::error);
}


// ************************************************************************* //
