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
    for (std::vector<float>& component : b)
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

        b[0][i] = float(scale*cxx);
        b[1][i] = float(scale*cxy);
        b[2][i] = float(scale*cxz);
        b[3][i] = float(scale*(xx*zz - xz*xz));
        b[4][i] = float(scale*(xy*xz - xx*yz));
        b[5][i] = float(scale*(xx*yy - xy*xy));
    }
}


void Foam::melt::velocitySolver::makeRigid(vectorArray& v) const
{
    if (solids_)
    {
        v.multiply(fluid_->m);
        solids_->project(v);
        v.divide(fluid_->m);
    }
}


void Foam::melt::velocitySolver::setResidual()
{
    const particles& f = *fluid_;
    const int n = f.size();

    addForces(v_, 1, r_);
    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        r_.x[i] = f.m[i]*(f.u[i] - v_.x[i]) + deltaT_*r_.x[i];
        r_.y[i] = f.m[i]*(f.v[i] - v_.y[i]) + deltaT_*r_.y[i];
        r_.z[i] = f.m[i]*(f.w[i] - v_.z[i]) + deltaT_*r_.z[i];
    }
    if (solids_)
    {
        solids_->project(r_);
    }
}


template<class Number>
void Foam::melt::velocitySolver::apply
(
    const vectorArrayOf<Number>& p,
    vectorArrayOf<Number>& Ap
)
{
    constexpr bool isDouble = std::is_same_v<Number, double>;
    const std::vector<double>& m = fluid_->m;
    const int n = p.size();

    const double k = described_ ? deltaT_ : -deltaT_;
    if (described_)
    {
        product_.apply(p, Ap);
    }
    else if constexpr (isDouble)
    {
        addForces(p, 0, Ap);
    }

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        Ap.x[i] = Number(m[i]*p.x[i] + k*Ap.x[i]);
        Ap.y[i] = Number(m[i]*p.y[i] + k*Ap.y[i]);
        Ap.z[i] = Number(m[i]*p.z[i] + k*Ap.z[i]);
    }
    if constexpr (isDouble)
    {
        if (solids_)
        {
            solids_->project(Ap);
        }
    }
}


template<class Number>
void Foam::melt::velocitySolver::precondition
(
    const vectorArray& r,
    vectorArrayOf<Number>& z
)
{
    const std::vector<double>& m = fluid_->m;
    const implicitOperator::blocks& b = inverse_;
    const int n = r.size();

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const double x = r.x[i], y = r.y[i], w = r.z[i];
        z.x[i] = Number(b[0][i]*x + b[1][i]*y + b[2][i]*w);
        z.y[i] = Number(b[1][i]*x + b[3][i]*y + b[4][i]*w);
        z.z[i] = Number(b[2][i]*x + b[4][i]*y + b[5][i]*w);
    }
    // Of bodies their mass alone: r is that of a rigid motion already
    for (int i = 0; solids_ && i < n; ++i)
    {
        if (solids_->solid(i))
        {
            z.x[i] = Number(r.x[i]/m[i]);
            z.y[i] = Number(r.y[i]/m[i]);
            z.z[i] = Number(r.z[i]/m[i]);
        }
    }
    if (useCoarse_)
    {
        coarse_.addCorrection(r, z);
        if constexpr (std::is_same_v<Number, double>)
        {
            makeRigid(z);
        }
    }
}


template<class Directions>
Foam::melt::iterationResult Foam::melt::velocitySolver::iterate
(
    conjugateGradient<vectorArray, Directions>& solver,
    const label maxIterations
)
{
    const particles& f = *fluid_;
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

    return solver.solve
    (
        [&](const Directions& p, Directions& Ap) { apply(p, Ap); },
        [&](const vectorArray& r, Directions& z) { precondition(r, z); },
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

    fluid_ = &f;
    deltaT_ = deltaT;
    r_.resize(n);
    // Bodies begin with a rigid motion, which projected residuals leave them
    makeRigid(v_);

    for (implicitOperator* o : operators_)
    {
        o->update(deltaT);
    }
    invertBlocks(f, deltaT);

    implicitParts parts;
    // The product is one of single precision, which does not reach a tolerance
    // near its own round-off
    described_ = tolerance_ > 10*floatScalarSMALL;
    for (const implicitOperator* o : operators_)
    {
        described_ = o->describe(parts) && described_;
    }
    if (described_)
    {
        product_.build(system, parts);
    }
    useCoarse_ =
        coarseSpacing_ > 0 && n > 0
     && coarse_.build
        (
            system, parts, deltaT, coarseSpacing_*system.spacing
        );

    // The product of the iterations is one of single precision: where the true
    // residual is not down yet, they go on from it
    bool converged = false;
    label nIterations = 0;
    const auto beginAgain = [&]()
    {
        v_.assign(f.u, f.v, f.w);
        makeRigid(v_);
    };
    while (!converged && nIterations < maxIterations_)
    {
        setResidual();
        const label left = maxIterations_ - nIterations;
        iterationResult result =
            described_ && !solids_
          ? iterate(single_, left)
          : iterate(double_, left);
        nIterations += result.iterations;
        result.converged = result.converged && result.positive;
        lastResidual_ = result.residual;
        converged =
            result.converged && (!described_ || result.iterations == 0);
        if (!result.converged && described_)
        {
            // A contrast of viscosities beyond single precision
            described_ = false;
            beginAgain();
        }
        else if (!result.converged && useCoarse_)
        {
            // Beyond the factors, too
            useCoarse_ = false;
            beginAgain();
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
        double_.bytes() + single_.bytes() + product_.bytes() + coarse_.bytes()
      + v_.bytes() + r_.bytes()
      + 6*sizeof(float)*inverse_[0].capacity();
    for (const implicitOperator* o : operators_)
    {
        bytes += o->bytes();
    }

    os  << "     implicit solver: " << nIterations_/nSolves_
        << " iterations a solve, last residual " << lastResidual_ << ", "
        << label(bytes/max(v_.size(), 1)) << " bytes a particle" << nl;
}

// ************************************************************************* //
