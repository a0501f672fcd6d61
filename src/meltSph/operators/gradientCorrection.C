/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gradientCorrection.H"
#include "pairPass.H"

#include <cmath>

namespace Foam
{
namespace melt
{
namespace
{

//- M = -sum_j V_j F x x^T, then its inverse
class momentLaw
{
    const sphSystem* s_;
    symmetricArrays* L_;
    double maxCondition_;
    bool boundsAsMelt_;

    double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;

    [[gnu::always_inline]] inline void addMoment(const pairGeometry& p)
    {
        xx_ -= p.VF*p.dx*p.dx;
        xy_ -= p.VF*p.dx*p.dy;
        xz_ -= p.VF*p.dx*p.dz;
        yy_ -= p.VF*p.dy*p.dy;
        yz_ -= p.VF*p.dy*p.dz;
        zz_ -= p.VF*p.dz*p.dz;
    }

    static double norm2
    (
        const double xx, const double xy, const double xz,
        const double yy, const double yz, const double zz
    )
    {
        return xx*xx + yy*yy + zz*zz + 2*(xy*xy + xz*xz + yz*yz);
    }

public:

    momentLaw
    (
        const sphSystem& s,
        const double maxCondition,
        const bool boundsAsMelt,
        symmetricArrays& L
    )
    :
        s_(&s),
        L_(&L),
        maxCondition_(maxCondition),
        boundsAsMelt_(boundsAsMelt)
    {}

    [[gnu::always_inline]] inline void start(const int)
    {}

    template<class Kernel>
    [[gnu::always_inline]] inline void add
    (
        const int,
        const pairGeometry& p,
        const Kernel&
    )
    {
        addMoment(p);
    }

    template<class Kernel>
    inline void addWall(const int j, const pairGeometry& p, const Kernel&)
    {
        if (boundsAsMelt_ || !s_->walls.slip[j])
        {
            addMoment(p);
        }
    }

    inline void finish(const int i)
    {
        if (s_->near.kernel().dimensions() == 2)
        {
            zz_ = 1;
        }

        // Cofactors
        const double cxx = yy_*zz_ - yz_*yz_;
        const double cxy = xz_*yz_ - xy_*zz_;
        const double cxz = xy_*yz_ - xz_*yy_;
        const double cyy = xx_*zz_ - xz_*xz_;
        const double cyz = xy_*xz_ - xx_*yz_;
        const double czz = xx_*yy_ - xy_*xy_;
        const double determinant = xx_*cxx + xy_*cxy + xz_*cxz;

        const double condition = std::sqrt
        (
            norm2(xx_, xy_, xz_, yy_, yz_, zz_)
           *norm2(cxx, cxy, cxz, cyy, cyz, czz)
        );
        symmetricArrays& L = *L_;
        if (!(condition < maxCondition_*determinant))
        {
            L[0][i] = L[3][i] = L[5][i] = 1;
            L[1][i] = L[2][i] = L[4][i] = 0;
            return;
        }

        L[0][i] = cxx/determinant;
        L[1][i] = cxy/determinant;
        L[2][i] = cxz/determinant;
        L[3][i] = cyy/determinant;
        L[4][i] = cyz/determinant;
        L[5][i] = czz/determinant;
    }
};

} // End anonymous namespace
} // End namespace melt
} // End namespace Foam


void Foam::melt::gradientCorrection
(
    const sphSystem& system,
    const double maxCondition,
    const bool boundsAsMelt,
    symmetricArrays& L
)
{
    for (std::vector<double>& component : L)
    {
        component.resize(system.fluid.size());
    }
    const momentLaw law(system, maxCondition, boundsAsMelt, L);
    if (boundsAsMelt)
    {
        system.near.countForcePass();
        pairPassOf
        (
            [&](const int i) { return !system.near.idle(i); },
            [](const int, const int) { return 1; },
            system.near, system.walls, system.fluid, law
        );
    }
    else
    {
        forcePass(system.near, system.walls, system.fluid, law);
    }
}

// ************************************************************************* //
