/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pressureOperator.H"
#include "latticeMoment.H"
#include "normalSpan.H"
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


double Foam::melt::pressureOperator::held(const int i) const
{
    const particles& f = system_.fluid;
    const vector g(system_.g[0], system_.g[1], system_.g[2]);
    const double g2 = magSqr(g);
    if (f.axOld.empty() || g2 == 0)
    {
        return 1;
    }
    const double falls = (vector(f.axOld[i], f.ayOld[i], f.azOld[i]) & g)/g2;
    return std::clamp(1 - falls, 0.0, 1.0);
}


void Foam::melt::pressureOperator::setWallGradient()
{
    const particles& f = system_.fluid;
    const wallState& walls = system_.walls;
    const double* const solid = system_.near.solid();
    wallGradient_.reset(system_.near);
    wallDivergence_.reset(system_.near);
    gapGradient_.reset(system_.near);
    gapDivergence_.reset(system_.near);
    wallWeight_.reset(system_.near);
    support_.reset(system_.near);

    // Twice, and corrected: A of particles on a lattice, as those of walls are
    const double onLattice =
        2/latticeMoment(system_.near.kernel(), system_.spacing);

    const std::vector<int>& beside = system_.near.besideWalls();
    system_.near.visit([&](const auto& W, const auto& space)
    {
        #pragma omp parallel for schedule(dynamic, 64)
        for (int k = 0; k < int(beside.size()); ++k)
        {
            const int i = beside[k];
            // Solids it meets by contact
            if (solid && solid[i] > 0)
            {
                continue;
            }

            vector b(Zero), weight(Zero), motion(Zero);
            double divergence = 0, behind = 0;
            normalSpan normals;
            const auto row = system_.near.walls().sourcesOf(i);
            const double share = held(i);
            const vector g
            (
                share*system_.g[0], share*system_.g[1], share*system_.g[2]
            );
            for (int n = 0; n < row.size(); ++n)
            {
                const int j = row[n];
                double dx = f.x[i] - walls.x[j];
                double dy = f.y[i] - walls.y[j];
                double dz = f.z[i] - walls.z[j];
                space.nearestImage(dx, dy, dz);
                const vector x(dx, dy, dz);
                const double r2 = magSqr(x);
                const double beyond = walls.volume[j]*W.value(r2);
                const vector U(walls.wallU[j], walls.wallV[j], walls.wallW[j]);
                behind += beyond;
                motion += beyond*U;
                normals.add(walls.nx[j], walls.ny[j], walls.nz[j]);
                const vector gradient
                (
                    onLattice*walls.volume[j]*W.gradientOverR(r2)*x
                );
                b += gradient;
                divergence += U & gradient;
                weight -=
                    0.5*std::max(-p0_[i], -f.rho[i]*(g & x))*gradient;
            }
            const vector across(normals.project(b));
            // Walls that move with the melt do not strain it
            const double moved =
                divergence + (motion & (across - b))/max(behind, VSMALL);
            // A wall does not pull
            if (p0_[i] < 0)
            {
                gapGradient_.ofWallIndex(k) = across;
                gapDivergence_.ofWallIndex(k) = moved;
                continue;
            }
            support_.ofWallIndex(k) = wholeSupport(behind) - 1;
            wallGradient_.ofWallIndex(k) = across;
            wallDivergence_.ofWallIndex(k) = moved;
            wallWeight_.ofWallIndex(k) = f.V[i]*weight;
        }
    });
}


void Foam::melt::pressureOperator::setSolidWeight()
{
    const double* const solid = system_.near.solid();
    const particles& f = system_.fluid;
    const int n = solid ? f.size() : 0;
    positive_.resize(n);
    carried_.resize(n);
    solidWeight_.resize(n);
    if (n == 0)
    {
        return;
    }

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        positive_[i] = std::max(p0_[i], 0.0);
        carried_[i] = solid[i] > 0 ? 0 : held(i)*f.rho[i];
    }
    solidWeight_.zero();
    forcePass
    (
        system_.near, system_.walls, f,
        solidWeightLaw
        (
            solid, positive_, carried_, f.V, system_.g,
            latticeMoment(system_.near.kernel(), system_.spacing), solidWeight_
        )
    );
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
    setSolidWeight();

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
    for (const int i : system_.near.besideWalls())
    {
        if (theta < 1 && stiffness_[i] > 0)
        {
            // Of what the mean velocity does not compress
            p0_[i] -= (1 - theta)*stiffness_[i]*closing_[i];
        }
        stiffness_[i] *= 1 + support_[i];
    }
}


void Foam::melt::pressureOperator::addForce
(
    const vectorArray& v,
    const double sources,
    vectorArray& force
)
{
    const auto setPressure = [&](const int i, const double divergence)
    {
        p_[i] =
            sources*p0_[i]
          - stiffness_[i]*withWalls
            (
                i, divergence, vector(v.x[i], v.y[i], v.z[i]), sources
            );
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
    for (const int i : system_.near.besideWalls())
    {
        const vector weight(sources*wallWeight_[i]);
        force.x[i] += weight.x();
        force.y[i] += weight.y();
        force.z[i] += weight.z();
    }
    if (solidWeight_.size())
    {
        force.add(sources, solidWeight_);
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


void Foam::melt::pressureOperator::divergence(std::vector<double>& div)
{
    const particles& f = system_.fluid;
    const auto velocity = [&](const int i)
    {
        return vector(f.u[i], f.v[i], f.w[i]);
    };

    const std::vector<int>& beside = system_.near.besideWalls();
    closing_.reset(system_.near);
    for (int k = 0; k < int(beside.size()); ++k)
    {
        const int i = beside[k];
        closing_.ofWallIndex(k) =
            std::min(gapDivergence_[i] - (velocity(i) & gapGradient_[i]), 0.0);
    }

    const auto set = [&](const int i, const double divergence)
    {
        div[i] =
            (1 + support_[i])*withWalls(i, divergence, velocity(i), 1)
          + closing_[i];
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
        wallGradient_.bytes() + wallDivergence_.bytes() + wallWeight_.bytes()
      + gapGradient_.bytes() + gapDivergence_.bytes() + closing_.bytes()
      + support_.bytes() + solidWeight_.bytes()
      + sizeof(double)
       *(
            p0_.capacity() + p_.capacity() + stiffness_.capacity()
          + positive_.capacity() + carried_.capacity()
          + 6*A_[0].capacity()
        );
}

// ************************************************************************* //
