/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectSwitches.H"
#include "meltScene.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::melt::meltScene;

//- An effect and when it is on if it is auto
struct effect
{
    const char* name;

    bool (*needed)(const meltScene&);
};


const effect effects[] =
{
    {
        "artificialViscosity",
        [](const meltScene&) { return true; }
    },
    {
        "generalisedNewtonian",
        [](const meltScene& s) { return s.rheology().shearRateDependent(); }
    },
    {
        "heatConduction",
        [](const meltScene& s)
        {
            const auto range = s.TRange();
            return range.max() > range.min();
        }
    },
    {
        "XSPH",
        [](const meltScene&) { return true; }
    }
};


Foam::wordList effectNames()
{
    Foam::DynamicList<Foam::word> names;
    for (const effect& e : effects)
    {
        names.append(e.name);
    }

    return Foam::wordList(names);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::effectSwitches::effectSwitches
(
    const dictionary& dict,
    const meltScene& scene
)
{
    for (const effect& e : effects)
    {
        const word choice(dict.lookupOrDefault<word>(e.name, "auto"));
        const Switch value(choice, true);

        if (choice != "auto" && !value.valid())
        {
            FatalIOErrorInFunction(dict.lookup(e.name))
                << "Effect " << e.name << " is " << choice
                << ", accepted: on, off, auto" << exit(FatalIOError);
        }

        on_.set(e.name, choice == "auto" ? e.needed(scene) : bool(value));
    }

    for (const word& name : dict.toc())
    {
        if (!on_.found(name))
        {
            FatalIOErrorInFunction(dict.lookup(name))
                << "Unknown effect " << name << nl
                << "Valid effects: " << effectNames() << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::effectSwitches::operator()(const word& effect) const
{
    if (!on_.found(effect))
    {
        FatalErrorInFunction
            << "Unknown effect " << effect << nl
            << "Valid effects: " << effectNames() << exit(FatalError);
    }

    return on_[effect];
}


Foam::wordList Foam::melt::effectSwitches::active() const
{
    return on_.tocValues([](const bool on) { return on; });
}


// ************************************************************************* //
