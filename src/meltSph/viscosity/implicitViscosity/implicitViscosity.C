/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "implicitViscosity.H"
#include "addToRunTimeSelectionTable.H"
#include "apparentViscosity.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(implicitViscosity, 0);
    addToRunTimeSelectionTable(rateTerm, implicitViscosity, dictionary);
}
}


Foam::melt::implicitViscosity::implicitViscosity
(
    const dictionary& dict,
    sphSystem& system
)
:
    rateTerm(system),
    operator_(viscousOperator::New(dict, system))
{
    system_.deformation = true;
}


void Foam::melt::implicitViscosity::allocate()
{
    particles& f = system_.fluid;
    f.require
    (
        {
            &f.eta, &f.S[0], &f.S[1], &f.S[2], &f.S[3], &f.S[4], &f.S[5]
        }
    );
}


void Foam::melt::implicitViscosity::addRates()
{
    setViscosityAndStress
    (
        system_.rheology, system_.fluid, system_.generalisedNewtonian
    );
}

// ************************************************************************* //
