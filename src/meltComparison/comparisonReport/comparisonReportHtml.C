/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "comparisonReport.H"
#include "OSspecific.H"

#include <fstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::comparisonReport::htmlFigure
(
    std::ostream& os,
    const pairComparison& pair,
    const pairComparison::item& figure
) const
{
    os  << "<td>" << figure.value << ' '
        << (figure.unit == "-" ? string() : figure.unit) << "</td>";

    if (!tolerances_.found(figure.quantity, pair.methods()))
    {
        os  << "<td></td><td></td>";
        return;
    }

    const bool holds =
        tolerances_.holds(figure.quantity, figure.value, pair.methods());
    os  << "<td>"
        <<
        (
            comparisonTolerances::greaterIsBetter(figure.quantity)
          ? "&ge; " : "&le; "
        )
        << tolerances_.value(figure.quantity, pair.methods())
        << "</td><td class=\"" << (holds ? "yes\">holds" : "no\">does not hold")
        << "</td>";
}


void Foam::melt::comparisonReport::htmlCost(std::ostream& os) const
{
    os  << "<h2>Cost</h2>\n<table>\n<tr><th></th>";
    for (const caseResults& c : cases_)
    {
        os  << "<th>" << c.name() << "</th>";
    }
    os  << "</tr>\n<tr><th>method</th>";
    for (const caseResults& c : cases_)
    {
        os  << "<td>" << c.cost().method << "</td>";
    }
    os  << "</tr>\n";
    const auto rows = costs(cases_[0].cost());
    forAll(rows, i)
    {
        os  << "<tr><th>" << rows[i].first << "</th>";
        for (const caseResults& c : cases_)
        {
            os  << "<td>" << costs(c.cost())[i].second << "</td>";
        }
        os  << "</tr>\n";
    }
    os  << "</table>\n";
}


void Foam::melt::comparisonReport::htmlPair
(
    std::ostream& os,
    const pairComparison& pair
) const
{
    os  << "<h2>" << pair.cases().first() << " and " << pair.cases().second()
        << "</h2>\n<table>\n<tr><th>quantity</th><th>time [s]</th>"
        << "<th>difference</th><th>tolerance</th><th></th></tr>\n";
    for (const pairComparison::item& i : pair.items())
    {
        os  << "<tr><th>" << i.quantity << "</th><td>";
        if (i.time >= 0)
        {
            os  << i.time;
        }
        else
        {
            os  << "greatest";
        }
        os  << "</td>";
        htmlFigure(os, pair, i);
        os  << "</tr>\n";
    }
    os  << "</table>\n";
}


void Foam::melt::comparisonReport::htmlPictures(std::ostream& os) const
{
    if (pictureTimes_.empty())
    {
        return;
    }

    os  << "<h2>Pictures</h2>\n<table>\n<tr><th>time [s]</th>";
    for (const caseResults& c : cases_)
    {
        os  << "<th>" << c.name() << "</th>";
    }
    os  << "</tr>\n";
    forAll(pictureTimes_, i)
    {
        os  << "<tr><th>" << pictureTimes_[i] << "</th>";
        for (const caseResults& c : cases_)
        {
            os  << "<td><img src=\"pictures/" << c.name() << '_' << i
                << ".png\" alt=\"" << c.name() << "\"/></td>";
        }
        os  << "</tr>\n";
    }
    os  << "</table>\n";
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::comparisonReport::writeHtml() const
{
    const fileName file(dir_/"index.html");
    std::ofstream os(file);
    os.precision(5);

    os  << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
        << "<meta charset=\"utf-8\"/>\n<title>" << title_ << "</title>\n"
        << "<style>\n"
        << "body { font-family: sans-serif; margin: 2em; }\n"
        << "table { border-collapse: collapse; }\n"
        << "th, td { padding: 2px 10px; border-bottom: 1px solid #ddd; }\n"
        << "th { text-align: left; font-weight: normal; color: #444; }\n"
        << "td { text-align: right; }\n"
        << ".yes { color: #007a33; } .no { color: #c00000; }\n"
        << "</style>\n</head>\n<body>\n<h1>" << title_ << "</h1>\n"
        << "<p class=\"" << (holds() ? "yes" : "no")
        << "\">The tolerances " << (holds() ? "hold" : "do not hold")
        << ".</p>\n<p><a href=\"comparison.csv\">comparison.csv</a>,"
        << " <a href=\"diagnostics.csv\">diagnostics.csv</a>,"
        << " <a href=\"cost.csv\">cost.csv</a></p>\n";

    htmlPictures(os);
    htmlCost(os);
    for (const pairComparison& pair : pairs_)
    {
        htmlPair(os, pair);
    }

    os  << "<h2>Diagnostics over time</h2>\n";
    for (const word& column : columns())
    {
        os  << "<img src=\"plots/" << column << ".svg\" alt=\"" << column
            << "\"/>\n";
    }
    os  << "</body>\n</html>\n";

    if (!os.flush())
    {
        FatalErrorInFunction << "Cannot write " << file << exit(FatalError);
    }
}


// ************************************************************************* //
