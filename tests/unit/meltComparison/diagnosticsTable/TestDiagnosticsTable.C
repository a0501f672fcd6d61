/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diagnosticsTable.H"
#include "meltUnitTests.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "runCost.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

scalarField values(const scalarList& list)
{
    return scalarField(list);
}


//- A directory of results, removed at the end
class resultsDirectory
{
public:

    const fileName path;

    resultsDirectory()
    :
        path(unitTest::runTime().path()/"results")
    {}

    ~resultsDirectory()
    {
        rmDir(path);
    }

    void set(const fileName& file, const std::string& text) const
    {
        const fileName full(path/"postProcessing"/file);
        mkDir(full.path());
        OFstream os(full);
        os << text.c_str();
    }

    void table(const word& start, const std::string& rows) const
    {
        set
        (
            "meltDiagnostics"/start/"meltDiagnostics.dat",
            "           # time[s]\tsteps[-]\theight[m]\n" + rows
        );
    }
};

} // End anonymous namespace


TEST(DiagnosticsTable, readsNamesUnitsAndValues)
{
    const resultsDirectory results;
    results.table("0", "0\t0\t5\n1\t10\t3\n");
    const diagnosticsTable table(results.path);

    EXPECT_EQ(table.names(), wordList({"time", "steps", "height"}));
    EXPECT_EQ(table.unit("height"), "m");
    EXPECT_TRUE(table.has("steps"));
    EXPECT_FALSE(table.has("mass"));
    EXPECT_EQ(table["height"], values({5, 3}));
    EXPECT_NEAR(table.at("height", 0.25), 4.5, 1e-12);
    EXPECT_THROW(table["mass"], Foam::error);
}


TEST(DiagnosticsTable, continuedRunReplacesWhatItComputesAgain)
{
    const resultsDirectory results;
    results.table("0", "0\t0\t5\n1\t10\t3\n2\t20\t9\n");
    results.table("1", "1\t10\t3\n3\t30\t2\n");
    results.table("10", "10\t40\t1\n");
    const diagnosticsTable table(results.path);

    EXPECT_EQ(table.time(), values({0, 1, 3, 10}));
    EXPECT_EQ(table["height"], values({5, 3, 2, 1}));
}


TEST(DiagnosticsTable, differenceIsTheGreatestAtTheTimesOfBoth)
{
    const resultsDirectory results;
    results.table("0", "0\t0\t0\n1\t1\t1\n4\t2\t4\n");
    const diagnosticsTable a(results.path);
    results.table("0", "0\t0\t0\n2\t1\t5\n3\t2\t3\n");
    const diagnosticsTable b(results.path);

    // At 2: 5 and 2; beyond 3 there is nothing to compare with
    EXPECT_NEAR(a.maxDifference("height", b), 3, 1e-12);
    EXPECT_NEAR(b.maxDifference("height", a), 3, 1e-12);
    EXPECT_EQ(a.maxDifference("height", a), 0);
}


TEST(DiagnosticsTable, refusesWhatIsNoTable)
{
    const resultsDirectory results;
    EXPECT_THROW(diagnosticsTable(results.path), Foam::error);

    results.set("meltDiagnostics/0/meltDiagnostics.dat", "no table\n");
    EXPECT_THROW(diagnosticsTable(results.path), Foam::error);

    results.table("0", "0\t0\n");
    EXPECT_THROW(diagnosticsTable(results.path), Foam::error);

    results.table("0", "");
    EXPECT_THROW(diagnosticsTable(results.path), Foam::error);
}


TEST(RunCost, sumsUpTheParts)
{
    const resultsDirectory results;
    const std::string heading
    (
        "# method sph; resolution 0.01; threads 2; ranks 1;\n"
        "# time[s] steps[-] particles[-] particleSteps[-] wallTime[s] cpuTime[s]"
        " peakMemory[MB]\n"
    );
    results.set
    (
        "meltRun/0/meltRun.dat",
        heading + "0 0 8 0 0 0 60\n1 10 8 80 5 9 70\n"
    );
    results.set
    (
        "meltRun/1/meltRun.dat",
        heading + "1.0001 10 8 0 0 0 50\n2 30 7 150 6 11 55\n"
    );
    const runCost cost(results.path);

    EXPECT_EQ(cost.method, "sph");
    EXPECT_EQ(cost.resolution, 0.01);
    EXPECT_EQ(cost.threads, 2);
    EXPECT_EQ(cost.steps, 30);
    EXPECT_EQ(cost.particles, 7);
    EXPECT_EQ(cost.particleSteps, 230);
    EXPECT_EQ(cost.wallTime, 11);
    EXPECT_EQ(cost.cpuTime, 20);
    EXPECT_EQ(cost.peakMemory, 70);
}


// ************************************************************************* //
