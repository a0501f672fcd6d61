/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "SouzaMendesDutra.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(SouzaMendesDutra, 0);
    addToRunTimeSelectionTable(rheologyModel, SouzaMendesDutra, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Elements whose coefficients are held on the stack at once
constexpr Foam::label blockSize = 256;


//- Greatest dimensionless viscosity at any shear rate, by golden section in
//  ln(D): it rises from J + 1 to one maximum and falls thereafter
double etaStarMax(const Foam::melt::SouzaMendesDutraCoeffs& coeffs, double J)
{
    const double n = coeffs.n;
    const double ratio = 0.5*(std::sqrt(5.0) - 1);
    const auto eta = [&](double lnD) { return coeffs.etaStar(std::exp(lnD), J); };

    // Where (1 - (J+1)D/2)(1 + D^n), the law at small D, has its maximum; if
    // that is so close to zero that D^n is lost in round-off, so is the rise
    const double lnSmallest = -700;
    const double lnD =
        n < 1 ? std::max(lnSmallest, std::log(2*n/(J + 1))/(1 - n))
      : J < 1 ? 0 : lnSmallest;

    double low = std::min(lnD, 0.0) - 5/n;
    double high = std::max(lnD + 5, 5.0);

    // Each iteration takes off 38 %: enough to reach round-off
    for (int iteration = 0; iteration < 100; ++iteration)
    {
        const double a = high - ratio*(high - low);
        const double b = low + ratio*(high - low);
        const bool rising = eta(a) < eta(b);

        (rising ? low : high) = rising ? a : b;
    }

    return std::max(J + 1, eta(0.5*(low + high)));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::SouzaMendesDutra::SouzaMendesDutra(const dictionary& dict)
:
    jumpNumber_
    (
        temperatureLaw::New("jumpNumber", dict, checkedEntry::notNegative())
    )
{
    using namespace checkedEntry;

    tau0_ = get(dict, "tau0", dimPressure, positive());
    coeffs_.n = get(dict, "n", dimless, positiveUpTo(1));
    coeffs_.etaInf =
        getOrDefault(dict, "etaInf", dimPressure*dimTime, notNegative(), 0);

    if (dict.found("K") == dict.found("gamma1"))
    {
        FatalIOErrorInFunction(dict)
            << "Exactly one of the entries K and gamma1 is expected, found "
            << (dict.found("K") ? "both." : "neither.")
            << exit(FatalIOError);
    }

    if (dict.found("K"))
    {
        // No dimension set has a power of time that is not an integer
        const scalar K = dict.get<scalar>("K");
        check(dict, "K", K, positive());
        gamma1_ = pow(tau0_/K, 1/coeffs_.n);
    }
    else
    {
        gamma1_ = get(dict, "gamma1", dimless/dimTime, positive());
    }

    if (dict.found("tau0Factor"))
    {
        tau0Factor_ = temperatureLaw::New("tau0Factor", dict, positive());
    }
    if (dict.found("KFactor"))
    {
        KFactor_ = temperatureLaw::New("KFactor", dict, positive());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::SouzaMendesDutra::etaOfBlock
(
    const label n,
    const scalar* shearRate,
    const scalar* T,
    scalar* eta
) const
{
    const SouzaMendesDutraCoeffs coeffs(coeffs_);
    scalar J[blockSize];
    jumpNumber_->value(n, T, J);

    if (!tau0Factor_.valid() && !KFactor_.valid())
    {
        const scalar tau0 = tau0_;
        const scalar gamma1 = gamma1_;

        #pragma omp simd
        for (label i = 0; i < n; ++i)
        {
            eta[i] = coeffs.eta(shearRate[i], J[i], tau0, gamma1);
        }

        return;
    }

    scalar tau0Factor[blockSize];
    scalar KFactor[blockSize];
    std::fill_n(tau0Factor, n, scalar(1));
    std::fill_n(KFactor, n, scalar(1));

    if (tau0Factor_.valid())
    {
        tau0Factor_->value(n, T, tau0Factor);
    }
    if (KFactor_.valid())
    {
        KFactor_->value(n, T, KFactor);
    }

    for (label i = 0; i < n; ++i)
    {
        eta[i] = coeffs.eta
        (
            shearRate[i],
            J[i],
            tau0_*tau0Factor[i],
            gamma1_*std::pow(tau0Factor[i]/KFactor[i], 1/coeffs.n)
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::SouzaMendesDutra::eta
(
    const label n,
    const scalar* shearRate,
    const scalar* T,
    scalar* eta
) const
{
    const heldExceptions held;

    for (label start = 0; start < n; start += blockSize)
    {
        etaOfBlock
        (
            min(blockSize, n - start),
            shearRate + start,
            T + start,
            eta + start
        );
    }
}


Foam::scalar Foam::melt::SouzaMendesDutra::etaMax
(
    const scalar TMin,
    const scalar TMax
) const
{
    // At given J the scale tau0/gamma1 is tau0^(1-1/n) K^(1/n)
    scalar scale = tau0_/gamma1_;

    if (tau0Factor_.valid())
    {
        scale *= pow(tau0Factor_->range(TMin, TMax).min(), 1 - 1/coeffs_.n);
    }
    if (KFactor_.valid())
    {
        scale *= pow(KFactor_->range(TMin, TMax).max(), 1/coeffs_.n);
    }

    const scalar J = jumpNumber_->range(TMin, TMax).max();

    return max(coeffs_.etaInf, scale*etaStarMax(coeffs_, J));
}


Foam::tmp<Foam::scalarField> Foam::melt::SouzaMendesDutra::jumpNumber
(
    const scalarField& T
) const
{
    tmp<scalarField> tJ(new scalarField(T.size()));
    jumpNumber_->value(T.size(), T.cdata(), tJ.ref().data());

    return tJ;
}


// ************************************************************************* //
