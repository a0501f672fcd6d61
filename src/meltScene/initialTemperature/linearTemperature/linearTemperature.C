/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "linearTemperature.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "shape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(linearTemperature);
    addToRunTimeSelectionTable
    (
        initialTemperature,
        linearTemperature,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static Foam::scalar readTemperature
(
    const Foam::dictionary& dict,
    const Foam::word& keyword
)
{
    using namespace Foam::melt;

    return checkedEntry::get
    (
        dict,
        keyword,
        Foam::dimTemperature,
        checkedEntry::notNegative()
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::linearTemperature::linearTemperature
(
    const dictionary& dict,
    const shape& body
)
:
    gradient_(Zero),
    start_(0),
    T1_(readTemperature(dict, "T1")),
    T2_(readTemperature(dict, "T2"))
{
    if (dict.found("direction") && dict.found("point1"))
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'direction' and 'point1' are both given; accepted is"
            << " one of them" << exit(FatalIOError);
    }

    if (dict.found("direction"))
    {
        const auto direction = dict.get<vector>("direction");
        if (!(mag(direction) > 0))
        {
            FatalIOErrorInFunction(dict.lookup("direction"))
                << "Entry 'direction' is " << direction
                << "; accepted is a vector that is not zero"
                << exit(FatalIOError);
        }
        const scalarMinMax extent(body.extent(direction));
        gradient_ = direction/extent.span();
        start_ = extent.min()/extent.span();
    }
    else
    {
        const auto point1 = dict.get<point>("point1");
        const auto point2 = dict.get<point>("point2");
        if (!(mag(point2 - point1) > 0))
        {
            FatalIOErrorInFunction(dict.lookup("point2"))
                << "Entry 'point2' is " << point2
                << "; accepted is a point other than 'point1'"
                << exit(FatalIOError);
        }
        gradient_ = (point2 - point1)/magSqr(point2 - point1);
        start_ = gradient_ & point1;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::melt::linearTemperature::value
(
    const pointField& points
) const
{
    const scalarField share
    (
        min(max((gradient_ & points) - start_, scalar(0)), scalar(1))
    );

    // So that the ends are T1 and T2 exactly
    return (1 - share)*T1_ + share*T2_;
}


// ************************************************************************* //
