/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gradientCorrection.H"
#include "momentSum.H"

namespace Foam
{
namespace melt
{
namespace
{

class correctionLaw
:
    public momentLaw
{
    const sphSystem* s_;
    double maxCondition_;
    symmetricArrays* L_;

public:

    correctionLaw
    (
        const sphSystem& s,
        const double maxCondition,
        symmetricArrays& L
    )
    :
        s_(&s),
        maxCondition_(maxCondition),
        L_(&L)
    {}

    template<class Kernel>
    inline void addWall(const int j, const pairGeometry& p, const Kernel&)
    {
        if (!s_->walls.slip[j])
        {
            M_.add(p);
        }
    }

    inline void finish(const int i)
    {
        std::array<double, 6> L{1, 0, 0, 1, 0, 1};
        M_.invert(s_->near.kernel().dimensions(), maxCondition_, L);
        for (int a = 0; a < 6; ++a)
        {
            (*L_)[a][i] = L[a];
        }
    }
};

} // End anonymous namespace
} // End namespace melt
} // End namespace Foam


void Foam::melt::gradientCorrection
(
    const sphSystem& system,
    const double maxCondition,
    symmetricArrays& L
)
{
    for (std::vector<double>& component : L)
    {
        component.resize(system.fluid.size());
    }
    forcePass
    (
        system.near, system.walls, system.fluid,
        correctionLaw(system, maxCondition, L)
    );
}

// ************************************************************************* //
