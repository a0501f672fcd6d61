/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepShares.H"
#include "dictionary.H"
#include "profiling.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::stepShares::print(Ostream& os)
{
    if (!profiling::active())
    {
        os  << "Parts of a step: not known, see entry profiling of"
            << " etc/caseDicts/meltFoam/controlDict" << nl << endl;
        return;
    }

    OStringStream text;
    profiling::print(text);
    const dictionary dict(IStringStream(text.str())());
    const dictionary& parts = dict.subDict("profiling");

    label id = -1;
    scalar total = 0;
    for (const entry& e : parts)
    {
        if (e.isDict() && e.dict().get<string>("description") == step)
        {
            id = e.dict().get<label>("id");
            total = e.dict().get<scalar>("totalTime");
        }
    }
    if (!(total > 0))
    {
        return;
    }

    os  << "Parts of a step" << nl;
    scalar rest = total;
    for (const entry& e : parts)
    {
        if
        (
            e.isDict()
         && e.dict().lookupOrDefault<label>("parentId", -1) == id
        )
        {
            const scalar time = e.dict().get<scalar>("totalTime");
            rest -= time;
            os  << "    " << e.dict().get<string>("description").c_str()
                << ": " << 100*time/total << " %, "
                << e.dict().get<label>("calls") << " calls" << nl;
        }
    }
    os  << "    rest: " << 100*rest/total << " %" << nl << endl;
}


// ************************************************************************* //
