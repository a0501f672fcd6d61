/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frozenSolids.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(frozenSolids, 0);
    addToRunTimeSelectionTable(solidModel, frozenSolids, dictionary);
}
}

// ************************************************************************* //
