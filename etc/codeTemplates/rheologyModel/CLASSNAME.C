/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "CLASSNAME.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(CLASSNAME, 0);
    addToRunTimeSelectionTable(rheologyModel, CLASSNAME, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::CLASSNAME::CLASSNAME(const dictionary& dict)
{
    using namespace checkedEntry;

    coeffs_.eta0 = get(dict, "eta0", dimPressure*dimTime, positive());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::CLASSNAME::eta
(
    const label n,
    const scalar* shearRate,
    const scalar* T,
    scalar* eta
) const
{
    const coefficients coeffs(coeffs_);

    #pragma omp simd
    for (label i = 0; i < n; ++i)
    {
        eta[i] = coeffs.eta(shearRate[i], T[i]);
    }
}


Foam::scalar Foam::melt::CLASSNAME::etaMax
(
    const scalar TMin,
    const scalar TMax
) const
{
    return coeffs_.eta0;
}


// ************************************************************************* //
