/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "implicitViscosity.H"
#include "addToRunTimeSelectionTable.H"
#include "apparentViscosity.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(implicitViscosity, 0);
    addToRunTimeSelectionTable(rateTerm, implicitViscosity, dictionary);
}
}


Foam::melt::implicitViscosity::implicitViscosity
(
    const dictionary& dict,
    sphSystem& system
)
:
    rateTerm(system),
    operator_(viscousOperator::New(dict, system)),
    tolerance_
    (
        checkedEntry::get
        (
            dict, "tolerance", dimless, checkedEntry::positive()
        )
    ),
    maxIterations_
    (
        dict.getCheck<label>("maxIterations", labelMinMax::ge(1))
    )
{
    system_.deformation = true;
}


void Foam::melt::implicitViscosity::allocate()
{
    particles& f = system_.fluid;
    f.require
    (
        {
            &f.eta, &f.S[0], &f.S[1], &f.S[2], &f.S[3], &f.S[4], &f.S[5]
        }
    );
}


void Foam::melt::implicitViscosity::addRates()
{
    setViscosityAndStress(system_.rheology, system_.fluid);
}


void Foam::melt::implicitViscosity::invertBlocks(const scalar deltaT)
{
    operator_->diagonal(inverse_);

    const std::vector<double>& m = system_.fluid.m;
    viscousOperator::blocks& b = inverse_;
    const int n = system_.fluid.size();

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


bool Foam::melt::implicitViscosity::implicitUpdate
(
    const scalar deltaT,
    const vectorArray& guess
)
{
    particles& f = system_.fluid;
    const int n = f.size();

    v_ = guess;
    start_.x = f.u;
    start_.y = f.v;
    start_.z = f.w;
    r_.resize(n);
    force_.resize(n);

    operator_->update();
    invertBlocks(deltaT);

    // r = M (v* - v) + dt (b - K v)
    operator_->force(v_, 1, force_);
    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        r_.x[i] = f.m[i]*(start_.x[i] - v_.x[i]) + deltaT*force_.x[i];
        r_.y[i] = f.m[i]*(start_.y[i] - v_.y[i]) + deltaT*force_.y[i];
        r_.z[i] = f.m[i]*(start_.z[i] - v_.z[i]) + deltaT*force_.z[i];
    }

    const auto apply = [&](const vectorArray& p, vectorArray& Ap)
    {
        operator_->force(p, 0, Ap);
        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < n; ++i)
        {
            Ap.x[i] = f.m[i]*p.x[i] - deltaT*Ap.x[i];
            Ap.y[i] = f.m[i]*p.y[i] - deltaT*Ap.y[i];
            Ap.z[i] = f.m[i]*p.z[i] - deltaT*Ap.z[i];
        }
    };
    const auto precondition = [&](const vectorArray& r, vectorArray& z)
    {
        const viscousOperator::blocks& b = inverse_;
        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < n; ++i)
        {
            const double x = r.x[i], y = r.y[i], w = r.z[i];
            z.x[i] = b[0][i]*x + b[1][i]*y + b[2][i]*w;
            z.y[i] = b[1][i]*x + b[3][i]*y + b[4][i]*w;
            z.z[i] = b[2][i]*x + b[4][i]*y + b[5][i]*w;
        }
    };
    const auto viscousImpulse = [&](const vectorArray& v)
    {
        return std::sqrt
        (
            blockSum
            (
                n,
                [&](const int i)
                {
                    const double x = f.m[i]*(v.x[i] - start_.x[i]);
                    const double y = f.m[i]*(v.y[i] - start_.y[i]);
                    const double z = f.m[i]*(v.z[i] - start_.z[i]);
                    return x*x + y*y + z*z;
                }
            )
        ) + VSMALL;
    };

    const conjugateGradient::result result = solver_.solve
    (
        apply, precondition, viscousImpulse,
        tolerance_, maxIterations_, v_, r_
    );
    ++nSolves_;
    nIterations_ += result.iterations;
    lastResidual_ = result.residual;

    if (!result.converged)
    {
        return false;
    }
    f.u = v_.x;
    f.v = v_.y;
    f.w = v_.z;
    return true;
}


void Foam::melt::implicitViscosity::report(Ostream& os) const
{
    const std::size_t bytes =
        operator_->bytes() + solver_.bytes() + v_.bytes() + start_.bytes()
      + r_.bytes() + force_.bytes()
      + 6*sizeof(double)*inverse_[0].capacity();

    os  << "     viscous solver: " << nIterations_/max(nSolves_, 1)
        << " iterations a solve, last residual " << lastResidual_ << ", "
        << label(bytes/max(system_.fluid.size(), 1)) << " bytes a particle"
        << nl;
}

// ************************************************************************* //
