/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseSet.H"
#include "HashSet.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::caseSet::caseSet(const fileNameList& dirs)
:
    PtrList<caseResults>(dirs.size())
{
    if (dirs.size() < 2)
    {
        FatalErrorInFunction
            << "There is nothing to compare " << dirs << " with." << nl
            << "Accepted: two methods or cases, or more" << exit(FatalError);
    }

    wordHashSet methods;
    bool unique = true;
    forAll(dirs, i)
    {
        set(i, new caseResults(dirs[i]));
        unique = methods.insert((*this)[i].cost().method) && unique;
    }
    if (!unique)
    {
        for (caseResults& c : *this)
        {
            c.rename(c.dir().name());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::caseSet::lastCommonTime() const
{
    const instantList& times = first().times();
    for (label i = times.size() - 1; i >= 0; --i)
    {
        bool common = true;
        for (const caseResults& c : *this)
        {
            common = common && c.has(times[i].value());
        }
        if (common)
        {
            return times[i].value();
        }
    }

    FatalErrorInFunction << "The cases have no time in common:" << nl;
    for (const caseResults& c : *this)
    {
        FatalError << "    " << c.dir() << ':';
        for (const instant& t : c.times())
        {
            FatalError << ' ' << t.name();
        }
        FatalError << nl;
    }
    FatalError << exit(FatalError);
    return 0;
}


Foam::scalar Foam::melt::caseSet::coarsestResolution() const
{
    scalar coarsest = 0;
    for (const caseResults& c : *this)
    {
        coarsest = max(coarsest, c.cost().resolution);
    }
    return coarsest;
}


// ************************************************************************* //
