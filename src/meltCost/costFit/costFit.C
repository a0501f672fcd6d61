/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costFit.H"
#include "HashSet.H"
#include "HashTable.H"
#include "ISstream.H"
#include "Pair.H"
#include "costLaw.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The fields of a line, also empty ones
DynamicList<string> fields(const string& line)
{
    DynamicList<string> list;
    std::string::size_type begin = 0;
    while (begin != std::string::npos)
    {
        const auto end = line.find(',', begin);
        list.append(line.substr(begin, end - begin));
        begin = end == std::string::npos ? end : end + 1;
    }
    return list;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::melt::costFit::curve(const UList<point>& points)
{
    const label size = points.size();
    scalarList n(size), error(size), cpuTime(size);
    DynamicList<scalar> nOwn, steps;
    scalarMinMax range;
    scalar melt = 0;
    scalar domain = 0;

    forAll(points, i)
    {
        n[i] = points[i].n;
        range.add(n[i]);
        error[i] = points[i].error;
        if (!points[i].ruled)
        {
            nOwn.append(n[i]);
            steps.append(points[i].steps);
        }
        cpuTime[i] = points[i].cpuTime;
        melt += mag(log(points[i].perMelt));
        domain += mag(log(points[i].perDomain));
    }

    HashSet<word> cases;
    for (const point& p : points)
    {
        cases.insert(p.caseName);
    }

    dictionary dict;
    dict.add("cases", wordList(cases.sortedToc()));
    dict.add("elements", word(domain < melt ? "domain" : "melt"));
    dict.add("n", Pair<scalar>(range.min(), range.max()));

    // Times per element are of what is counted as an element
    const scalarMinMax any(-GREAT, GREAT);
    dict.add("error", costLaw::fit(n, error, {-GREAT, 0}).dict());
    if (steps.size())
    {
        dict.add("steps", costLaw::fit(nOwn, steps, any).dict());
    }
    dict.add("cpuTime", costLaw::fit(n, cpuTime, any).dict());
    return dict;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::costFit::add(const word& caseName, Istream& csv)
{
    ISstream& is = dynamic_cast<ISstream&>(csv);
    string line;
    is.getLine(line);

    HashTable<label, string> columns;
    forAll(fields(line), i)
    {
        columns.insert(fields(line)[i], i);
    }

    DynamicList<string> row;
    const auto text = [&](const char* name)
    {
        if (!columns.found(name))
        {
            FatalErrorInFunction
                << "No column " << name << " in the points of " << caseName
                << nl << "Columns: " << columns.sortedToc()
                << exit(FatalError);
        }
        return row[columns[name]];
    };
    const auto number = [&](const char* name)
    {
        return readScalar(text(name));
    };

    while (is.good())
    {
        is.getLine(line);
        row = fields(line);
        if
        (
            row.size() != columns.size() || text("status") != "ok"
         || number("factor") != 1 || !(number("error") > 0)
        )
        {
            continue;
        }

        const scalar dx = number("resolution[m]");
        const scalar elements = number("particles");
        points_.append
        ({
            caseName,
            word(text("class")),
            word(text("method")),
            number("extent[m]")/dx,
            number("error"),
            number("steps")/number("duration"),
            number("steps") < 1.05*number("leastSteps"),
            number("cpuMedian[s]")/(elements*number("steps")),
            elements*pow3(dx)/number("meltVolume[m3]"),
            elements*pow3(dx)/number("domainVolume[m3]")
        });
    }
}


Foam::dictionary Foam::melt::costFit::classes() const
{
    dictionary classes;

    for (const point& p : points_)
    {
        if (classes.found(p.caseClass))
        {
            continue;
        }

        HashSet<word> cases;
        dictionary methods;

        for (const point& first : points_)
        {
            if (first.caseClass != p.caseClass)
            {
                continue;
            }
            cases.insert(first.caseName);

            DynamicList<point> same;
            for (const point& q : points_)
            {
                if
                (
                    q.caseClass == p.caseClass && q.method == first.method
                )
                {
                    same.append(q);
                }
            }
            if (!methods.found(first.method))
            {
                methods.add(first.method, curve(same));
            }
        }

        dictionary dict;
        dict.add("cases", wordList(cases.sortedToc()));
        dict.add("methods", methods);
        classes.add(p.caseClass, dict);
    }

    return classes;
}


// ************************************************************************* //
