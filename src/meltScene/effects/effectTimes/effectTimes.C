/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectTimes.H"
#include "DynamicList.H"

#include <chrono>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using melt::effectTimes::record;

using steadyClock = std::chrono::steady_clock;

DynamicList<record> records;

//- The innermost part, -1 outside all, and since when it runs
label current = -1;
steadyClock::time_point since;


//- Stop the clock of the innermost part and start that of another
void change(const label to)
{
    const steadyClock::time_point now = steadyClock::now();
    if (current >= 0)
    {
        records[current].seconds +=
            std::chrono::duration<double>(now - since).count();
    }
    current = to;
    since = now;
}


//- Index of a part, appended if it is new. Names are compared as characters:
//  no word is made
label find(const char* effect, const char* name)
{
    forAll(records, i)
    {
        if (records[i].name == name && records[i].effect == effect)
        {
            return i;
        }
    }
    records.append({effect, name, 0, 0});
    return records.size() - 1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::effectTimes::part::part(const char* effect, const char* name)
:
    interrupted_(current)
{
    const label i = find(effect, name);
    ++records[i].calls;
    change(i);
}


Foam::melt::effectTimes::part::~part()
{
    change(interrupted_);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const Foam::UList<Foam::melt::effectTimes::record>&
Foam::melt::effectTimes::parts()
{
    return records;
}


Foam::scalar Foam::melt::effectTimes::seconds(const word& effect)
{
    scalar sum = 0;
    for (const record& r : records)
    {
        sum += r.effect == effect ? r.seconds : 0;
    }
    return sum;
}


Foam::scalar Foam::melt::effectTimes::seconds()
{
    scalar sum = 0;
    for (const record& r : records)
    {
        sum += r.seconds;
    }
    return sum;
}


void Foam::melt::effectTimes::divide
(
    const word& name,
    const UList<Tuple2<word, scalar>>& shares
)
{
    const label n = records.size();
    label from = 0;
    while (from < n && records[from].name != name)
    {
        ++from;
    }
    if (from == n)
    {
        return;
    }
    const record whole(records[from]);
    for (const Tuple2<word, scalar>& share : shares)
    {
        const scalar given = share.second()*whole.seconds;
        records[from].seconds -= given;
        records.append({share.first(), name, given, whole.calls});
    }
}


void Foam::melt::effectTimes::clear()
{
    records.clear();
    current = -1;
}


// ************************************************************************* //
