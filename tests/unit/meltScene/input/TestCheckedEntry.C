/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkedEntry.H"
#include "dimensionSets.H"
#include "meltUnitTests.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

scalar read(const char* text, const scalarMinMax& range)
{
    const dictionary dict{IStringStream(text)()};
    return checkedEntry::get(dict, "rho", dimDensity, range);
}

} // End anonymous namespace


TEST(CheckedEntry, readsNumbersWithAndWithoutDimensions)
{
    EXPECT_EQ(read("rho 1000;", checkedEntry::positive()), 1000);
    EXPECT_EQ(read("rho [1 -3 0 0 0 0 0] 7;", checkedEntry::positive()), 7);
    EXPECT_EQ(read("rho 0;", checkedEntry::notNegative()), 0);
    EXPECT_EQ(read("rho -2;", checkedEntry::any()), -2);
}


TEST(CheckedEntry, rejectsWhatIsOutsideTheRange)
{
    EXPECT_THROW(read("rho 0;", checkedEntry::positive()), IOerror);
    EXPECT_THROW(read("rho -1;", checkedEntry::notNegative()), IOerror);
    EXPECT_THROW(read("rho 1.5;", checkedEntry::positiveUpTo(1)), IOerror);
}


TEST(CheckedEntry, rejectsWhatIsNoNumber)
{
    for (const char* text : {"rho nan;", "rho inf;", "rho;", "rho ten;", ""})
    {
        EXPECT_THROW(read(text, checkedEntry::any()), IOerror) << text;
    }

    const dictionary dict(IStringStream("rho 1;")());
    for (const scalar value : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    {
        EXPECT_THROW
        (
            checkedEntry::check(dict, "rho", value, checkedEntry::any()),
            IOerror
        ) << value;
    }
}


TEST(CheckedEntry, rejectsOtherDimensions)
{
    EXPECT_THROW
    (
        read("rho [0 1 0 0 0 0 0] 7;", checkedEntry::positive()),
        error
    );
}


TEST(CheckedEntry, messageNamesEntryValueAndWhatIsAccepted)
{
    try
    {
        read("\n\nrho -5;", checkedEntry::positive());
        FAIL() << "nothing thrown";
    }
    catch (const IOerror& err)
    {
        const std::string message(err.message());

        EXPECT_NE(message.find("rho = -5"), std::string::npos) << message;
        EXPECT_NE(message.find("> 0"), std::string::npos) << message;
        EXPECT_NE(err.ioFileName().find("rho"), std::string::npos);

        // Lines of a string are counted from zero
        EXPECT_EQ(err.ioStartLineNumber(), 2);
    }
}


TEST(CheckedEntry, defaultIsTakenOnlyIfThereIsNoEntry)
{
    const dictionary dict(IStringStream("Cp 2; kappa -1;")());
    const scalarMinMax range(checkedEntry::positive());

    EXPECT_EQ(checkedEntry::getOrDefault(dict, "Cp", dimless, range, 5), 2);
    EXPECT_EQ(checkedEntry::getOrDefault(dict, "rho", dimless, range, 5), 5);
    EXPECT_THROW
    (
        checkedEntry::getOrDefault(dict, "kappa", dimless, range, 5),
        IOerror
    );
}


// ************************************************************************* //
