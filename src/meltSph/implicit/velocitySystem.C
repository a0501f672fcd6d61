/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocitySystem.H"
#include "remainingMomenta.H"
#include "sphSystem.H"

#include <algorithm>

namespace Foam
{
namespace melt
{
namespace
{

//- (x y z) = b r of a particle
[[gnu::always_inline]] inline void multiplyBlock
(
    const implicitOperator::blocks& b,
    const vectorArray& r,
    const int i,
    double& x,
    double& y,
    double& z
)
{
    x = b[0][i]*r.x[i] + b[1][i]*r.y[i] + b[2][i]*r.z[i];
    y = b[1][i]*r.x[i] + b[3][i]*r.y[i] + b[4][i]*r.z[i];
    z = b[2][i]*r.x[i] + b[4][i]*r.y[i] + b[5][i]*r.z[i];
}

} // End anonymous namespace
} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::velocitySystem::addForces
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


void Foam::melt::velocitySystem::invertBlocks()
{
    implicitOperator::blocks& b = inverse_;
    for (std::vector<float>& component : b)
    {
        component.assign(system_->fluid.size(), 0);
    }
    for (const implicitOperator* o : operators_)
    {
        o->addDiagonal(b);
    }

    const std::vector<double>& m = system_->fluid.m;
    const int n = system_->fluid.size();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const double xx = m[i] + deltaT_*b[0][i];
        const double xy = deltaT_*b[1][i];
        const double xz = deltaT_*b[2][i];
        const double yy = m[i] + deltaT_*b[3][i];
        const double yz = deltaT_*b[4][i];
        const double zz = m[i] + deltaT_*b[5][i];

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


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::melt::velocitySystem::update
(
    const sphSystem& system,
    const double deltaT,
    const double tolerance,
    const double coarseSpacing
)
{
    system_ = &system;
    deltaT_ = deltaT;
    for (implicitOperator* o : operators_)
    {
        o->update(deltaT);
    }
    invertBlocks();

    implicitParts parts;
    single_ = tolerance > 10*floatScalarSMALL;
    for (const implicitOperator* o : operators_)
    {
        single_ = o->describe(parts) && single_;
    }
    if (single_)
    {
        product_.build(system, parts);
    }
    useCoarse_ =
        coarseSpacing > 0 && system_->fluid.size() > 0
     && coarse_.build
        (
            system, parts, deltaT, coarseSpacing*system.spacing
        );
}


bool Foam::melt::velocitySystem::simplify()
{
    // A contrast of viscosities beyond single precision, or beyond the factors
    bool& given = single_ ? single_ : useCoarse_;
    const bool any = given;
    given = false;
    return any;
}


void Foam::melt::velocitySystem::makeRigid(vectorArray& v) const
{
    if (solids_)
    {
        v.multiply(system_->fluid.m);
        solids_->project(v);
        v.divide(system_->fluid.m);
    }
}


void Foam::melt::velocitySystem::setResidual
(
    const vectorArray& v,
    vectorArray& r
)
{
    const particles& f = system_->fluid;
    const int n = f.size();
    r.resize(n);

    addForces(v, 1, r);
    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        r.x[i] = f.m[i]*(f.u[i] - v.x[i]) + deltaT_*r.x[i];
        r.y[i] = f.m[i]*(f.v[i] - v.y[i]) + deltaT_*r.y[i];
        r.z[i] = f.m[i]*(f.w[i] - v.z[i]) + deltaT_*r.z[i];
    }
    if (solids_)
    {
        solids_->project(r);
    }
}


template<class Number>
void Foam::melt::velocitySystem::apply
(
    const vectorArrayOf<Number>& p,
    vectorArrayOf<Number>& Ap
)
{
    constexpr bool isDouble = std::is_same_v<Number, double>;
    const std::vector<double>& m = system_->fluid.m;
    const int n = p.size();

    const double k = single_ ? deltaT_ : -deltaT_;
    if (single_)
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
void Foam::melt::velocitySystem::precondition
(
    const vectorArray& r,
    vectorArrayOf<Number>& z
)
{
    const std::vector<double>& m = system_->fluid.m;
    const int n = r.size();

    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        double x, y, w;
        multiplyBlock(inverse_, r, i, x, y, w);
        z.x[i] = Number(x);
        z.y[i] = Number(y);
        z.z[i] = Number(w);
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


void Foam::melt::velocitySystem::addRemainder
(
    vectorArray& r,
    vectorArray& v
) const
{
    const particles& f = system_->fluid;
    const implicitOperator::blocks& b = inverse_;
    const int n = r.size();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        double x = r.x[i]/f.m[i], y = r.y[i]/f.m[i], z = r.z[i]/f.m[i];
        // Bodies stay rigid
        if (!solids_ || !solids_->solid(i))
        {
            multiplyBlock(b, r, i, x, y, z);
        }
        v.x[i] += x;
        v.y[i] += y;
        v.z[i] += z;
        r.x[i] -= f.m[i]*x;
        r.y[i] -= f.m[i]*y;
        r.z[i] -= f.m[i]*z;
    }
    // Walls take up what there is else
    if (!system_->near.besideWalls().empty())
    {
        return;
    }

    std::vector<float> share(n);
    for (int i = 0; i < n; ++i)
    {
        if (!solids_ || !solids_->solid(i))
        {
            const double free = f.m[i]*(b[0][i] + b[3][i] + b[5][i])/3;
            share[i] = float(std::clamp(1 - free, 0.0, 1.0));
        }
    }
    addRemainingMomenta(f, share, r, !system_->near.box().any(), v);
}


template void Foam::melt::velocitySystem::apply
(
    const vectorArrayOf<float>&, vectorArrayOf<float>&
);

template void Foam::melt::velocitySystem::apply
(
    const vectorArray&, vectorArray&
);

template void Foam::melt::velocitySystem::precondition
(
    const vectorArray&, vectorArrayOf<float>&
);

template void Foam::melt::velocitySystem::precondition
(
    const vectorArray&, vectorArray&
);


std::size_t Foam::melt::velocitySystem::bytes() const
{
    std::size_t n =
        product_.bytes() + coarse_.bytes()
      + 6*sizeof(float)*inverse_[0].capacity();
    for (const implicitOperator* o : operators_)
    {
        n += o->bytes();
    }
    return n;
}

// ************************************************************************* //
