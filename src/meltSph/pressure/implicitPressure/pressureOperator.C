/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pressureOperator.H"
#include "latticeMoment.H"
#include "pressureOperatorLaws.H"
#include "surfaceCorrection.H"
#include "wholeSupport.H"

#include <algorithm>

Foam::melt::pressureOperator::pressureOperator
(
    const sphSystem& system,
    const bool tension,
    const double maxCondition,
    const double background
)
:
    system_(system),
    tension_(tension),
    maxCondition_(maxCondition),
    background_(background)
{}


std::array<double, 3> Foam::melt::pressureOperator::weight(const int i) const
{
    const particles& f = system_.fluid;
    const std::array<double, 3>& g = system_.g;
    const double g2 = g[0]*g[0] + g[1]*g[1] + g[2]*g[2];
    if (f.axOld.empty() || g2 == 0)
    {
        return g;
    }
    const double falls =
        (f.axOld[i]*g[0] + f.ayOld[i]*g[1] + f.azOld[i]*g[2])/g2;
    const double held = std::clamp(1 - falls, 0.0, 1.0);
    return {held*g[0], held*g[1], held*g[2]};
}


void Foam::melt::pressureOperator::setWallGradient()
{
    const particles& f = system_.fluid;
    const wallState& walls = system_.walls;
    const int n = system_.near.walls().empty() ? 0 : f.size();

    wallGradient_.resize(n);
    wallDivergence_.resize(n);
    wallWeight_.resize(n);
    support_.resize(n);
    const double* const solid = system_.near.solid();

    // Twice, and corrected: A of particles on a lattice, as those of walls are
    const double onLattice =
        2/latticeMoment(system_.near.kernel(), system_.spacing);

    system_.near.visit([&](const auto& W, const auto& space)
    {
        #pragma omp parallel for schedule(dynamic, 256)
        for (int i = 0; i < n; ++i)
        {
            double bx = 0, by = 0, bz = 0, divergence = 0;
            double wx = 0, wy = 0, wz = 0, behind = 0;
            const auto row = system_.near.walls().sourcesOf(i);
            const std::array<double, 3> g(weight(i));

            // A wall does not pull; solids it meets by contact
            const bool none = p0_[i] < 0 || (solid && solid[i] > 0);
            const int count = none ? 0 : row.size();
            for (int k = 0; k < count; ++k)
            {
                const int j = row[k];
                double dx = f.x[i] - walls.x[j];
                double dy = f.y[i] - walls.y[j];
                double dz = f.z[i] - walls.z[j];
                space.nearestImage(dx, dy, dz);
                const double r2 = dx*dx + dy*dy + dz*dz;
                behind += walls.volume[j]*W.value(r2);
                const double c =
                    onLattice*walls.volume[j]*W.gradientOverR(r2);
                bx += c*dx;
                by += c*dy;
                bz += c*dz;
                divergence += c
                   *(
                        walls.wallU[j]*dx
                      + walls.wallV[j]*dy
                      + walls.wallW[j]*dz
                    );

                const double weight = 0.5*c*std::max
                (
                    -p0_[i], -f.rho[i]*(g[0]*dx + g[1]*dy + g[2]*dz)
                );
                wx -= weight*dx;
                wy -= weight*dy;
                wz -= weight*dz;
            }
            support_[i] = wholeSupport(behind);
            wallGradient_.x[i] = bx;
            wallGradient_.y[i] = by;
            wallGradient_.z[i] = bz;
            wallDivergence_[i] = divergence;
            wallWeight_.x[i] = f.V[i]*wx;
            wallWeight_.y[i] = f.V[i]*wy;
            wallWeight_.z[i] = f.V[i]*wz;
        }
    });
}


void Foam::melt::pressureOperator::update(const double deltaT)
{
    const particles& f = system_.fluid;
    const int n = f.size();
    const double rho0 = system_.thermo.rho();
    const double c2 = sqr(system_.soundSpeed);

    p0_.resize(n);
    p_.resize(n);
    stiffness_.resize(n);

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const double p = c2*(f.rho[i] - rho0) + background_;
        const bool on = tension_ || p >= 0;
        p0_[i] = on ? p : 0;
        stiffness_[i] = on ? deltaT*f.rho[i]*c2 : 0;
    }
    // The pressure on a solid is that of the liquid
    for (int i = 0; i < int(system_.solid.size()); ++i)
    {
        if (system_.solid[i])
        {
            p0_[i] = 0;
            stiffness_[i] = 0;
        }
    }
    surfaceCorrection(system_, maxCondition_, A_);
    setWallGradient();

    // That of the density at the step's end, in terms of the mean velocity
    const double theta = system_.implicitness;
    if (theta < 1)
    {
        const double before = (1 - theta)/sqr(theta)*deltaT*c2;
        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < n; ++i)
        {
            p0_[i] -= stiffness_[i] > 0 ? before*f.dRho[i] : 0;
            stiffness_[i] /= sqr(theta);
        }
    }
    for (std::size_t i = 0; i < support_.size(); ++i)
    {
        stiffness_[i] *= support_[i];
    }
}


void Foam::melt::pressureOperator::addForce
(
    const vectorArray& v,
    const double sources,
    vectorArray& force
)
{
    const bool walls = wallGradient_.size();
    const auto setPressure = [&](const int i, double divergence)
    {
        if (walls)
        {
            divergence += sources*wallDivergence_[i]
              - v.x[i]*wallGradient_.x[i]
              - v.y[i]*wallGradient_.y[i]
              - v.z[i]*wallGradient_.z[i];
        }
        p_[i] = sources*p0_[i] - stiffness_[i]*divergence;
    };

    forcePass
    (
        system_.near, system_.walls, system_.fluid,
        divergenceLaw(v.x.data(), v.y.data(), v.z.data(), A_, setPressure)
    );
    forcePass
    (
        system_.near, system_.walls, system_.fluid,
        pressureGradientLaw
        (
            p_.data(), system_.fluid.V.data(), A_, wallGradient_, force
        )
    );
    if (walls)
    {
        force.add(sources, wallWeight_);
    }
}


void Foam::melt::pressureOperator::addDiagonal(blocks& diagonal) const
{
    forcePass
    (
        system_.near, system_.walls, system_.fluid,
        pressureBlockLaw
        (
            stiffness_.data(), system_.fluid.V.data(), A_, wallGradient_,
            diagonal
        )
    );
}


bool Foam::melt::pressureOperator::describe(implicitParts& p) const
{
    p.stiffness = &stiffness_;
    p.pressureA = &A_;
    p.pressureWall = &wallGradient_;
    return true;
}


void Foam::melt::pressureOperator::divergence(std::vector<double>& div) const
{
    const particles& f = system_.fluid;
    const bool walls = wallGradient_.size();

    const auto set = [&](const int i, double divergence)
    {
        if (walls)
        {
            divergence += wallDivergence_[i]
              - f.u[i]*wallGradient_.x[i]
              - f.v[i]*wallGradient_.y[i]
              - f.w[i]*wallGradient_.z[i];
        }
        div[i] = walls ? support_[i]*divergence : divergence;
    };

    forcePass
    (
        system_.near, system_.walls, f,
        divergenceLaw(f.u.data(), f.v.data(), f.w.data(), A_, set)
    );
}


std::size_t Foam::melt::pressureOperator::bytes() const
{
    return
        wallGradient_.bytes() + wallWeight_.bytes()
      + sizeof(double)
       *(
            p0_.capacity() + p_.capacity() + stiffness_.capacity()
          + wallDivergence_.capacity() + support_.capacity()
          + 6*A_[0].capacity()
        );
}

// ************************************************************************* //
