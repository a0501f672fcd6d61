/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltDiagnostics.H"
#include "meltUnitTests.H"
#include "stringOps.H"

#include <cmath>

using namespace Foam;
using namespace Foam::melt;

namespace
{

label nColumns(const OStringStream& os)
{
    return stringOps::split(os.str(), '\t').size();
}

} // End anonymous namespace


TEST(MeltDiagnostics, headerNamesEachColumn)
{
    OStringStream header, row;
    meltDiagnostics::writeHeader(header);
    meltDiagnostics().write(row);

    EXPECT_EQ(nColumns(header), nColumns(row));
    EXPECT_GT(nColumns(row), 20);
}


TEST(MeltDiagnostics, valuesAreInTheOrderOfTheHeader)
{
    meltDiagnostics figures;
    figures.mass = 11;
    figures.centreOfMass = point(1, 2, 3);
    figures.maxT = 12;
    figures.meltedFraction = 0.25;
    figures.workOfGravity = 9;
    figures.kineticEnergy = 2;
    figures.elasticEnergy = 3;

    OStringStream header, row;
    meltDiagnostics::writeHeader(header);
    figures.write(row);

    const std::string headerText(header.str());
    const std::string rowText(row.str());
    const auto names = stringOps::split(headerText, '\t');
    const auto values = stringOps::split(rowText, '\t');

    const auto column = [&](const std::string& name)
    {
        for (std::size_t i = 0; i < names.size(); ++i)
        {
            if (names[i].str() == name)
            {
                return std::atof(values[i].str().c_str());
            }
        }

        return -1.;
    };

    EXPECT_EQ(column("mass[kg]"), 11);
    EXPECT_EQ(column("meltedFraction[-]"), 0.25);
    EXPECT_EQ(column("solidFraction[-]"), 0.75);
    EXPECT_EQ(column("workOut[J]"), 4);
    EXPECT_EQ(column("centreOfMassY[m]"), 2);
    EXPECT_EQ(column("maxT[K]"), 12);
}


TEST(MeltDiagnostics, nothingIsNeitherLiquidNorSolid)
{
    EXPECT_EQ(meltDiagnostics().solidFraction(), 0);
}


TEST(MeltDiagnostics, isNotFiniteWithNaNOrInfinity)
{
    EXPECT_TRUE(meltDiagnostics().finite());
    for
    (
        scalar meltDiagnostics::* energy
      : {
            &meltDiagnostics::kineticEnergy,
            &meltDiagnostics::potentialEnergy,
            &meltDiagnostics::elasticEnergy
        }
    )
    {
        meltDiagnostics d;
        d.*energy = std::numeric_limits<scalar>::quiet_NaN();
        EXPECT_FALSE(d.finite());
    }

    meltDiagnostics figures;
    figures.maxU = std::nan("");
    EXPECT_FALSE(figures.finite());

    figures = meltDiagnostics();
    figures.centreOfMass.z() = HUGE_VAL;
    EXPECT_FALSE(figures.finite());
}


// ************************************************************************* //
