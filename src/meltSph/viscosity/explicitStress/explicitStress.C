/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitStress.H"
#include "addToRunTimeSelectionTable.H"
#include "apparentViscosity.H"
#include "blockSum.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(explicitStress, 0);
    addToRunTimeSelectionTable(rateTerm, explicitStress, dictionary);
}
}


Foam::melt::explicitStress::explicitStress
(
    const dictionary&,
    sphSystem& system
)
:
    rateTerm(system)
{
    system_.deformation = true;
    system_.pairs.stress = true;
}


void Foam::melt::explicitStress::allocate()
{
    particles& f = system_.fluid;
    f.require
    (
        {
            &f.eta, &f.S[0], &f.S[1], &f.S[2], &f.S[3], &f.S[4], &f.S[5]
        }
    );
}


void Foam::melt::explicitStress::addRates()
{
    setViscosityAndStress
    (
        system_.rheology, system_.fluid, system_.generalisedNewtonian
    );
}


void Foam::melt::explicitStress::limit(timeStepControl& control) const
{
    const particles& f = system_.fluid;
    const double h = system_.near.kernel().h();
    const double maxNu = parallelMax
    (
        f.size(),
        [&](const int i) { return f.eta[i]/f.rho[i]; }
    );
    // Also if it is not a number, for the control to say so
    if (!(maxNu <= 0))
    {
        control.limit("viscous", h*h/maxNu);
    }
}

// ************************************************************************* //
