/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "implicitConduction.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(implicitConduction, 0);
    addToRunTimeSelectionTable(rateTerm, implicitConduction, dictionary);
}
}


Foam::melt::implicitConduction::implicitConduction
(
    const dictionary& dict,
    sphSystem& system
)
:
    rateTerm(system),
    tolerance_
    (
        checkedEntry::getOrDefault
        (
            dict, "tolerance", dimless, checkedEntry::positiveUpTo(1), 1e-9
        )
    ),
    maxIterations_
    (
        dict.getCheckOrDefault<label>
        (
            "maxIterations", 1000, labelMinMax::ge(1)
        )
    ),
    maxPhaseIterations_
    (
        dict.getCheckOrDefault<label>
        (
            "maxPhaseIterations", 50, labelMinMax::ge(1)
        )
    ),
    curve_
    (
        system.thermo.enthalpy(),
        std::sqrt(SMALL)*(system.thermo.TMax() - system.thermo.TMin())
    ),
    operator_
    (
        system,
        system.thermo.enthalpy().solidus,
        system.thermo.kappaSolid()
    )
{}


void Foam::melt::implicitConduction::allocate()
{
    if (!uniformConductivity(system_.thermo))
    {
        system_.fluid.require({&system_.fluid.kappa});
    }
}


bool Foam::melt::implicitConduction::solveLinear(const scalar deltaT)
{
    const particles& f = system_.fluid;
    const int n = f.size();

    const auto slope = [&](const int i)
    {
        return f.m[i]*curve_.slope(first_[i], second_[i]);
    };
    const auto taken = [&](const int i, const double t)
    {
        return slope(i)*t + f.m[i]*(curve_.origin(second_[i]) - f.h[i]);
    };

    operator_.apply(t_, r_);
    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        r_.x[i] = deltaT*(operator_.source(i) - r_.x[i]) - taken(i, t_.x[i]);
    }

    const auto apply = [&](const scalarArray& p, scalarArray& Ap)
    {
        operator_.apply(p, Ap);
        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < n; ++i)
        {
            Ap.x[i] = slope(i)*p.x[i] + deltaT*Ap.x[i];
        }
    };
    const auto precondition = [&](const scalarArray& r, scalarArray& z)
    {
        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < n; ++i)
        {
            z.x[i] = r.x[i]/(slope(i) + deltaT*operator_.diagonal(i));
        }
    };
    const auto heat = [&](const scalarArray& t)
    {
        return std::sqrt
        (
            blockSum(n, [&](const int i) { return sqr(taken(i, t.x[i])); })
        ) + VSMALL;
    };

    // Round-off of the enthalpies
    const double roundOff =
        SMALL*system_.thermo.enthalpy().CpSolid*system_.thermo.TMax();
    const double negligible = blockSum
    (
        n,
        [&](const int i) { return sqr(f.m[i]*roundOff)/slope(i); }
    );

    const auto result = solver_.solve
    (
        apply, precondition, heat, tolerance_, negligible, maxIterations_,
        t_, r_
    );
    ++nSystems_;
    nIterations_ += result.iterations;
    return result.converged;
}


bool Foam::melt::implicitConduction::solve(const scalar deltaT)
{
    const int n = system_.fluid.size();
    const auto changed = [&]
    (
        std::vector<char>& branch,
        bool (splitEnthalpy::*of)(double) const
    )
    {
        int count = 0;
        #pragma omp parallel for schedule(static) reduction(+:count)
        for (int i = 0; i < n; ++i)
        {
            const char now = (curve_.*of)(t_.x[i]);
            count += now != branch[i];
            branch[i] = now;
        }
        return count > 0;
    };

    first_.resize(n);
    second_.resize(n);
    changed(first_, &splitEnthalpy::first);
    changed(second_, &splitEnthalpy::second);

    for (label system = 0; system < maxPhaseIterations_; ++system)
    {
        if (!solveLinear(deltaT))
        {
            return false;
        }
        if
        (
            !changed(first_, &splitEnthalpy::first)
         && !changed(second_, &splitEnthalpy::second)
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::melt::implicitConduction::advanceHeat(const scalar deltaT)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const enthalpyCurve curve = system_.thermo.enthalpy();

    t_.resize(n);
    r_.resize(n);
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.V[i] = f.m[i]/f.rho[i];
        t_.x[i] = curve_.t(f.h[i]);
    }
    if (!f.kappa.empty())
    {
        setConductivity(system_.thermo, f);
    }
    operator_.update();

    if (!solve(deltaT))
    {
        ++nHalved_;
        Info<< "implicitConduction: no convergence in a step of " << deltaT
            << " s, done again in two" << endl;
        if (!(deltaT > VSMALL))
        {
            FatalErrorInFunction
                << "The step has shrunk to " << deltaT << " s without the"
                << " temperatures converging" << exit(FatalError);
        }
        advanceHeat(deltaT/2);
        advanceHeat(deltaT/2);
        return;
    }

    operator_.apply(t_, q_);
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.h[i] += deltaT*(operator_.source(i) - q_.x[i])/f.m[i];
        f.T[i] = curve.T(f.h[i]);
    }
    system_.heatReceived += deltaT*operator_.heatFromWalls(t_);
    ++nSteps_;
}


void Foam::melt::implicitConduction::report(Ostream& os) const
{
    if (!nSteps_)
    {
        return;
    }
    const std::size_t bytes =
        solver_.bytes() + operator_.bytes()
      + t_.bytes() + q_.bytes() + r_.bytes()
      + first_.capacity() + second_.capacity();

    os  << "     implicit conduction: " << nSystems_/nSteps_
        << " systems a step, " << nIterations_/nSystems_
        << " iterations a system, "
        << label(bytes/max(system_.fluid.size(), 1)) << " bytes a particle"
        << nl;
    if (nHalved_)
    {
        os  << "     conduction done again in halves: " << nHalved_ << nl;
    }
}

// ************************************************************************* //
