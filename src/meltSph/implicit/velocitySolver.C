/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocitySolver.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "sphSystem.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::velocitySolver::velocitySolver(const dictionary& dict)
:
    tolerance_
    (
        checkedEntry::getOrDefault
        (
            dict, "tolerance", dimless, checkedEntry::positive(), 1e-4
        )
    ),
    maxIterations_
    (
        dict.getCheckOrDefault<label>
        (
            "maxIterations", 1000, labelMinMax::ge(1)
        )
    ),
    coarseSpacing_
    (
        checkedEntry::getOrDefault
        (
            dict, "coarseSpacing", dimless, scalarMinMax::ge(0), 5
        )
    )
{}


template<class Directions>
Foam::melt::iterationResult Foam::melt::velocitySolver::iterate
(
    conjugateGradient<vectorArray, Directions>& solver,
    const particles& f,
    const label maxIterations
)
{
    const int n = f.size();

    const auto impulse = [&](const vectorArray& v)
    {
        return std::sqrt
        (
            blockSum
            (
                n,
                [&](const int i)
                {
                    const double x = f.m[i]*(v.x[i] - f.u[i]);
                    const double y = f.m[i]*(v.y[i] - f.v[i]);
                    const double z = f.m[i]*(v.z[i] - f.w[i]);
                    return x*x + y*y + z*z;
                }
            )
        ) + VSMALL;
    };

    // Round-off of the velocities, in the norm of the kinetic energy, or less
    // where so much is asked for
    const double negligible =
        sqr(std::min(1e3*SMALL, std::max(SMALL, 0.01*tolerance_)))
       *blockSum
        (
            n,
            [&](const int i)
            {
                return f.m[i]*(sqr(f.u[i]) + sqr(f.v[i]) + sqr(f.w[i]));
            }
        );

    return solver.solve
    (
        [&](const Directions& p, Directions& Ap) { equations_.apply(p, Ap); },
        [&](const vectorArray& r, Directions& z)
        {
            equations_.precondition(r, z);
        },
        impulse, tolerance_, negligible, maxIterations, v_, r_
    );
}


bool Foam::melt::velocitySolver::solve
(
    sphSystem& system,
    const scalar deltaT
)
{
    particles& f = system.fluid;
    const int n = f.size();

    // Bodies begin with a rigid motion, which projected residuals leave them
    equations_.update(system, deltaT, tolerance_, coarseSpacing_);
    equations_.makeRigid(v_);

    // Where the product is one of single precision and the true residual is not
    // down yet, iterations go on from it
    bool converged = false;
    label nIterations = 0;
    while (!converged && nIterations < maxIterations_)
    {
        equations_.setResidual(v_, r_);
        const label left = maxIterations_ - nIterations;
        const iterationResult result =
            equations_.singleDirections()
          ? iterate(single_, f, left)
          : iterate(double_, f, left);
        nIterations += result.iterations;
        lastResidual_ = result.residual;

        if (result.converged && result.positive)
        {
            converged =
                !equations_.singleProduct() || result.iterations == 0;
        }
        else if (equations_.simplify())
        {
            v_.assign(f.u, f.v, f.w);
            equations_.makeRigid(v_);
        }
        else
        {
            break;
        }
    }
    ++nSolves_;
    nIterations_ += nIterations;

    if (!converged)
    {
        return false;
    }
    equations_.addRemainder(r_, v_);
    f.u = v_.x;
    f.v = v_.y;
    f.w = v_.z;
    return true;
}


void Foam::melt::velocitySolver::report(Ostream& os) const
{
    if (!nSolves_)
    {
        return;
    }

    const std::size_t bytes =
        double_.bytes() + single_.bytes() + v_.bytes() + r_.bytes()
      + equations_.bytes();

    os  << "     implicit solver: " << nIterations_/nSolves_
        << " iterations a solve, last residual " << lastResidual_ << ", "
        << label(bytes/max(v_.size(), 1)) << " bytes a particle" << nl;
}

// ************************************************************************* //
