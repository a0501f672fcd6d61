/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "comparisonSettings.H"
#include "checkedEntry.H"
#include "IFstream.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Empty without such a file
dictionary readDict(const fileName& file)
{
    return isFile(file) ? dictionary(IFstream(file)()) : dictionary();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::comparisonSettings::comparisonSettings
(
    const fileName& caseDir,
    const caseSet& cases
)
:
    dict_(readDict(caseDir/"system"/"meltCompareDict")),
    tolerances_
    (
        dict_.subOrEmptyDict("tolerances"), cases[0].diagnostics().names()
    ),
    pictures_(dict_.subOrEmptyDict("pictures")),
    spacing_
    (
        checkedEntry::getOrDefault
        (
            dict_,
            "gridSpacing",
            dimLength,
            checkedEntry::positive(),
            cases.coarsestResolution()
        )
    )
{
    if (!dict_.readIfPresent("times", times_))
    {
        times_ = scalarList(1, cases.lastCommonTime());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::PtrList<Foam::melt::pairComparison>
Foam::melt::comparisonSettings::compare(caseSet& cases) const
{
    Info<< "Comparing at " << times_ << " s on cells of " << spacing_ << " m"
        << endl;

    PtrList<pairComparison> pairs;
    forAll(cases, i)
    {
        for (label j = i + 1; j < cases.size(); ++j)
        {
            pairs.append
            (
                new pairComparison(cases[i], cases[j], times_, spacing_)
            );
        }
    }
    return pairs;
}


// ************************************************************************* //
