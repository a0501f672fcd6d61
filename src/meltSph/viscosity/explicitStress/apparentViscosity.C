/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "apparentViscosity.H"
#include "effectTimes.H"

#include <algorithm>
#include <cmath>

namespace
{

//- sqrt(S:S/2) of particle i
inline double magnitude(const Foam::melt::particles& f, const int i)
{
    const double xx = f.S[0][i], xy = f.S[1][i], xz = f.S[2][i];
    const double yy = f.S[3][i], yz = f.S[4][i], zz = f.S[5][i];
    return std::sqrt
    (
        0.5*(xx*xx + yy*yy + zz*zz) + xy*xy + xz*xz + yz*yz
    );
}

} // End anonymous namespace


void Foam::melt::setViscosityAndStress
(
    const rheologyModel& rheology,
    particles& f,
    const bool shearRates,
    const double gain
)
{
    const effectTimes::part timing
    (
        shearRates ? "generalisedNewtonian" : effectTimes::flow,
        "apparentViscosity"
    );
    constexpr int blockSize = 1024;
    const int n = f.size();

    #pragma omp parallel for schedule(static)
    for (int first = 0; first < n; first += blockSize)
    {
        const int last = std::min(n, first + blockSize);
        double shearRate[blockSize] = {};

        for (int i = first; shearRates && i < last; ++i)
        {
            shearRate[i - first] = magnitude(f, i)/gain;
        }
        rheology.eta(last - first, shearRate, &f.T[first], &f.eta[first]);
        for (particles::array& s : f.S)
        {
            for (int i = first; i < last; ++i)
            {
                s[i] *= f.eta[i];
            }
        }
    }
}


double Foam::melt::shearRateOf(const particles& f, const int i)
{
    return magnitude(f, i)/f.eta[i];
}

// ************************************************************************* //
