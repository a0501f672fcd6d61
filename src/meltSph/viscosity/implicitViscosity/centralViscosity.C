/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "centralViscosity.H"
#include "addToRunTimeSelectionTable.H"
#include "pairPass.H"
#include "pairViscosity.H"
#include "wallDrag.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(centralViscosity, 0);
    addToRunTimeSelectionTable(viscousOperator, centralViscosity, dictionary);

namespace
{

//- Magnitude of the pair force per approach velocity, V_i V_j left out of i's
//  side: c = -2(d + 2) eta_ij F/(r^2 + 0.01 h^2), >= 0
struct pairCoefficient
{
    double factor;
    double regularisation;

    pairCoefficient(const smoothingKernel& kernel, const double share)
    :
        factor(-2*share*(kernel.dimensions() + 2)),
        regularisation(0.01*kernel.h()*kernel.h())
    {}

    [[gnu::always_inline]] inline double operator()
    (
        const double etai,
        const double etaj,
        const pairGeometry& p
    ) const
    {
        return
            factor*p.VF*pairViscosity(etai, etaj)/(p.r2 + regularisation);
    }
};


//- sum_j c_ij x x^T
struct blockOfPairs
{
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    [[gnu::always_inline]] inline void add
    (
        const double c,
        const pairGeometry& p
    )
    {
        xx += c*p.dx*p.dx;
        xy += c*p.dx*p.dy;
        xz += c*p.dx*p.dz;
        yy += c*p.dy*p.dy;
        yz += c*p.dy*p.dz;
        zz += c*p.dz*p.dz;
    }

    void addTo(viscousOperator::blocks& b, const int i, const double V) const
    {
        b[0][i] += V*xx;
        b[1][i] += V*xy;
        b[2][i] += V*xz;
        b[3][i] += V*yy;
        b[4][i] += V*yz;
        b[5][i] += V*zz;
    }
};


//- Blocks of the diagonal, and what walls have in them
class blockLaw
{
    const sphSystem* s_;
    const double* eta_;
    viscousOperator::blocks* blocks_;
    viscousOperator::blocks* wallBlocks_;
    vectorArray* wallPull_;
    pairCoefficient c_;

    int i_ = 0;
    double etai_ = 0;
    blockOfPairs melt_, walls_;
    double px_ = 0, py_ = 0, pz_ = 0;

public:

    blockLaw
    (
        const sphSystem& s,
        const double share,
        viscousOperator::blocks& blocks,
        viscousOperator::blocks& wallBlocks,
        vectorArray& wallPull
    )
    :
        s_(&s),
        eta_(s.fluid.eta.data()),
        blocks_(&blocks),
        wallBlocks_(&wallBlocks),
        wallPull_(&wallPull),
        c_(s.near.kernel(), share)
    {}

    [[gnu::always_inline]] inline void start(const int i)
    {
        i_ = i;
        etai_ = eta_[i];
    }

    template<class Kernel>
    [[gnu::always_inline]] inline void add
    (
        const int j,
        const pairGeometry& p,
        const Kernel&
    )
    {
        melt_.add(c_(etai_, eta_[j], p), p);
    }

    template<class Kernel>
    inline void addWall(const int j, const pairGeometry& p, const Kernel&)
    {
        const wallState& w = s_->walls;
        const double c = wallDrag::factor(*s_, i_, j)*c_(etai_, etai_, p);
        const double pull =
            c
           *(
                w.wallU[j]*p.dx + w.wallV[j]*p.dy + w.wallW[j]*p.dz
            );
        walls_.add(c, p);
        px_ += pull*p.dx;
        py_ += pull*p.dy;
        pz_ += pull*p.dz;
    }

    [[gnu::always_inline]] inline void finish(const int i)
    {
        const double V = s_->fluid.V[i];
        melt_.addTo(*blocks_, i, V);
        if (!(*wallBlocks_)[0].empty())
        {
            walls_.addTo(*blocks_, i, V);
            walls_.addTo(*wallBlocks_, i, V);
        }
        wallPull_->x[i] = V*px_;
        wallPull_->y[i] = V*py_;
        wallPull_->z[i] = V*pz_;
    }
};


//- sum_j c_ij (v_j.x_ij) x_ij over the fluid alone
class neighbourLaw
:
    public noWalls
{
    const double *eta_, *u_, *v_, *w_, *V_;
    vectorArray* out_;
    pairCoefficient c_;

    double etai_ = 0;
    double x_ = 0, y_ = 0, z_ = 0;

public:

    neighbourLaw
    (
        const sphSystem& s,
        const double share,
        const vectorArray& v,
        vectorArray& out
    )
    :
        eta_(s.fluid.eta.data()),
        u_(v.x.data()),
        v_(v.y.data()),
        w_(v.z.data()),
        V_(s.fluid.V.data()),
        out_(&out),
        c_(s.near.kernel(), share)
    {}

    [[gnu::always_inline]] inline void start(const int i)
    {
        etai_ = eta_[i];
    }

    template<class Kernel>
    [[gnu::always_inline]] inline void add
    (
        const int j,
        const pairGeometry& p,
        const Kernel&
    )
    {
        const double c =
            c_(etai_, eta_[j], p)
           *(u_[j]*p.dx + v_[j]*p.dy + w_[j]*p.dz);
        x_ += c*p.dx;
        y_ += c*p.dy;
        z_ += c*p.dz;
    }

    [[gnu::always_inline]] inline void finish(const int i)
    {
        out_->x[i] += V_[i]*x_;
        out_->y[i] += V_[i]*y_;
        out_->z[i] += V_[i]*z_;
    }
};

} // End anonymous namespace
} // End namespace melt
} // End namespace Foam


Foam::melt::centralViscosity::centralViscosity
(
    const dictionary&,
    const sphSystem& system
)
:
    centralViscosity(system, 1)
{}


Foam::melt::centralViscosity::centralViscosity
(
    const sphSystem& system,
    const double share
)
:
    viscousOperator(system),
    share_(share)
{}


void Foam::melt::centralViscosity::update(const double)
{
    const int n = system_.fluid.size();
    for (std::vector<double>& component : diagonal_)
    {
        component.assign(n, 0);
    }
    for (std::vector<double>& component : wallDiagonal_)
    {
        component.assign(system_.near.walls().empty() ? 0 : n, 0);
    }
    wallPull_.resize(n);

    forcePass
    (
        system_.near,
        system_.walls,
        system_.fluid,
        blockLaw(system_, 1, diagonal_, wallDiagonal_, wallPull_)
    );
}


void Foam::melt::centralViscosity::addForce
(
    const vectorArray& v,
    const double sources,
    vectorArray& force
)
{
    forcePass
    (
        system_.near,
        system_.walls,
        system_.fluid,
        neighbourLaw(system_, share_, v, force)
    );

    const blocks& b = diagonal_;
    const int n = v.size();

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const double x = share_*v.x[i];
        const double y = share_*v.y[i];
        const double z = share_*v.z[i];
        const double pull = share_*sources;
        force.x[i] +=
            pull*wallPull_.x[i] - b[0][i]*x - b[1][i]*y - b[2][i]*z;
        force.y[i] +=
            pull*wallPull_.y[i] - b[1][i]*x - b[3][i]*y - b[4][i]*z;
        force.z[i] +=
            pull*wallPull_.z[i] - b[2][i]*x - b[4][i]*y - b[5][i]*z;
    }
}


void Foam::melt::centralViscosity::addDiagonal(blocks& diagonal) const
{
    for (int component = 0; component < 6; ++component)
    {
        const std::vector<double>& from = diagonal_[component];
        std::vector<double>& to = diagonal[component];
        for (std::size_t i = 0; i < from.size(); ++i)
        {
            to[i] += share_*from[i];
        }
    }
}


bool Foam::melt::centralViscosity::describe(implicitParts& p) const
{
    p.centralShare = share_;
    p.centralWall = wallDiagonal_[0].empty() ? nullptr : &wallDiagonal_;
    return true;
}


std::size_t Foam::melt::centralViscosity::bytes() const
{
    return
        wallPull_.bytes()
      + 6*sizeof(double)
       *(diagonal_[0].capacity() + wallDiagonal_[0].capacity());
}

// ************************************************************************* //
