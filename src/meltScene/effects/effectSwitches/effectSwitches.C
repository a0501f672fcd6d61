/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectSwitches.H"
#include "dictionary.H"
#include "effectTimes.H"
#include "Switch.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::melt::effectSwitches::effect*
Foam::melt::effectSwitches::find(const word& name) const
{
    for (const effect& e : effects_)
    {
        if (e.name == name)
        {
            return &e;
        }
    }
    return nullptr;
}


Foam::wordList Foam::melt::effectSwitches::names() const
{
    DynamicList<word> list;
    for (const effect& e : effects_)
    {
        list.append(e.name);
    }
    return wordList(list);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::effectSwitches::effectSwitches
(
    const dictionary& dict,
    const meltScene& scene
)
{
    for (const effectRules::rule& rule : effectRules::all())
    {
        const word choice(dict.lookupOrDefault<word>(rule.name, "auto"));
        const Switch value(choice, true);

        if (choice != "auto" && !value.valid())
        {
            FatalIOErrorInFunction(dict.lookup(rule.name))
                << "Effect " << rule.name << " is " << choice
                << ", accepted: on, off, auto" << exit(FatalIOError);
        }

        const effectRules::verdict verdict(rule.judge(scene));
        effects_.append
        ({
            rule.name,
            choice == "auto" ? verdict.needed : bool(value),
            choice == "auto",
            verdict,
            rule.within
        });
    }

    for (const word& name : dict.toc())
    {
        if (!find(name))
        {
            FatalIOErrorInFunction(dict.lookup(name))
                << "Unknown effect " << name << nl
                << "Valid effects: " << names() << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::effectSwitches::off
(
    const dictionary& dict,
    const word& effect
)
{
    const Switch value(dict.lookupOrDefault<word>(effect, "auto"), true);
    return value.valid() && !value;
}


bool Foam::melt::effectSwitches::operator()(const word& name) const
{
    const effect* e = find(name);

    if (!e)
    {
        FatalErrorInFunction
            << "Unknown effect " << name << nl
            << "Valid effects: " << names() << exit(FatalError);
    }

    return e->on;
}


Foam::wordList Foam::melt::effectSwitches::active() const
{
    DynamicList<word> list;
    for (const effect& e : effects_)
    {
        if (e.on)
        {
            list.append(e.name);
        }
    }
    return wordList(list);
}


void Foam::melt::effectSwitches::report(Ostream& os) const
{
    std::ostringstream table;
    table << std::left;

    for (const effect& e : effects_)
    {
        table
            << "    " << std::setw(22) << e.name
            << std::setw(4) << (e.on ? "on" : "off")
            << std::setw(6) << (e.automatic ? "auto" : "given")
            << std::setw(26) << e.verdict.number << e.verdict.why << '\n';
    }

    os  << "Effects" << nl << table.str().c_str();

    for (const effect& e : effects_)
    {
        if (e.verdict.needed && !e.on)
        {
            os  << "Warning: " << e.name << " is off, but "
                << e.verdict.why.c_str() << " (" << e.verdict.number.c_str()
                << "). The result lacks it." << nl;
        }
    }
    os  << endl;
}


void Foam::melt::effectSwitches::warnNotSimulated
(
    const word& name,
    const word& method
) const
{
    if ((*this)(name))
    {
        WarningInFunction
            << "Effect " << name << " is on, " << find(name)->verdict.number
            << ", but the method " << method
            << " does not simulate it. The result lacks it." << endl;
    }
}


void Foam::melt::effectSwitches::reportTimes(Ostream& os) const
{
    const scalar total = effectTimes::seconds();
    if (!(total > 0))
    {
        return;
    }
    std::ostringstream table;
    table << std::left << std::fixed << std::setprecision(1);
    const auto share = [&](const scalar seconds)
    {
        table << std::right << std::setw(6) << 100*seconds/total << " %"
              << std::left;
    };

    for (const effect& e : effects_)
    {
        table
            << "    " << std::setw(22) << e.name
            << std::setw(4) << (e.on ? "on" : "off");
        const scalar seconds = effectTimes::seconds(e.name);
        if (e.on && e.within && !seconds)
        {
            table << "  in " << e.within;
        }
        else
        {
            share(seconds);
        }
        table << '\n';
    }
    table << "    " << std::setw(26) << effectTimes::flow;
    share(effectTimes::seconds(effectTimes::flow));
    table << "\nParts of a step\n";
    for (const effectTimes::record& part : effectTimes::parts())
    {
        table << "    " << std::setw(26) << part.name;
        share(part.seconds);
        table << "  " << std::setw(22) << part.effect << part.calls
              << " calls\n";
    }

    os  << "Effects, share of the time of the steps, " << total << " s" << nl
        << table.str().c_str() << endl;
}


// ************************************************************************* //
