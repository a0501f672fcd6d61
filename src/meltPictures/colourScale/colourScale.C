/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "colourScale.H"
#include "DynamicList.H"
#include "Enum.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const Enum<bool> scaleNames
({
    { false, "linear" },
    { true, "logarithmic" }
});


//- Units of meltFoam's own fields, for the legend
string defaultTitle(const word& fieldName)
{
    const HashTable<string> units
    ({
        { "T", "K" },
        { "rho", "kg/m3" },
        { "p", "Pa" },
        { "eta", "Pa s" },
        { "shearRate", "1/s" },
        { "h", "J/kg" },
        { "m", "kg" },
        { "mag(U)", "m/s" }
    });

    string name(fieldName);
    name.replaceAll("mag(", "|");
    name.replaceAll(")", "|");
    return
        units.found(fieldName) ? name + " [" + units[fieldName] + ']' : name;
}


colourTable readTable(const dictionary& dict)
{
    if (dict.isDict("map"))
    {
        return colourTable(dict.subDict("map"));
    }

    const word name(dict.lookupOrDefault<word>("map", "melt"));
    if (name == "melt")
    {
        return colourTable
        (
            List<colourTable::pair_type>
            ({
                { 0, vector(0.16, 0.36, 0.62) },
                { 0.25, vector(0.45, 0.68, 0.82) },
                { 0.5, vector(0.95, 0.91, 0.76) },
                { 0.75, vector(0.93, 0.58, 0.30) },
                { 1, vector(0.72, 0.13, 0.12) }
            })
        );
    }

    const colourTable* table = colourTable::ptr(name);
    if (!table)
    {
        FatalIOErrorInFunction(dict)
            << "Unknown colour map " << name << " in entry map of "
            << dict.name() << nl
            << "Accepted: melt " << colourTable::tables().sortedToc()
            << exit(FatalIOError);
    }
    return *table;
}


//- The round step, 1, 2 or 5 times a power of ten, that needs no more than n
//  intervals
scalar roundStep(const scalar span, const label n)
{
    const scalar power = Foam::pow(scalar(10), floor(Foam::log10(span/n)));
    for (const scalar factor : {1, 2, 5})
    {
        if (factor*power*n >= span)
        {
            return factor*power;
        }
    }
    return 10*power;
}


string text(const scalar value, const scalar magnitude)
{
    // Zero that is not quite zero for round-off
    std::ostringstream os;
    os << (mag(value) < SMALL*magnitude ? 0 : value);
    return os.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::colourScale::colourScale
(
    const dictionary& dict,
    const word& fieldName,
    const scalarMinMax& range
)
:
    range_(dict.lookupOrDefault("range", range)),
    logarithmic_(scaleNames.lookupOrDefault("scale", dict, false)),
    table_(readTable(dict)),
    title_(dict.lookupOrDefault("title", defaultTitle(fieldName)))
{
    if (dict.found("range") && !(range_.min() < range_.max()))
    {
        FatalIOErrorInFunction(dict)
            << "Entry range of " << dict.name() << " is " << range_ << nl
            << "Accepted: (min max) with min < max" << exit(FatalIOError);
    }
    if (logarithmic_)
    {
        if (!(range_.min() > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry scale of " << dict.name()
                << " is logarithmic, but field " << fieldName
                << " starts at " << range_.min() << nl
                << "Accepted: values greater than 0; set range"
                << exit(FatalIOError);
        }
        range_ = scalarMinMax
        (
            Foam::log10(range_.min()),
            Foam::log10(range_.max())
        );
    }
    if (!(range_.min() < range_.max()))
    {
        // A uniform field
        range_ = scalarMinMax(range_.min() - 1, range_.min() + 1);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::colourScale::position(const scalar value) const
{
    const scalar x = logarithmic_ ? Foam::log10(max(value, VSMALL)) : value;
    return min(max((x - range_.min())/range_.mag(), scalar(0)), scalar(1));
}


Foam::vector Foam::melt::colourScale::colour(const scalar position) const
{
    return table_.value(position);
}


Foam::List<Foam::melt::colourScale::tick>
Foam::melt::colourScale::ticks(const label maxTicks) const
{
    DynamicList<tick> result(maxTicks);

    if (logarithmic_ && range_.mag() >= 2)
    {
        const scalar step = max(roundStep(range_.mag(), maxTicks), scalar(1));
        for
        (
            scalar x = ceil(range_.min()/step - SMALL)*step;
            x <= range_.max() + SMALL*step;
            x += step
        )
        {
            const scalar value = Foam::pow(scalar(10), x);
            result.append(tick(value, text(value, 0)));
        }
        return result;
    }

    scalarMinMax range(range_);
    if (logarithmic_)
    {
        range = scalarMinMax
        (
            Foam::pow(scalar(10), range_.min()),
            Foam::pow(scalar(10), range_.max())
        );
    }
    const scalar step = roundStep(range.mag(), maxTicks);
    const scalar tolerance = 1e-6;  // of a step: round-off of the range
    for
    (
        scalar i = ceil(range.min()/step - tolerance);
        i <= range.max()/step + tolerance;
        i += 1
    )
    {
        result.append(tick(i*step, text(i*step, step)));
    }
    return result;
}


// ************************************************************************* //
