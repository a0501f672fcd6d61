/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pairRates.H"
#include "artificialViscosityLaw.H"
#include "blockSum.H"
#include "clockValue.H"
#include "conductionLaw.H"
#include "DynamicList.H"
#include "heatConduction.H"
#include "pressureLaw.H"
#include "stressLaw.H"
#include "xsphLaw.H"

namespace
{

using namespace Foam::melt;

//- Heat is conducted within solids too
template<class Law>
constexpr bool isHeat =
    std::is_same<std::decay_t<Law>, conductionLaw<true>>::value;

//- next(laws..., law) if the law is on, else next(laws...)
template<class Law, class Next, class... Laws>
void with(const bool on, const Law& law, const Next& next, const Laws&... laws)
{
    if (on)
    {
        next(laws..., law);
    }
    else
    {
        next(laws...);
    }
}

} // End anonymous namespace


double Foam::melt::pairRates::add
(
    const neighbourhood& near,
    const wallState& walls,
    particles& f
) const
{
    // Conductivities that differ are rare: a pass of their own
    const bool uniform = f.kappa.empty();
    std::vector<double> fromWalls(conduction && uniform ? f.size() : 0);

    const artificialViscosityLaw artificialLaw
    (
        f, near.kernel().h(), alphaC, beta
    );
    const xsphLaw smoothingLaw(f, epsilon);
    const conductionLaw<true> heatLaw
    (
        f, walls, kappa, spacing, fromWalls.data()
    );

    const auto pass = [&](const auto&... laws)
    {
        if constexpr ((isHeat<decltype(laws)> || ...))
        {
            pairPass(near, walls, f, laws...);
        }
        else if constexpr (sizeof...(laws) > 0)
        {
            forcePass(near, walls, f, laws...);
        }
    };
    const auto addHeat = [&](const auto&... laws)
    {
        with(conduction && uniform, heatLaw, pass, laws...);
    };
    const auto addSmoothing = [&](const auto&... laws)
    {
        with(xsph, smoothingLaw, addHeat, laws...);
    };
    const auto addArtificial = [&](const auto&... laws)
    {
        with(artificialViscosity, artificialLaw, addSmoothing, laws...);
    };
    const auto addStress = [&](const auto&... laws)
    {
        with(stress, stressLaw(f, walls), addArtificial, laws...);
    };
    with(pressure, pressureLaw(f, walls), addStress);

    if (conduction && !uniform)
    {
        return heatConduction(near, walls, kappa, spacing, f);
    }
    return blockSum
    (
        int(fromWalls.size()),
        [&](const int i) { return fromWalls[i]; }
    );
}


Foam::List<Foam::Tuple2<Foam::word, Foam::scalar>>
Foam::melt::pairRates::shares
(
    const neighbourhood& near,
    const wallState& walls,
    particles& f
) const
{
    // The least of three is disturbed least
    const auto seconds = [&](const pairRates& laws)
    {
        scalar least = GREAT;
        for (int i = 0; i < 3; ++i)
        {
            const auto start = clockValue::now();
            laws.add(near, walls, f);
            least = min(least, scalar(clockValue::now() - start));
        }
        return least;
    };
    const scalar all = max(seconds(*this), VSMALL);

    DynamicList<Tuple2<word, scalar>> shares;
    scalar left = 1;
    const auto law = [&](const word& effect, bool pairRates::* const on)
    {
        if (this->*on)
        {
            pairRates others(*this);
            others.*on = false;
            const scalar share = min(max(1 - seconds(others)/all, scalar(0)), left);
            left -= share;
            shares.append(Tuple2<word, scalar>(effect, share));
        }
    };
    law("artificialViscosity", &pairRates::artificialViscosity);
    law("XSPH", &pairRates::xsph);
    law("heatConduction", &pairRates::conduction);
    return List<Tuple2<word, scalar>>(std::move(shares));
}

// ************************************************************************* //
