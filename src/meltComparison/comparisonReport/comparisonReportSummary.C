/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "comparisonReport.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::comparisonReport::writeSummary(Ostream& os) const
{
    const auto cell = [](const std::string& text, const label width)
    {
        std::ostringstream padded;
        padded << std::setw(width) << text;
        return padded.str();
    };
    const auto number = [](const scalar value)
    {
        std::ostringstream text;
        text << std::setprecision(4) << value;
        return text.str();
    };

    os  << nl << cell("", 18).c_str();
    for (const caseResults& c : cases_)
    {
        os  << cell(c.name(), 18).c_str();
    }
    os  << nl;
    const auto rows = costs(cases_[0].cost());
    forAll(rows, i)
    {
        os  << cell(rows[i].first, 18).c_str();
        for (const caseResults& c : cases_)
        {
            os  << cell(number(costs(c.cost())[i].second), 18).c_str();
        }
        os  << nl;
    }

    for (const pairComparison& pair : pairs_)
    {
        os  << nl << pair.cases().first() << " and " << pair.cases().second()
            << ':' << nl;
        wordList shown(comparisonTolerances::shapeQuantities);
        for (const word& column : columns())
        {
            if (tolerances_.found(column, pair.methods()))
            {
                shown.append(column);
            }
        }
        for (const word& quantity : shown)
        {
            const pairComparison::item& figure = pair.worst(quantity);
            os  << cell(quantity, 26).c_str()
                << cell(number(figure.value) + ' ' + figure.unit, 16).c_str();
            if (tolerances_.found(quantity, pair.methods()))
            {
                os  <<
                    (
                        comparisonTolerances::greaterIsBetter(quantity)
                      ? "   >= " : "   <= "
                    )
                    << number
                       (
                           tolerances_.value(quantity, pair.methods())
                       ).c_str()
                    <<
                    (
                        tolerances_.holds
                        (
                            quantity, figure.value, pair.methods()
                        )
                      ? "   holds" : "   DOES NOT HOLD"
                    );
            }
            os  << nl;
        }
    }
    os  << nl << "Verdict: the tolerances "
        << (holds() ? "hold" : "do not hold") << nl
        << "Report: " << (dir_/"index.html").c_str() << nl << endl;
}


// ************************************************************************* //
