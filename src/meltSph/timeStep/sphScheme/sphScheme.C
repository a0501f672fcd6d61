/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphScheme.H"
#include "effectTimes.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(sphScheme, 0);
    defineRunTimeSelectionTable(sphScheme, dictionary);
}
}


Foam::autoPtr<Foam::melt::sphScheme> Foam::melt::sphScheme::New
(
    const dictionary& dict,
    const effectSwitches& effects,
    sphSystem& system
)
{
    const word type(dict.get<word>("scheme"));
    const auto constructor = dictionaryConstructorTablePtr_->cfind(type);

    if (!constructor.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            "scheme",
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return autoPtr<sphScheme>(constructor()(dict, effects, system));
}


Foam::melt::sphScheme::sphScheme
(
    const dictionary& dict,
    const effectSwitches& effects,
    sphSystem& system
)
:
    system_(system),
    equations_(dict, effects, system)
{}


void Foam::melt::sphScheme::allocate()
{
    equations_.allocate();
}


void Foam::melt::sphScheme::start()
{
    equations_.evaluate();
}


const Foam::melt::timeStepControl& Foam::melt::sphScheme::limits()
{
    return equations_.limits();
}


void Foam::melt::sphScheme::report(Ostream& os) const
{
    equations_.report(os);
    if (halvedSteps_)
    {
        os  << "     steps done again in halves: " << halvedSteps_ << nl;
    }
}


void Foam::melt::sphScheme::updateNeighbours(const scalar longestWay)
{
    if (system_.near.outdated(longestWay))
    {
        const effectTimes::part timing(effectTimes::flow, "neighbourhood");
        system_.near.build(system_.fluid, system_.walls);
    }
}

// ************************************************************************* //
