/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costModel.H"
#include "checkedEntry.H"
#include "DynamicList.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::melt::costModel;
using Foam::melt::costRequest;

bool meets(const costModel::choice& c, const costRequest& request)
{
    return
        request.limit
     >= (request.isBudget ? c.guess.worstCpuTime() : c.guess.worstError());
}


//- Is a better than b: more accurate if there is a budget, cheaper otherwise
bool better
(
    const costModel::choice& a,
    const costModel::choice& b,
    const bool accuracyFirst
)
{
    const Foam::scalar error = a.guess.worstError() - b.guess.worstError();
    const Foam::scalar time = a.guess.worstCpuTime() - b.guess.worstCpuTime();

    return
        accuracyFirst
      ? error < 0 || (error == 0 && time < 0)
      : time < 0 || (time == 0 && error < 0);
}


const costModel::choice& best
(
    const Foam::UList<costModel::choice>& list,
    const bool accuracyFirst
)
{
    const costModel::choice* found = &list[0];
    for (const costModel::choice& c : list)
    {
        if (better(c, *found, accuracyFirst))
        {
            found = &c;
        }
    }
    return *found;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::costModel::costModel(const dictionary& dict)
:
    dict_(dict),
    extrapolation_
    (
        checkedEntry::get
        (
            dict, "extrapolation", dimless, scalarMinMax(1, GREAT)
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::melt::costModel::machine() const
{
    return dict_.get<string>("machine");
}


Foam::wordList Foam::melt::costModel::cases(const word& caseClass) const
{
    return dict_.subDict("classes").subDict(caseClass).get<wordList>("cases");
}


Foam::melt::costModel::choice Foam::melt::costModel::choose
(
    const costRequest& request,
    const caseScales& scales,
    const filter& usable
) const
{
    const dictionary& classes = dict_.subDict("classes");
    if (!classes.found(scales.caseClass))
    {
        FatalErrorInFunction
            << "Nothing is known of cases of class " << scales.caseClass << nl
            << "Measured: " << classes.toc() << exit(FatalError);
    }

    const dictionary& methods =
        classes.subDict(scales.caseClass).subDict("methods");

    DynamicList<choice> all;
    DynamicList<choice> met;

    for (const word& method : methods.toc())
    {
        if (!usable(method))
        {
            continue;
        }

        const costCurve curve(method, methods.subDict(method));
        const label finest = std::floor(curve.n().max()*extrapolation_);

        for (label n = std::ceil(curve.n().min()); n <= finest; ++n)
        {
            all.append
            ({
                method,
                curve.at(n, scales),
                methods.subDict(method).lookupOrDefault
                (
                    "cases", cases(scales.caseClass)
                ),
                n,
                curve.n().max()
            });
            if (meets(all.last(), request))
            {
                met.append(all.last());
            }
        }
    }

    if (all.empty())
    {
        FatalErrorInFunction
            << "No method that can be used here has been measured in cases of"
            << " class " << scales.caseClass << nl
            << "Measured: " << methods.toc() << exit(FatalError);
    }

    if (met.empty())
    {
        FatalErrorInFunction
            << (request.isBudget ? "A budget of " : "An accuracy of ")
            << request.limit << (request.isBudget ? " s" : "")
            << " cannot be met in a case of class " << scales.caseClass << nl
            << (request.isBudget ? "The cheapest: " : "The most accurate: ")
            << best(all, !request.isBudget) << exit(FatalError);
    }

    return best(met, request.isBudget);
}


// * * * * * * * * * * * * * * * Ostream Operator  * * * * * * * * * * * * * //

Foam::Ostream& Foam::melt::operator<<
(
    Ostream& os,
    const costModel::choice& c
)
{
    const auto upTo = [&os](const scalar worst, const char* unit)
    {
        if (worst < sqrt(GREAT))
        {
            os << worst << unit;
        }
        else
        {
            os << "nobody knows: too few points";
        }
    };
    os  << c.method << " at " << c.guess.resolution << " m: error "
        << c.guess.error << " (up to ";
    upTo(c.guess.worstError(), "");
    os  << "), CPU time " << c.guess.cpuTime << " s (up to ";
    upTo(c.guess.worstCpuTime(), " s");
    os  << "), 95 % prediction intervals, that of the error by "
        << c.guess.errorFreedom << " degrees of freedom";
    if (c.n > c.finest)
    {
        os  << "; extrapolated: " << c.n << " elements across, at most "
            << c.finest << " were tried";
    }
    return os;
}


// ************************************************************************* //
