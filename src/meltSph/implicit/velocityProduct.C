/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocityProduct.H"
#include "pairViscosity.H"
#include "sphSystem.H"
#include "symmTensor.H"
#include "tensor.H"

#include <cmath>
#include <cstring>
#include <numeric>

namespace
{

using quad = Foam::melt::velocityProduct::quad;

//- Of a compiler's vector type
using float4 = float __attribute__((vector_size(16)));

inline float4 load(const quad& q)
{
    float4 v;
    std::memcpy(&v, &q, sizeof(v));
    return v;
}

inline void store(quad& q, const float4 v)
{
    std::memcpy(&q, &v, sizeof(v));
}

inline float4 all(const float a)
{
    return float4{a, a, a, a};
}

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::velocityProduct::reserve()
{
    const int n = system_->fluid.size();
    start_.assign(n + 1, 0);
    count_.assign(n, 0);
    // Filled up to whole vectors, as the rows are
    const auto size = [&](const int i)
    {
        const int count =
            system_->near.idle(i) ? 0 : system_->near.fluid().nPairs(i);
        return (count + neighbourList::lanes - 1)/neighbourList::lanes
           *neighbourList::lanes;
    };
    for (int i = 0; i < n; ++i)
    {
        start_[i + 1] = start_[i] + size(i);
    }
    if (pairs_.size() < start_[n])
    {
        pairs_.resize(start_[n]);
        neighbours_.resize(start_[n]);
    }
}


void Foam::melt::velocityProduct::setPairs()
{
    const particles& f = system_->fluid;
    const double* const x = f.x.data();
    const double* const y = f.y.data();
    const double* const z = f.z.data();
    const double* const V = f.V.data();
    const smoothingKernel& kernel = system_->near.kernel();
    const double h = kernel.h();
    const double factor = -2*parts_.centralShare*(kernel.dimensions() + 2);
    const double* const eta = factor != 0 ? f.eta.data() : V;
    const double* const solid = system_->near.solid();

    reserve();
    system_->near.visit([&](const auto& W, const auto& images)
    {
        // At the end of the support k = 1/(V V F r^2) would overflow where its
        // product with g g vanishes
        const double least = 1e-12*W.gradientOverR(h*h);
        const auto active = [&](const int i)
        {
            return !system_->near.idle(i);
        };

        system_->near.fluid().forEach(active, [&](const int i, const auto& row)
        {
            const auto space = images;
            const double xi = x[i], yi = y[i], zi = z[i];
            const double Vi = V[i], etai = eta[i];
            quad* const pairs = &pairs_[start_[i]];
            std::int32_t* const neighbours = &neighbours_[start_[i]];
            float4 sum = all(0);

            #pragma omp simd
            for (int k = 0; k < row.size(); ++k)
            {
                const int j = row[k];
                double dx = xi - x[j], dy = yi - y[j], dz = zi - z[j];
                space.nearestImage(dx, dy, dz);
                const double r2 = dx*dx + dy*dy + dz*dz;
                const double F = W.gradientOverR(r2);
                const double c =
                    Vi*V[j]*F*(solid ? 1 + std::abs(solid[i] - solid[j]) : 1);
                const double mean = pairViscosity(etai, eta[j]);
                pairs[k].a[0] = float(c*dx);
                pairs[k].a[1] = float(c*dy);
                pairs[k].a[2] = float(c*dz);
                pairs[k].a[3] =
                    float(F < least ? factor*mean/(c*(r2 + 0.01*h*h)) : 0);
            }

            // Without those in the skin and the particle itself; a solid feels
            // liquid alone
            const double* const dropped =
                solid && solid[i] > 0 ? solid : nullptr;
            int count = 0;
            for (int k = 0; k < row.size(); ++k)
            {
                const float4 g = load(pairs[k]);
                store(pairs[count], g);
                neighbours[count] = row[k];
                count +=
                    ((g[0] != 0) | (g[1] != 0) | (g[2] != 0))
                  & !(dropped && dropped[row[k]] > 0);
                sum += g;
            }
            count_[i] = count;
            store(sumG_[i], sum);
        });
    });
}


namespace
{

Foam::symmTensor at(const Foam::melt::implicitParts::blocks& b, const int i)
{
    return {b[0][i], b[1][i], b[2][i], b[3][i], b[4][i], b[5][i]};
}


//- Zero where there are no walls
Foam::vector at(const Foam::melt::vectorArray* a, const int i)
{
    return a && a->size()
      ? Foam::vector(a->x[i], a->y[i], a->z[i])
      : Foam::vector(Foam::Zero);
}


quad narrow(const Foam::vector& v)
{
    return {{float(v.x()), float(v.y()), float(v.z()), 0}};
}

} // End anonymous namespace


template<bool central>
void Foam::melt::velocityProduct::setStress(const vectorArray& v)
{
    const particles& f = system_->fluid;
    const int n = f.size();
    const int dimensions = system_->near.kernel().dimensions();

    #pragma omp parallel for schedule(dynamic, 256)
    for (int i = 0; i < n; ++i)
    {
        const quad* const pairs = &pairs_[start_[i]];
        const std::int32_t* const neighbours = &neighbours_[start_[i]];
        const int count = count_[i];
        const float4 vi = load(v_[i]);

        // Columns of the gradient
        float4 gx = all(0), gy = all(0), gz = all(0), force = all(0);
        for (int k = 0; k < count; ++k)
        {
            const float4 g = load(pairs[k]);
            const float4 d = load(v_[neighbours[k]]) - vi;
            gx += d*all(g[0]);
            gy += d*all(g[1]);
            gz += d*all(g[2]);
            if constexpr (central)
            {
                const float4 t = d*g;
                force += all((t[0] + t[1] + t[2])*g[3])*g;
            }
        }

        const double V = f.V[i];
        const vector u(v.x[i], v.y[i], v.z[i]);
        vector own(force[0], force[1], force[2]);
        const tensor G
        (
            gx[0]/V, gy[0]/V, gz[0]/V,
            gx[1]/V, gy[1]/V, gz[1]/V,
            gx[2]/V, gy[2]/V, gz[2]/V
        );

        // Q: stress of the melt's neighbours; what walls take is own
        tensor Q(Zero);
        if (parts_.L)
        {
            const symmTensor L(at(*parts_.L, i));
            const vector b(at(parts_.viscousWall, i));
            const tensor gradient((G - u*b) & L);
            symmTensor S
            (
                twoSymm(gradient) - 2.0/dimensions*tr(gradient)*symmTensor::I
            );
            if (dimensions == 2)
            {
                S.zz() = 0;
            }
            Q = (*parts_.eta)[i]*(S & L);
            own += V*(Q & b);
        }
        if (parts_.stiffness)
        {
            const symmTensor A(at(*parts_.pressureA, i));
            const vector b(at(parts_.pressureWall, i));
            const double P = (*parts_.stiffness)[i]*((G && A) - (u & b));
            Q = Q + P*A;
            own += V*P*b;
        }
        if (!wallBlocks_[0].empty())
        {
            own -= at(wallBlocks_, i) & u;
        }

        // Columns
        Q_[i] =
        {
            narrow({Q.xx(), Q.yx(), Q.zx()}),
            narrow({Q.xy(), Q.yy(), Q.zy()}),
            narrow({Q.xz(), Q.yz(), Q.zz()})
        };
        own_[i] = narrow(own);
    }
}


void Foam::melt::velocityProduct::sumForces(vectorArray& Kv) const
{
    const int n = system_->fluid.size();

    #pragma omp parallel for schedule(dynamic, 256)
    for (int i = 0; i < n; ++i)
    {
        const quad* const pairs = &pairs_[start_[i]];
        const std::int32_t* const neighbours = &neighbours_[start_[i]];
        const int count = count_[i];

        // Q_j alone in the loop, Q_i times the sum of g after it
        float4 sum = load(own_[i]), other = all(0);
        for (int k = 0; k < count; ++k)
        {
            const float4 g = load(pairs[k]);
            const std::array<quad, 3>& Q = Q_[neighbours[k]];
            sum += load(Q[0])*all(g[0]);
            other += load(Q[1])*all(g[1]);
            sum += load(Q[2])*all(g[2]);
        }
        const float4 g = load(sumG_[i]);
        const std::array<quad, 3>& Q = Q_[i];
        sum +=
            other + load(Q[0])*all(g[0]) + load(Q[1])*all(g[1])
          + load(Q[2])*all(g[2]);

        Kv.x[i] = -double(sum[0]);
        Kv.y[i] = -double(sum[1]);
        Kv.z[i] = -double(sum[2]);
    }
}

// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::melt::velocityProduct::build
(
    const sphSystem& system,
    const parts& p
)
{
    system_ = &system;
    parts_ = p;

    const int n = system.fluid.size();
    v_.resize(n);
    sumG_.resize(n);
    Q_.resize(n);
    own_.resize(n);
    setPairs();
    nPairs_ = std::accumulate(count_.begin(), count_.end(), std::uint64_t(0));

    // What walls add to the diagonal of the central force: the rest of it
    const bool walls =
        !system.near.walls().empty() && parts_.centralShare > 0;
    for (std::vector<double>& component : wallBlocks_)
    {
        component.assign(walls ? n : 0, 0);
    }

    #pragma omp parallel for schedule(dynamic, 256)
    for (int i = 0; i < (walls ? n : 0); ++i)
    {
        if (system.near.walls().sourcesOf(i).size() == 0)
        {
            continue;
        }
        double b[6] = {};
        for (std::size_t k = start_[i]; k < start_[i] + count_[i]; ++k)
        {
            const float* const g = pairs_[k].a;
            const double c = g[3];
            b[0] += c*g[0]*g[0];
            b[1] += c*g[0]*g[1];
            b[2] += c*g[0]*g[2];
            b[3] += c*g[1]*g[1];
            b[4] += c*g[1]*g[2];
            b[5] += c*g[2]*g[2];
        }
        for (int a = 0; a < 6; ++a)
        {
            wallBlocks_[a][i] =
                parts_.centralShare*(*parts_.centralDiagonal)[a][i] - b[a];
        }
    }
}


void Foam::melt::velocityProduct::apply(const vectorArray& v, vectorArray& Kv)
{
    const int n = v.size();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        v_[i] = quad{{float(v.x[i]), float(v.y[i]), float(v.z[i]), 0}};
    }

    system_->near.countPairs(2*nPairs_);
    parts_.centralShare > 0 ? setStress<true>(v) : setStress<false>(v);
    sumForces(Kv);
}


std::size_t Foam::melt::velocityProduct::bytes() const
{
    return
        sizeof(quad)
       *(
            pairs_.capacity() + sumG_.capacity() + v_.capacity()
          + own_.capacity() + 3*Q_.capacity()
        )
      + sizeof(std::int32_t)
       *(neighbours_.capacity() + count_.capacity())
      + sizeof(std::size_t)*start_.capacity()
      + 6*sizeof(double)*wallBlocks_[0].capacity();
}

// ************************************************************************* //
