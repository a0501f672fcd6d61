/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::eulerianMethod::exchangeHeat(const scalar deltaT)
{
    const scalarField& alpha = interface_.alpha();
    energy_.setT(alpha, alphaH_);
    if (!conducts_ && !heating_->active())
    {
        return;
    }
    const scalar time = mesh_.time().value() - remaining_ + 0.5*deltaT;
    energyRecord_ = energy_.advance
    (
        alpha,
        deltaT,
        heating_->heat
        (
            time,
            alpha,
            energy_.T(),
            energy_.conductivity(alphaH_/max(alpha, SMALL))
        ),
        alphaH_
    );
    nEnergyIterations_ += energyRecord_.iterations;
    if (!energyRecord_.converged)
    {
        fail
        (
            deltaT,
            "energy",
            energyRecord_.errors,
            "Remedy: a smaller deltaT in controlDict, or more maxIterations of"
            " energy in eulerianSolution"
        );
    }
    heatIn_ += energyRecord_.in;
    heatOut_ += energyRecord_.out;
    energy_.setT(alpha, alphaH_);
}

// ************************************************************************* //
