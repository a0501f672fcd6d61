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
    symmetricArrays* A_;

    //- sum V grad W over melt and walls, and over walls alone [1/m]
    vector3 all_{}, wall_{};

    static void addGradient(vector3& sum, const pairGeometry& p)
    {
        sum[0] += p.VF*p.dx;
        sum[1] += p.VF*p.dy;
        sum[2] += p.VF*p.dz;
    }

    //- Square of the cosine between the normals of surface and wall; 1 where
    //  there is no wall
    double alongWall() const
    {
        double product = 0, all2 = 0, wall2 = 0;
        for (int a = 0; a < 3; ++a)
        {
            product += all_[a]*wall_[a];
            all2 += all_[a]*all_[a];
            wall2 += wall_[a]*wall_[a];
        }
        return all2*wall2 > 0 ? product*product/(all2*wall2) : 1;
    }

public:

    correctionLaw
    (
        const int dimensions,
        const double lattice,
        const double maxCondition,
        symmetricArrays& A
    )
    :
        dimensions_(dimensions),
        lattice_(lattice),
        maxCondition_(maxCondition),
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
           *alongWall();
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
            maxCondition, A
        )
    );
}

// ************************************************************************* //
