/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "implicitViscosity.H"
#include "addToRunTimeSelectionTable.H"
#include "apparentViscosity.H"
#include "blockSum.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "latticeMoment.H"
#include "velocityGradient.H"
#include "wallExtrapolation.H"

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
    operator_(viscousOperator::New(dict, system)),
    gain_(latticeMoment(system.near.kernel(), system.spacing)),
    maxSolves_
    (
        dict.getCheckOrDefault<label>("maxSolves", 1, labelMinMax::ge(1))
    ),
    etaTolerance_
    (
        checkedEntry::getOrDefault
        (
            dict, "etaTolerance", dimless, checkedEntry::positive(), 0.05
        )
    ),
    etaRelaxation_
    (
        checkedEntry::getOrDefault
        (
            dict, "etaRelaxation", dimless, checkedEntry::positiveUpTo(1), 0.5
        )
    )
{
    system_.deformation = true;
}


void Foam::melt::implicitViscosity::allocate()
{
    particles& f = system_.fluid;
    f.require({&f.eta, &f.shearRate});
}


void Foam::melt::implicitViscosity::addRates()
{
    setViscosityAndStress
    (
        system_.rheology,
        system_.fluid,
        system_.generalisedNewtonian,
        gain_
    );
}


bool Foam::melt::implicitViscosity::couple(const label nSolved)
{
    ++nSolves_;
    nSteps_ += nSolved == 1;
    if (maxSolves_ == 1)
    {
        return true;
    }

    particles& f = system_.fluid;
    const int n = f.size();
    etaSolved_ = f.eta;
    wallExtrapolation(system_.near, f, system_.g, system_.walls);
    velocityGradient(system_.near, system_.walls, f, true);
    setViscosityAndStress(system_.rheology, f, true, gain_);

    lastChange_ = n ? parallelMax
    (
        n,
        [&](const int i)
        {
            return
                !system_.solid.empty() && system_.solid[i]
              ? 0
              : std::abs(std::log(f.eta[i]/etaSolved_[i]));
        }
    ) : 0;
    if (lastChange_ <= etaTolerance_)
    {
        return true;
    }
    if (nSolved == maxSolves_)
    {
        ++nNotCoupled_;
        return true;
    }

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.eta[i] =
            etaSolved_[i]*std::pow(f.eta[i]/etaSolved_[i], etaRelaxation_);
    }
    return false;
}


void Foam::melt::implicitViscosity::report(Ostream& os) const
{
    if (maxSolves_ > 1 && nSteps_)
    {
        os  << "     viscosity: " << scalar(nSolves_)/nSteps_
            << " solves a step, last change of log(eta) " << lastChange_
            << ", steps that ended above etaTolerance: " << nNotCoupled_ << nl;
    }
}

// ************************************************************************* //
