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


//- Blocks of the diagonal but for walls
class blockLaw
:
    public noWalls
{
    const double *eta_, *V_;
    viscousOperator::blocks* blocks_;
    pairCoefficient c_;

    double etai_ = 0;
    double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;

public:

    blockLaw
    (
        const sphSystem& s,
        const double share,
        viscousOperator::blocks& blocks
    )
    :
        eta_(s.fluid.eta.data()),
        V_(s.fluid.V.data()),
        blocks_(&blocks),
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
        const double c = c_(etai_, eta_[j], p);
        xx_ += c*p.dx*p.dx;
        xy_ += c*p.dx*p.dy;
        xz_ += c*p.dx*p.dz;
        yy_ += c*p.dy*p.dy;
        yz_ += c*p.dy*p.dz;
        zz_ += c*p.dz*p.dz;
    }

    [[gnu::always_inline]] inline void finish(const int i)
    {
        const double V = V_[i];
        viscousOperator::blocks& b = *blocks_;
        b[0][i] += V*xx_;
        b[1][i] += V*xy_;
        b[2][i] += V*xz_;
        b[3][i] += V*yy_;
        b[4][i] += V*yz_;
        b[5][i] += V*zz_;
    }
};


//- sum_j c_ij (v_ji.x_ij) x_ij over the fluid alone
class forceLaw
:
    public noWalls
{
    const double *eta_, *u_, *v_, *w_, *V_;
    vectorArray* out_;
    pairCoefficient c_;

    double etai_ = 0, ui_ = 0, vi_ = 0, wi_ = 0;
    double x_ = 0, y_ = 0, z_ = 0;

public:

    forceLaw
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
        ui_ = u_[i];
        vi_ = v_[i];
        wi_ = w_[i];
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
           *(
                (u_[j] - ui_)*p.dx + (v_[j] - vi_)*p.dy + (w_[j] - wi_)*p.dz
            );
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
    const particles& f = system_.fluid;
    const wallState& walls = system_.walls;
    const pairCoefficient coefficient(system_.near.kernel(), share_);
    wallBlock_.reset(system_.near);
    wallPull_.reset(system_.near);

    const std::vector<int>& beside = system_.near.besideWalls();
    system_.near.visit([&](const auto& W, const auto& space)
    {
        #pragma omp parallel for schedule(dynamic, 64)
        for (int k = 0; k < int(beside.size()); ++k)
        {
            const int i = beside[k];
            symmTensor block(Zero);
            vector pull(Zero);
            const auto row = system_.near.walls().sourcesOf(i);
            const int count = system_.near.idle(i) ? 0 : row.size();
            for (int n = 0; n < count; ++n)
            {
                const int j = row[n];
                double dx = f.x[i] - walls.x[j];
                double dy = f.y[i] - walls.y[j];
                double dz = f.z[i] - walls.z[j];
                space.nearestImage(dx, dy, dz);
                const double r2 = dx*dx + dy*dy + dz*dz;
                const double V = walls.volume[j];
                const double c =
                    wallDrag::factor(system_, i, j)
                   *coefficient
                    (
                        f.eta[i],
                        f.eta[i],
                        {dx, dy, dz, r2, V, V*W.gradientOverR(r2)}
                    );
                const vector x(dx, dy, dz);
                const vector u(walls.wallU[j], walls.wallV[j], walls.wallW[j]);
                block += c*sqr(x);
                pull += c*(u & x)*x;
            }
            wallBlock_.ofWallIndex(k) = f.V[i]*block;
            wallPull_.ofWallIndex(k) = f.V[i]*pull;
        }
    });
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
        forceLaw(system_, share_, v, force)
    );

    for (const int i : system_.near.besideWalls())
    {
        const vector wall
        (
            sources*wallPull_[i]
          - (wallBlock_[i] & vector(v.x[i], v.y[i], v.z[i]))
        );
        force.x[i] += wall.x();
        force.y[i] += wall.y();
        force.z[i] += wall.z();
    }
}


void Foam::melt::centralViscosity::addDiagonal(blocks& diagonal) const
{
    forcePass
    (
        system_.near,
        system_.walls,
        system_.fluid,
        blockLaw(system_, share_, diagonal)
    );

    for (const int i : system_.near.besideWalls())
    {
        const symmTensor block(wallBlock_[i]);
        for (direction component = 0; component < 6; ++component)
        {
            diagonal[component][i] += block[component];
        }
    }
}


bool Foam::melt::centralViscosity::describe(implicitParts& p) const
{
    p.centralShare = share_;
    p.centralWall = &wallBlock_;
    return true;
}


std::size_t Foam::melt::centralViscosity::bytes() const
{
    return wallBlock_.bytes() + wallPull_.bytes();
}

// ************************************************************************* //
