/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "apparentViscosity.H"
#include "effectTimes.H"
#include "shearRate.H"

#include <algorithm>

namespace
{

//- sqrt(S:S/2) of particle i
inline double magnitude(const Foam::melt::particles& f, const int i)
{
    return Foam::melt::shearRate
    (
        f.S[0][i], f.S[1][i], f.S[2][i], f.S[3][i], f.S[4][i], f.S[5][i]
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
    const bool stress = !f.S[0].empty();

    #pragma omp parallel for schedule(static)
    for (int first = 0; first < n; first += blockSize)
    {
        const int last = std::min(n, first + blockSize);
        double rates[blockSize] = {};

        for (int i = first; shearRates && i < last; ++i)
        {
            rates[i - first] =
                (stress ? magnitude(f, i) : f.shearRate[i])/gain;
        }
        rheology.eta(last - first, rates, &f.T[first], &f.eta[first]);
        for (particles::array& s : f.S)
        {
            for (int i = first; stress && i < last; ++i)
            {
                s[i] *= f.eta[i];
            }
        }
    }
}


double Foam::melt::shearRateOf(const particles& f, const int i)
{
    return f.S[0].empty() ? f.shearRate[i] : magnitude(f, i)/f.eta[i];
}

// ************************************************************************* //
