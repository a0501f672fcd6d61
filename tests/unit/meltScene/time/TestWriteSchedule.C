/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeSchedule.H"
#include "meltUnitTests.H"

#include <cmath>

using namespace Foam;
using namespace Foam::melt;

namespace
{

writeSchedule schedule(const std::string& text)
{
    return writeSchedule(dictionary(IStringStream(text)()));
}

} // End anonymous namespace


TEST(WriteSchedule, writeTimesAreWhatTheirNamesSay)
{
    for (const char* interval : {"0.1", "0.3", "0.002", "0.0125", "1e-5", "7"})
    {
        const writeSchedule times
        (
            schedule
            (
                std::string("deltaT 1; writeControl runTime; writeInterval ")
              + interval + ";"
            )
        );

        scalar t = 0;
        for (int k = 1; k < 20000; ++k)
        {
            const scalar next = times.nextWriteTime(t);

            ASSERT_GT(next, t);
            ASSERT_NEAR(next/(k*std::atof(interval)), 1, 1e-14);
            ASSERT_EQ(next, std::atof(Time::timeName(next).c_str()));
            t = next;
        }
    }
}


TEST(WriteSchedule, stepsEndExactlyOnWriteTimes)
{
    const writeSchedule times
    (
        schedule("deltaT 1; writeControl adjustableRunTime; writeInterval 0.1;")
    );

    scalar t = 0;
    int nWrites = 0;
    for (label i = 0; t < 1; ++i)
    {
        const scalar longest = 0.011*(1 + 0.9*std::sin(37*t));
        const writeSchedule::step step(times.next(t, i, 1, longest));

        ASSERT_LE(step.deltaT, longest*(1 + 1e-14));
        ASSERT_GT(step.deltaT, 0);
        ASSERT_NEAR(step.end, t + step.deltaT, 1e-15);

        if (step.write)
        {
            ++nWrites;
            EXPECT_EQ(step.end, std::atof(Time::timeName(step.end).c_str()));
            EXPECT_NEAR(step.end, 0.1*nWrites, 1e-15);
        }
        t = step.end;
    }

    EXPECT_EQ(nWrites, 10);
    EXPECT_EQ(t, 1);
}


TEST(WriteSchedule, deltaTIsTheLongestStep)
{
    const writeSchedule times
    (
        schedule("deltaT 0.01; writeControl runTime; writeInterval 0.1;")
    );

    EXPECT_DOUBLE_EQ(times.next(0, 0, 1, GREAT).deltaT, 0.01);
    EXPECT_DOUBLE_EQ(times.next(0, 0, 1, 0.005).deltaT, 0.005);

    // Equal steps rather than a short last one
    EXPECT_DOUBLE_EQ(times.next(0, 0, 1, 0.0099).deltaT, 0.1/11);
}


TEST(WriteSchedule, runEndsAtEndTimeBetweenWrites)
{
    const writeSchedule times
    (
        schedule("deltaT 1; writeControl runTime; writeInterval 0.4;")
    );
    const writeSchedule::step step(times.next(0.8, 0, 1, 1));

    EXPECT_EQ(step.end, 1);
    EXPECT_FALSE(step.write);

    // An end time that is a write time but for round-off is one
    EXPECT_TRUE(times.next(0.8, 0, 3*0.4, 1).write);
    EXPECT_TRUE(times.next(0.8, 0, 1.2*(1 - 1e-15), 1).write);
}


TEST(WriteSchedule, countsSteps)
{
    const writeSchedule times
    (
        schedule("deltaT 0.01; writeControl timeStep; writeInterval 5;")
    );

    for (label i = 0; i < 20; ++i)
    {
        const writeSchedule::step step(times.next(0.01*i, i, 1, 0.01));

        EXPECT_EQ(step.write, (i + 1) % 5 == 0);
        EXPECT_NEAR(step.deltaT, 0.01, 2e-4);
    }
}


TEST(WriteSchedule, badInputIsRejected)
{
    for
    (
        const char* text
      : {
            "deltaT 0; writeControl runTime; writeInterval 1;",
            "deltaT -1; writeControl runTime; writeInterval 1;",
            "deltaT nan; writeControl runTime; writeInterval 1;",
            "writeControl runTime; writeInterval 1;",
            "deltaT 1; writeControl runTime; writeInterval 0;",
            "deltaT 1; writeControl runTime; writeInterval -1;",
            "deltaT 1; writeControl runTime; writeInterval nan;",
            "deltaT 1; writeControl runTime;",
            "deltaT 1; writeControl timeStep; writeInterval 0;",
            "deltaT 1; writeControl cpuTime; writeInterval 1;",
            "deltaT 1; writeControl sometimes; writeInterval 1;"
        }
    )
    {
        EXPECT_THROW(schedule(text), IOerror) << text;
    }
}


// ************************************************************************* //
