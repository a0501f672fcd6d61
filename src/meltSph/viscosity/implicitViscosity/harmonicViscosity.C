/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicViscosity.H"
#include "pairPass.H"

namespace Foam
{
namespace melt
{
namespace
{

class harmonicMeanLaw
:
    public noWalls
{
    const double *V_, *eta_;
    std::vector<double>* mean_;
    double central_;

    double weights_ = 0, fluidities_ = 0;

public:

    //- V is the volume of liquid, central W(0)
    harmonicMeanLaw
    (
        const std::vector<double>& V,
        const std::vector<double>& eta,
        const double central,
        std::vector<double>& mean
    )
    :
        V_(V.data()),
        eta_(eta.data()),
        mean_(&mean),
        central_(central)
    {}

    [[gnu::always_inline]] inline void start(const int i)
    {
        weights_ = V_[i]*central_;
        fluidities_ = weights_/eta_[i];
    }

    template<class Kernel>
    [[gnu::always_inline]] inline void add
    (
        const int j,
        const pairGeometry& p,
        const Kernel& W
    )
    {
        // Once: rows are filled up with the particle itself
        const double w = p.r2 > 0 ? V_[j]*W.value(p.r2) : 0;
        weights_ += w;
        fluidities_ += w/eta_[j];
    }

    [[gnu::always_inline]] inline void finish(const int i)
    {
        (*mean_)[i] = V_[i] > 0 ? weights_/fluidities_ : eta_[i];
    }
};

} // End anonymous namespace
} // End namespace melt
} // End namespace Foam


void Foam::melt::harmonicViscosity
(
    const sphSystem& system,
    std::vector<double>& eta
)
{
    const particles& f = system.fluid;
    eta.resize(f.size());

    std::vector<double> liquid(f.V.begin(), f.V.end());
    for (std::size_t i = 0; i < system.solid.size(); ++i)
    {
        if (system.solid[i])
        {
            liquid[i] = 0;
        }
    }

    double central = 0;
    system.near.kernel().visit([&](const auto& W) { central = W.value(0); });
    pairPass
    (
        system.near, system.walls, f,
        harmonicMeanLaw(liquid, f.eta, central, eta)
    );
}

// ************************************************************************* //
