/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costRequest.H"
#include "error.H"

#include <cmath>
#include <cstdlib>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The number with which a text begins, NaN if there is none; what follows it
Foam::scalar number(const std::string& text, std::string& rest)
{
    char* end = nullptr;
    const Foam::scalar value = std::strtod(text.c_str(), &end);
    rest = end;
    return end == text.c_str() ? std::nan("") : value;
}


//- Seconds in a unit of time; 0 if it is unknown
Foam::scalar seconds(const std::string& unit)
{
    return
        unit == "s" || unit.empty() ? 1
      : unit == "min" ? 60
      : unit == "h" ? 3600
      : unit == "d" ? 86400
      : 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::costRequest Foam::melt::costRequest::budget(const string& text)
{
    std::string unit;
    const scalar value = number(text, unit);

    if (!(value > 0 && std::isfinite(value)) || !seconds(unit))
    {
        FatalErrorInFunction
            << "Option -budget is " << text.c_str()
            << ", accepted: a number > 0 with unit s, min, h or d, as 60s"
            << exit(FatalError);
    }

    return {true, value*seconds(unit)};
}


Foam::melt::costRequest Foam::melt::costRequest::accuracy(const string& text)
{
    std::string rest;
    const scalar value = number(text, rest);

    if (!(value > 0 && value < 1) || !rest.empty())
    {
        FatalErrorInFunction
            << "Option -accuracy is " << text.c_str()
            << ", accepted: a relative error, > 0 and < 1, as 0.03"
            << exit(FatalError);
    }

    return {false, value};
}


// ************************************************************************* //
