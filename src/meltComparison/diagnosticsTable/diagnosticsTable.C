/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diagnosticsTable.H"
#include "IFstream.H"
#include "interpolateXY.H"
#include "OSspecific.H"
#include "stringOps.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::diagnosticsTable::add(const fileName& file)
{
    IFstream is(file);
    string line;
    string heading;
    DynamicList<DynamicList<scalar>> rows;

    while (is.good())
    {
        is.getLine(line);
        const std::string::size_type begin = line.find_first_not_of(" \t");
        if (begin == std::string::npos)
        {
            continue;
        }
        if (line[begin] == '#')
        {
            // The last of the comments has the headings
            comment_ = heading;
            heading = line.substr(line.find_first_not_of(" ", begin + 1));
            continue;
        }

        DynamicList<scalar> row;
        for (const auto& value : stringOps::splitSpace(line))
        {
            row.append(readScalar(value.str()));
        }
        rows.append(row);
    }

    wordList names;
    List<string> units;
    for (const auto& item : stringOps::splitSpace(heading))
    {
        const std::string text(item.str());
        const std::string::size_type bracket = text.find('[');
        names.append(word(text.substr(0, bracket)));
        units.append
        (
            bracket == std::string::npos
          ? string()
          : string(text.substr(bracket + 1, text.find(']') - bracket - 1))
        );
    }

    if
    (
        names.empty() || names[0] != "time"
     || (names_.size() && names != names_)
    )
    {
        FatalErrorInFunction
            << file << " is no table of columns "
            << (names_.size() ? names_ : wordList(1, "time"))
            << ", but of " << names << exit(FatalError);
    }
    for (const DynamicList<scalar>& row : rows)
    {
        if (row.size() != names.size())
        {
            FatalErrorInFunction
                << file << " has a row of " << row.size() << " values for "
                << names.size() << " columns" << exit(FatalError);
        }
    }

    if (names_.empty())
    {
        names_ = names;
        units_ = units;
        columns_.resize(names.size());
    }
    if (rows.empty())
    {
        return;
    }

    label n = 0;
    while (n < time().size() && time()[n] < rows[0][0])
    {
        ++n;
    }
    forAll(columns_, i)
    {
        columns_[i].resize(n + rows.size());
        forAll(rows, rowi)
        {
            columns_[i][n + rowi] = rows[rowi][i];
        }
    }
}


Foam::label Foam::melt::diagnosticsTable::indexOf(const word& name) const
{
    const label i = names_.find(name);
    if (i < 0)
    {
        FatalErrorInFunction
            << "There is no column " << name << nl << "Columns: " << names_
            << exit(FatalError);
    }
    return i;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::diagnosticsTable::diagnosticsTable
(
    const fileName& caseDirectory,
    const word& name
)
{
    const fileName dir(caseDirectory/"postProcessing"/name);
    fileNameList starts(readDir(dir, fileName::DIRECTORY));
    std::sort
    (
        starts.begin(),
        starts.end(),
        [](const fileName& a, const fileName& b)
        {
            return std::atof(a.c_str()) < std::atof(b.c_str());
        }
    );

    for (const fileName& start : starts)
    {
        const fileName file(dir/start/(name + ".dat"));
        if (isFile(file))
        {
            add(file);
        }
    }

    if (columns_.empty() || time().empty())
    {
        FatalErrorInFunction
            << "Case " << caseDirectory << " has no table " << name << nl
            << "Expected: postProcessing/" << name << "/<startTime>/" << name
            << ".dat, as meltFoam writes while it runs" << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::diagnosticsTable::at
(
    const word& name,
    const scalar time
) const
{
    return interpolateXY(time, this->time(), (*this)[name]);
}


Foam::scalar Foam::melt::diagnosticsTable::maxDifference
(
    const word& name,
    const diagnosticsTable& other
) const
{
    const scalar begin = max(time().first(), other.time().first());
    const scalar end = min(time().last(), other.time().last());

    scalar greatest = 0;
    for (const diagnosticsTable* table : {this, &other})
    {
        for (const scalar t : table->time())
        {
            if (t >= begin && t <= end)
            {
                greatest =
                    max(greatest, mag(at(name, t) - other.at(name, t)));
            }
        }
    }
    return greatest;
}


// ************************************************************************* //
