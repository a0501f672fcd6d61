/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltTime.H"
#include "meltUnitTests.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"

#include <cmath>
#include <vector>

using namespace Foam;
using namespace Foam::melt;

namespace
{

struct stepTaken
{
    scalar deltaT;
    scalar end;
    label index;
    bool write;

    bool operator==(const stepTaken& other) const
    {
        return
            deltaT == other.deltaT && end == other.end
         && index == other.index && write == other.write;
    }
};


fileName caseWith(const std::string& entries)
{
    const fileName directory(unitTest::runTime().path()/"meltTime");

    mkDir(directory/"system");
    OFstream(directory/"system"/"controlDict")()
        << "FoamFile { version 2.0; format ascii; class dictionary;"
        << " object controlDict; }" << nl
        << "startFrom latestTime; startTime 0; stopAt endTime;"
        << " writeFormat ascii; timePrecision 12; " << entries.c_str() << nl;

    return directory;
}


//- A run from the latest time, with steps that depend on time
std::vector<stepTaken> run(const fileName& directory)
{
    meltTime time(directory);
    std::vector<stepTaken> steps;

    while (time.run())
    {
        const scalar deltaT =
            time.advance(0.013*(1 + 0.9*std::sin(37*time.value())));

        if (time.writeTime())
        {
            time.writeChecked([]() {});
        }
        steps.push_back
        (
            {deltaT, time.value(), time.timeIndex(), time.writeTime()}
        );
    }

    return steps;
}


//- Steps of an uninterrupted run to 1 s against one that is stopped
void expectSameSteps(const std::string& entries, const std::string& stop)
{
    const fileName directory(caseWith(entries + "endTime 1;"));
    const std::vector<stepTaken> whole(run(directory));
    rmDir(directory);

    caseWith(entries + stop);
    std::vector<stepTaken> parts(run(directory));
    ASSERT_LT(parts.size(), whole.size());

    caseWith(entries + "endTime 1;");
    for (const stepTaken& step : run(directory))
    {
        parts.push_back(step);
    }
    rmDir(directory);

    ASSERT_EQ(parts.size(), whole.size());
    for (size_t i = 0; i < whole.size(); ++i)
    {
        EXPECT_TRUE(parts[i] == whole[i])
            << i << ": " << parts[i].end << ' ' << whole[i].end;
    }
}

} // End anonymous namespace


TEST(MeltTime, continuedRunTakesTheSameSteps)
{
    const std::string entries
    (
        "deltaT 1; writeControl runTime; writeInterval 0.1;"
    );

    for (const char* stop : {"endTime 0.3;", "endTime 0.6;", "endTime 0.7;"})
    {
        expectSameSteps(entries, stop);
    }
}


TEST(MeltTime, continuedRunTakesTheSameStepsFromAnOddTime)
{
    expectSameSteps
    (
        "deltaT 1; writeControl timeStep; writeInterval 7;",
        "endTime 1; maxSteps 21;"
    );
}


TEST(MeltTime, maxStepsWritesAndEnds)
{
    const fileName directory
    (
        caseWith
        (
            "deltaT 1; writeControl runTime; writeInterval 1; endTime 5;"
            "maxSteps 3;"
        )
    );
    const std::vector<stepTaken> steps(run(directory));

    ASSERT_EQ(steps.size(), 3u);
    EXPECT_TRUE(steps.back().write);
    EXPECT_FALSE(steps[1].write);

    // Nothing is left to do
    EXPECT_TRUE(run(directory).empty());
    rmDir(directory);
}


TEST(MeltTime, failedWriteLeavesNoTime)
{
    const fileName directory
    (
        caseWith("deltaT 1; writeControl runTime; writeInterval 1; endTime 2;")
    );
    meltTime time(directory);
    time.advance(1);
    time.writeChecked([]() {});
    time.advance(1);

    const auto failing = [&]()
    {
        OFstream os(mkDir(time.timePath()) ? time.timePath()/"U" : fileName());
        os.setBad();
        os.check(FUNCTION_NAME);
    };

    EXPECT_THROW(time.writeChecked(failing), error);
    EXPECT_FALSE(isDir(directory/"2"));
    EXPECT_TRUE(isDir(directory/"1"));
    EXPECT_TRUE(FatalIOError.throwExceptions());
    rmDir(directory);
}


// An editor may leave out the divider at the end of 0/T
TEST(MeltTime, filesThatWereThereBeforeMayEndAsTheyLike)
{
    const fileName directory
    (
        caseWith("deltaT 1; writeControl runTime; writeInterval 1; endTime 2;")
    );
    mkDir(directory/"0");
    OFstream(directory/"0"/"T")() << "/*-----*/ dimensions [];";

    meltTime time(directory);
    EXPECT_NO_THROW(time.writeChecked([]() {}));

    const auto cut = [&]()
    {
        OFstream(directory/"0"/"U")() << "/*-----*/ dimensions";
    };
    EXPECT_THROW(time.writeChecked(cut), error);
    EXPECT_TRUE(isFile(directory/"0"/"T"));
    rmDir(directory);
}


TEST(MeltTime, takesAStepEvenIfDeltaTIsBeyondEndTime)
{
    const fileName directory
    (
        caseWith("deltaT 9; writeControl runTime; writeInterval 1; endTime 1;")
    );
    const std::vector<stepTaken> steps(run(directory));

    ASSERT_FALSE(steps.empty());
    EXPECT_EQ(steps.back().end, 1);
    EXPECT_TRUE(steps.back().write);
    rmDir(directory);
}


TEST(MeltTime, rejectsAStepThatIsNoNumber)
{
    const fileName directory
    (
        caseWith("deltaT 1; writeControl runTime; writeInterval 1; endTime 1;")
    );
    meltTime time(directory);

    for (const scalar deltaT : {std::nan(""), 0., -1., 1e-300})
    {
        if (deltaT == 1e-300)
        {
            time.advance(0.5);
        }
        EXPECT_THROW(time.advance(deltaT), error) << deltaT;
    }
    rmDir(directory);
}


TEST(MeltTime, rejectsBadMaxSteps)
{
    for (const char* steps : {"0", "-3", "nan"})
    {
        const fileName directory
        (
            caseWith
            (
                "deltaT 1; writeControl runTime; writeInterval 1; endTime 1;"
                "maxSteps " + std::string(steps) + ";"
            )
        );
        EXPECT_THROW(meltTime{directory}, IOerror) << steps;
        rmDir(directory);
    }
}


// ************************************************************************* //
