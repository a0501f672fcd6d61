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


void Foam::melt::velocitySolver::addForces
(
    const vectorArray& v,
    const double sources,
    vectorArray& force
)
{
    force.zero();
    for (implicitOperator* o : operators_)
    {
        o->addForce(v, sources, force);
    }
}


void Foam::melt::velocitySolver::invertBlocks
(
    const particles& f,
    const scalar deltaT
)
{
    implicitOperator::blocks& b = inverse_;
    for (std::vector<double>& component : b)
    {
        component.assign(f.size(), 0);
    }
    for (const implicitOperator* o : operators_)
    {
        o->addDiagonal(b);
    }

    const std::vector<double>& m = f.m;
    const int n = f.size();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const double xx = m[i] + deltaT*b[0][i];
        const double xy = deltaT*b[1][i];
        const double xz = deltaT*b[2][i];
        const double yy = m[i] + deltaT*b[3][i];
        const double yz = deltaT*b[4][i];
        const double zz = m[i] + deltaT*b[5][i];

        const double cxx = yy*zz - yz*yz;
        const double cxy = xz*yz - xy*zz;
        const double cxz = xy*yz - xz*yy;
        const double scale = 1/(xx*cxx + xy*cxy + xz*cxz);

        b[0][i] = scale*cxx;
        b[1][i] = scale*cxy;
        b[2][i] = scale*cxz;
        b[3][i] = scale*(xx*zz - xz*xz);
        b[4][i] = scale*(xy*xz - xx*yz);
        b[5][i] = scale*(xx*yy - xy*xy);
    }
}


bool Foam::melt::velocitySolver::solve
(
    sphSystem& system,
    const scalar deltaT,
    const vectorArray& guess
)
{
    particles& f = system.fluid;
    const int n = f.size();

    r_.resize(n);

    // The rigid motions of the same momenta
    const auto makeRigid = [&](vectorArray& v)
    {
        if (solids_)
        {
            v.multiply(f.m);
            solids_->project(v);
            v.divide(f.m);
        }
    };
    // Bodies begin with a rigid motion, which projected residuals leave them
    const auto setGuess = [&]()
    {
        v_ = guess;
        makeRigid(v_);
    };
    setGuess();

    for (implicitOperator* o : operators_)
    {
        o->update(deltaT);
    }
    invertBlocks(f, deltaT);

    // r = M (v* - v) + dt (b - K v)
    const auto setResidual = [&]()
    {
        addForces(v_, 1, r_);
        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < n; ++i)
        {
            r_.x[i] = f.m[i]*(f.u[i] - v_.x[i]) + deltaT*r_.x[i];
            r_.y[i] = f.m[i]*(f.v[i] - v_.y[i]) + deltaT*r_.y[i];
            r_.z[i] = f.m[i]*(f.w[i] - v_.z[i]) + deltaT*r_.z[i];
        }
        if (solids_)
        {
            solids_->project(r_);
        }
    };

    implicitParts parts;
    // The product is one of single precision, which does not reach a tolerance
    // near its own round-off
    bool described = tolerance_ > 10*floatScalarSMALL;
    for (const implicitOperator* o : operators_)
    {
        described = o->describe(parts) && described;
    }
    if (described)
    {
        product_.build(system, parts);
    }
    bool coarse =
        coarseSpacing_ > 0 && n > 0
     && coarse_.build
        (
            system, parts, deltaT, coarseSpacing_*system.spacing
        );

    const auto apply = [&](const vectorArray& p, vectorArray& Ap)
    {
        if (described)
        {
            product_.apply(p, Ap);
        }
        else
        {
            addForces(p, 0, Ap);
        }
        const double k = described ? deltaT : -deltaT;
        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < n; ++i)
        {
            Ap.x[i] = f.m[i]*p.x[i] + k*Ap.x[i];
            Ap.y[i] = f.m[i]*p.y[i] + k*Ap.y[i];
            Ap.z[i] = f.m[i]*p.z[i] + k*Ap.z[i];
        }
        if (solids_)
        {
            solids_->project(Ap);
        }
    };
    const auto precondition = [&](const vectorArray& r, vectorArray& z)
    {
        const implicitOperator::blocks& b = inverse_;
        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < n; ++i)
        {
            const double x = r.x[i], y = r.y[i], w = r.z[i];
            z.x[i] = b[0][i]*x + b[1][i]*y + b[2][i]*w;
            z.y[i] = b[1][i]*x + b[3][i]*y + b[4][i]*w;
            z.z[i] = b[2][i]*x + b[4][i]*y + b[5][i]*w;
        }
        // Of bodies their mass alone: r is that of a rigid motion already
        for (int i = 0; solids_ && i < n; ++i)
        {
            if (solids_->solid(i))
            {
                z.x[i] = r.x[i]/f.m[i];
                z.y[i] = r.y[i]/f.m[i];
                z.z[i] = r.z[i]/f.m[i];
            }
        }
        if (coarse)
        {
            coarse_.addCorrection(r, z);
            makeRigid(z);
        }
    };
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

    // Round-off of the velocities, in the norm of the kinetic energy
    const double negligible =
        sqr(1e3*SMALL)
       *blockSum
        (
            n,
            [&](const int i)
            {
                return f.m[i]*(sqr(f.u[i]) + sqr(f.v[i]) + sqr(f.w[i]));
            }
        );

    // The product of the iterations is one of single precision: where the true
    // residual is not down yet, they go on from it
    bool converged = false;
    label nIterations = 0;
    while (!converged && nIterations < maxIterations_)
    {
        setResidual();
        conjugateGradient<vectorArray>::result result = solver_.solve
        (
            apply, precondition, impulse,
            tolerance_, negligible, maxIterations_ - nIterations, v_, r_
        );
        nIterations += result.iterations;
        result.converged = result.converged && result.positive;
        lastResidual_ = result.residual;
        converged =
            result.converged && (!described || result.iterations == 0);
        if (!result.converged && described)
        {
            // A contrast of viscosities beyond single precision
            described = false;
            setGuess();
        }
        else if (!result.converged && coarse)
        {
            // Beyond the factors, too
            coarse = false;
            setGuess();
        }
        else if (!result.converged)
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
    // What remains is given to each particle: so the impulse is just
    // dt (b - K v), forces that keep both momenta whatever the tolerance
    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.u[i] = v_.x[i] + r_.x[i]/f.m[i];
        f.v[i] = v_.y[i] + r_.y[i]/f.m[i];
        f.w[i] = v_.z[i] + r_.z[i]/f.m[i];
    }
    return true;
}


void Foam::melt::velocitySolver::report(Ostream& os) const
{
    if (!nSolves_)
    {
        return;
    }

    std::size_t bytes =
        solver_.bytes() + product_.bytes() + coarse_.bytes()
      + v_.bytes() + r_.bytes()
      + 6*sizeof(double)*inverse_[0].capacity();
    for (const implicitOperator* o : operators_)
    {
        bytes += o->bytes();
    }

    os  << "     implicit solver: " << nIterations_/nSolves_
        << " iterations a solve, last residual " << lastResidual_ << ", "
        << label(bytes/max(v_.size(), 1)) << " bytes a particle" << nl;
}

// ************************************************************************* //
