/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "filmViscosity.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Table: steps in temperature, steps an octave of stress
constexpr int nTemperatures = 257;
constexpr int perOctave = 4;

//- Shear rate [1/s] at a stress [Pa], by bisection: stress rises with rate
double shearRate
(
    const Foam::melt::filmViscosity::viscosity& eta,
    const double T,
    const double tau
)
{
    double low = -80, high = 60;    // log2 of the rate
    for (int i = 0; i < 60; ++i)
    {
        const double middle = 0.5*(low + high);
        const double rate = std::exp2(middle);
        (eta(rate, T)*rate < tau ? low : high) = middle;
    }
    return std::exp2(0.5*(low + high));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::filmViscosity::filmViscosity
(
    const viscosity& eta,
    const bool shearRateDependent,
    const double TMin,
    const double TMax,
    const double tauMin,
    const double tauMax,
    const double yieldStress
)
:
    TMin_(TMin),
    TStep_(std::max(TMax - TMin, 1e-6)/(nTemperatures - 1)),
    nT_(nTemperatures),
    nTau_(1),
    log2TauMin_(std::log2(tauMin)),
    log2TauStep_(1.0/perOctave),
    yieldStress_(yieldStress)
{
    if (shearRateDependent)
    {
        nTau_ = 2 + int(std::log2(tauMax/tauMin)*perOctave);
    }
    log2Fluidity_.resize(std::size_t(nT_)*nTau_);

    #pragma omp parallel for
    for (int i = 0; i < nT_; ++i)
    {
        const double T = TMin_ + i*TStep_;
        double* row = &log2Fluidity_[std::size_t(i)*nTau_];
        if (!shearRateDependent)
        {
            row[0] = -std::log2(eta(1, T));
            continue;
        }

        // int s gammadot(s) ds by powers between the nodes; below the first
        // node gammadot ~ s
        double tau = tauMin;
        double rate = shearRate(eta, T, tau);
        double sum = rate*tau*tau/3;
        row[0] = std::log2(3*sum/(tau*tau*tau));
        for (int j = 1; j < nTau_; ++j)
        {
            const double next = tauMin*std::exp2(j*log2TauStep_);
            const double nextRate = shearRate(eta, T, next);
            const double p = std::log(nextRate/rate)/std::log(next/tau);
            sum += (nextRate*next*next - rate*tau*tau)/(p + 2);
            tau = next;
            rate = nextRate;
            row[j] = std::log2(3*sum/(tau*tau*tau));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::melt::filmViscosity::fluidity
(
    const double T,
    const double tau
) const
{
    double yielding = 1;
    if (yieldStress_ > 0)
    {
        if (tau <= yieldStress_)
        {
            return 0;
        }
        const double B = yieldStress_/tau;
        yielding = 1 - 1.5*B + 0.5*B*B*B;
    }

    const double x = std::clamp((T - TMin_)/TStep_, 0.0, double(nT_ - 1));
    const int i = std::min(int(x), nT_ - 2);
    const double u = x - i;
    const double* row = &log2Fluidity_[std::size_t(i)*nTau_];
    const double* next = row + nTau_;

    double value;
    if (nTau_ == 1)
    {
        value = row[0] + u*(next[0] - row[0]);
    }
    else
    {
        const double y = std::clamp
        (
            (std::log2(std::max(tau, 1e-300)) - log2TauMin_)/log2TauStep_,
            0.0,
            double(nTau_ - 1)
        );
        const int j = std::min(int(y), nTau_ - 2);
        const double v = y - j;
        const double a = row[j] + v*(row[j + 1] - row[j]);
        const double b = next[j] + v*(next[j + 1] - next[j]);
        value = a + u*(b - a);
    }
    return yielding*std::exp2(value);
}

// ************************************************************************* //
