/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costFit.H"
#include "costLaw.H"
#include "costModel.H"
#include "meltUnitTests.H"
#include "StringStream.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

const std::string header =
    "method,resolution[m],factor,error,steps,particles,operations,"
    "cpuMedian[s],cpuMin[s],cpuMax[s],wall[s],peakMemory[MB],class,extent[m],"
    "meltVolume[m3],domainVolume[m3],duration,leastSteps,status\n";

// A cube of 1 m in a domain of 2 m3, n elements along an edge: error 1/n^2,
// 10 n steps in a duration of 2, 1 us for an element in a step
std::string row(const label n, const word& method, const label elements)
{
    OStringStream os;
    os.precision(12);
    os  << method << ',' << 1.0/n << ",1," << 1.0/(n*n) << ',' << 20*n << ','
        << elements << ",1," << 20e-6*n*elements
        << ",0,0,0,50,conduction,1,1,2,2,20,ok\n";
    return os.str();
}

dictionary fitted(const std::string& rows)
{
    costFit fit;
    IStringStream csv(header + rows);
    fit.add("cube", csv);
    dictionary model;
    model.add("machine", string("test"));
    model.add("extrapolation", 1);
    model.add("classes", fit.classes());
    return model;
}

} // End anonymous namespace


TEST(CostFit, aModelOfPointsOnLawsPredictsThem)
{
    const dictionary model
    (
        fitted
        (
            row(2, "sph", 8) + row(4, "sph", 64) + row(8, "sph", 512)
          + row(2, "eulerian", 16) + row(4, "eulerian", 128)
          + row(8, "eulerian", 1024)
          + row(2, "voxelAutomaton", 8) + row(4, "voxelAutomaton", 64)
        )
    );

    caseScales scales;
    scales.caseClass = "conduction";
    scales.extent = 2;
    scales.meltVolume = 8;
    scales.domainVolume = 80;
    scales.duration = 3;
    scales.leastSteps = 1;

    // Dictionary and back; what is written is what is used
    OStringStream text;
    text.precision(12);
    model.write(text, false);
    const costModel read(dictionary(IStringStream(text.str())()));
    EXPECT_EQ(read.cases("conduction"), wordList({"cube"}));

    const costModel::choice sph
    (
        read.choose
        (
            costRequest::accuracy("0.0401"),
            scales,
            [](const word& m) { return m == "sph"; }
        )
    );
    EXPECT_NEAR(sph.guess.resolution, 2.0/5, 1e-12);
    EXPECT_NEAR(sph.guess.error, 0.04, 1e-6);
    EXPECT_NEAR(sph.guess.steps, 150, 1e-3);
    EXPECT_NEAR(sph.guess.cpuTime, 125*150e-6, 1e-6);

    // Fills the domain, not only the melt
    const costModel::choice eulerian
    (
        read.choose
        (
            costRequest::accuracy("0.0626"),
            scales,
            [](const word& m) { return m == "eulerian"; }
        )
    );
    EXPECT_NEAR(eulerian.guess.cpuTime, 640*120e-6, 1e-5);
    EXPECT_EQ(eulerian.guess.errorFreedom, 1);
    EXPECT_EQ(eulerian.cases, wordList({"cube"}));

    // By two points nothing can be promised
    EXPECT_THROW
    (
        read.choose
        (
            costRequest::accuracy("0.9"),
            scales,
            [](const word& m) { return m == "voxelAutomaton"; }
        ),
        Foam::error
    );
}


TEST(CostFit, leavesOutWhatDidNotRun)
{
    costFit fit;
    IStringStream csv
    (
        header + row(2, "sph", 8) + "sph,0.1,1,,,,,,,,,,,,,,,,stopped\n"
      + "sph,0.5,0.5,0.25,40,8,1,1,0,0,0,50,conduction,1,1,2,2,20,ok\n"
    );
    fit.add("cube", csv);
    EXPECT_EQ(fit.size(), 1);
}


TEST(CostFit, stepsThatDeltaTRuledAreNotFitted)
{
    // As many as it asked for
    const std::string ruled =
        "sph,0.5,1,0.25,20,8,1,1,0,0,0,50,conduction,1,1,2,2,20,ok\n";
    const auto curve = [](const dictionary& model)
    {
        return
            model.subDict("classes").subDict("conduction")
           .subDict("methods").subDict("sph");
    };
    EXPECT_FALSE(curve(fitted(ruled)).found("steps"));

    const costLaw steps
    (
        curve(fitted(ruled + row(4, "sph", 64))).subDict("steps")
    );
    EXPECT_NEAR(steps(4), 40, 1e-3);
}


TEST(CostFit, namesTheColumnThatIsMissing)
{
    costFit fit;
    IStringStream csv("method,error,status\nsph,0.1,ok\n");
    try
    {
        fit.add("cube", csv);
        FAIL();
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("factor"), std::string::npos);
    }
}


// ************************************************************************* //
