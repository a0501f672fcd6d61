/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleCollision.H"
#include "blockSum.H"
#include "checkedEntry.H"
#include "collisionLaws.H"
#include "dimensionSets.H"

Foam::melt::particleCollision::particleCollision
(
    const dictionary& dict,
    sphSystem& system
)
:
    system_(system),
    distance_
    (
        checkedEntry::getOrDefault
        (
            dict, "distance", dimless, checkedEntry::positiveUpTo(1), 0.4
        )
    ),
    sweeps_(dict.getCheckOrDefault<label>("sweeps", 20, labelMinMax::ge(1)))
{}


void Foam::melt::particleCollision::collide(const scalar deltaT)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const double distance = distance_*system_.spacing;
    const double fastest2 = parallelMax
    (
        n,
        [&](const int i)
        {
            return f.u[i]*f.u[i] + f.v[i]*f.v[i] + f.w[i]*f.w[i];
        }
    );
    const double reach = distance + 2*deltaT*std::sqrt(fastest2);

    approach_.resize(n);
    inReach_.resize(n);
    change_.resize(n);
    collides_.assign(n, 1);
    const double* const solid = system_.near.solid();
    for (int i = 0; solid && i < n; ++i)
    {
        collides_[i] = solid[i] == 0;
    }
    const std::vector<char>& collides = collides_;
    const auto pass = [&](const auto& law)
    {
        system_.near.countPass(system_.near.fluid());
        pairPassOf
        (
            [&](const int i) { return collides[i]; },
            [&](const int i, const int j) { return collides[i]*collides[j]; },
            system_.near, system_.walls, f, law
        );
    };
    const auto approach = [&]()
    {
        pass(approachLaw(f, distance, deltaT, reach, approach_, inReach_));
        return parallelMax(n, [&](const int i) { return approach_[i]; }) > 0;
    };

    for (label sweep = 0; sweep < sweeps_ && approach(); ++sweep)
    {
        nSteps_ += sweep == 0;
        ++nSweeps_;
        collides_ = inReach_;
        pass(collisionLaw(f, distance, deltaT, approach_, change_));
        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < n; ++i)
        {
            f.u[i] += change_.x[i];
            f.v[i] += change_.y[i];
            f.w[i] += change_.z[i];
        }
    }
}


void Foam::melt::particleCollision::report(Ostream& os) const
{
    if (nSteps_)
    {
        os  << "     particles collide in " << nSteps_ << " steps, "
            << scalar(nSweeps_)/nSteps_ << " sweeps each" << nl;
    }
}

// ************************************************************************* //
