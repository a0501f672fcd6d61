/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "xsphTerm.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(xsphTerm, 0);
    addToRunTimeSelectionTable(rateTerm, xsphTerm, dictionary);
}
}


Foam::melt::xsphTerm::xsphTerm(const dictionary& dict, sphSystem& system)
:
    rateTerm(system)
{
    system_.pairs.xsph = true;
    system_.pairs.epsilon = checkedEntry::get
    (
        dict, "epsilon", dimless, scalarMinMax(0, 1)
    );
}


void Foam::melt::xsphTerm::allocate()
{
    particles& f = system_.fluid;
    f.require({&f.du, &f.dv, &f.dw});
}


// ************************************************************************* //
