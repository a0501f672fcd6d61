/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceCorrection.H"
#include "latticeMoment.H"
#include "momentSum.H"

#include <algorithm>

namespace Foam
{
namespace melt
{
namespace
{

//- Mean moment over a lattice's at which a particle is inside the melt, and at
//  which it is at a surface
constexpr double inside = 0.85, atSurface = 0.8;


using vector3 = std::array<double, 3>;


class correctionLaw
:
    public momentLaw
{
    int dimensions_;
    double lattice_, maxCondition_;
    vector3 g_;
    symmetricArrays* A_;

    //- sum V grad W over melt and walls, and over walls alone [1/m]
    vector3 all_{}, wall_{};

    static double dot(const vector3& a, const vector3& b)
    {
        return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
    }

    static void addGradient(vector3& sum, const pairGeometry& p)
    {
        sum[0] += p.VF*p.dx;
        sum[1] += p.VF*p.dy;
        sum[2] += p.VF*p.dz;
    }

    //- The factor of surfaces at side walls
    double awayFromSides() const
    {
        const double all2 = dot(all_, all_), wall2 = dot(wall_, wall_);
        const double g2 = dot(g_, g_);
        if (!(all2*wall2*g2 > 0))
        {
            return 1;
        }
        const double across2 = 1 - sqr(dot(all_, wall_))/(all2*wall2);
        const double upright2 = 1 - sqr(dot(g_, wall_))/(g2*wall2);
        return 1 - across2*upright2;
    }

public:

    correctionLaw
    (
        const int dimensions,
        const double lattice,
        const double maxCondition,
        const vector3& g,
        symmetricArrays& A
    )
    :
        dimensions_(dimensions),
        lattice_(lattice),
        maxCondition_(maxCondition),
        g_(g),
        A_(&A)
    {}

    template<class Kernel>
    inline void add(const int, const pairGeometry& p, const Kernel&)
    {
        M_.add(p);
        addGradient(all_, p);
    }

    template<class Kernel>
    inline void addWall(const int, const pairGeometry& p, const Kernel&)
    {
        M_.add(p);
        addGradient(all_, p);
        addGradient(wall_, p);
    }

    inline void finish(const int i)
    {
        const double mean = M_.trace()/(dimensions_*lattice_);
        std::array<double, 6> inverse{};
        double share =
            std::clamp((inside - mean)/(inside - atSurface), 0.0, 1.0)
           *awayFromSides();
        if (share > 0 && !M_.invert(dimensions_, maxCondition_, inverse))
        {
            share = 0;
        }
        double w = share;
        if (w > 0)
        {
            // In a plane without the 1 across it
            const double norm2 = momentSum::norm2(inverse) - (3 - dimensions_);
            w *= std::min(1.0, std::sqrt(dimensions_/norm2)/lattice_);
        }
        for (int a = 0; a < 6; ++a)
        {
            const bool diagonal = a == 0 || a == 3 || a == 5;
            (*A_)[a][i] =
                w*inverse[a] + (diagonal ? (1 - share)/lattice_ : 0);
        }
    }
};

} // End anonymous namespace
} // End namespace melt
} // End namespace Foam


void Foam::melt::surfaceCorrection
(
    const sphSystem& system,
    const double maxCondition,
    symmetricArrays& A
)
{
    for (std::vector<double>& component : A)
    {
        component.resize(system.fluid.size());
    }
    const smoothingKernel& kernel = system.near.kernel();
    system.near.countForcePass();
    pairPassOf
    (
        [&](const int i) { return !system.near.idle(i); },
        [](const int, const int) { return 1; },
        system.near, system.walls, system.fluid,
        correctionLaw
        (
            kernel.dimensions(), latticeMoment(kernel, system.spacing),
            maxCondition, system.g, A
        )
    );
}

// ************************************************************************* //
