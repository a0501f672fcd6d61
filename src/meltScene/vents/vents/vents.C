/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vents.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::vents::make()
{
    const dictionary& dict = dict_.subOrEmptyDict("vents");
    const wordList names(dict.toc());

    clear();
    setSize(names.size());
    forAll(names, i)
    {
        set(i, new vent(names[i], dict.subDict(names[i])));
    }
    digest_ = dict.digest();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::vent::vent(const word& name, const dictionary& dict)
:
    name_(name),
    dict_(dict),
    position_(dict.get<point>("position")),
    radius_
    (
        checkedEntry::get(dict, "radius", dimLength, checkedEntry::positive())
    ),
    rate_(Function1<scalar>::New("rate", dict)),
    T_
    (
        checkedEntry::get
        (
            dict, "temperature", dimTemperature, checkedEntry::positive()
        )
    ),
    active_(dict.lookupOrDefault<bool>("active", true))
{
    rate(0);
}


Foam::melt::vents::vents(const dictionary& meltProperties)
:
    dict_(meltProperties)
{
    make();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::vent::rate(const scalar time) const
{
    const scalar value = rate_->value(time);
    checkedEntry::check(dict_, "rate", value, checkedEntry::notNegative());
    return active_ ? value : 0;
}


bool Foam::melt::vents::update()
{
    if (dict_.subOrEmptyDict("vents").digest() == digest_)
    {
        return false;
    }
    make();
    return true;
}

// ************************************************************************* //
