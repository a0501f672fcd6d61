/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conductionOperator.H"
#include "conductionOperatorLaws.H"

template<class Pass>
void Foam::melt::conductionOperator::choose(const Pass& pass) const
{
    const particles& f = system_.fluid;
    if (f.kappa.empty())
    {
        pass(conductionCoefficient<true>(f, kappa_));
    }
    else
    {
        pass(conductionCoefficient<false>(f, kappa_));
    }
}


void Foam::melt::conductionOperator::update()
{
    scale_.update(system_.near, system_.walls, kappa_, system_.fluid);
    const particles& f = system_.fluid;
    wall_.resize(f.size());
    fromWalls_.resize(f.size());
    diagonal_.resize(f.size());

    choose([&](const auto& coefficient)
    {
        pairPass
        (
            system_.near, system_.walls, f,
            conductionDiagonalLaw
            (
                coefficient, f, system_.walls, system_.spacing, origin_,
                wall_.data(), fromWalls_.data(), diagonal_.data()
            )
        );
    });
}


void Foam::melt::conductionOperator::apply
(
    const scalarArray& T,
    scalarArray& q
) const
{
    const particles& f = system_.fluid;
    q.resize(f.size());

    choose([&](const auto& coefficient)
    {
        pairPass
        (
            system_.near, system_.walls, f,
            conductionExchangeLaw
            (
                coefficient, f, T.x.data(), wall_.data(), q.x.data()
            )
        );
    });
}


double Foam::melt::conductionOperator::heatFromWalls(const scalarArray& T) const
{
    return blockSum
    (
        T.size(),
        [&](const int i) { return fromWalls_[i] - wall_[i]*T.x[i]; }
    );
}


std::size_t Foam::melt::conductionOperator::bytes() const
{
    return
        sizeof(double)
       *(wall_.capacity() + fromWalls_.capacity() + diagonal_.capacity());
}

// ************************************************************************* //
