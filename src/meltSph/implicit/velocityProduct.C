/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocityProduct.H"
#include "pairViscosity.H"
#include "sphSystem.H"

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


template<bool adjoint, bool central>
void Foam::melt::velocityProduct::setStress(const vectorArray& v)
{
    const particles& f = system_->fluid;
    const int n = f.size();
    const int dimensions = system_->near.kernel().dimensions();
    const vectorArray* const viscousWall = parts_.viscousWall;
    const vectorArray* const pressureWall = parts_.pressureWall;
    const bool wallStress = viscousWall && viscousWall->size();
    const bool wallPressure = pressureWall && pressureWall->size();

    #pragma omp parallel for schedule(dynamic, 256)
    for (int i = 0; i < n; ++i)
    {
        const quad* const pairs = &pairs_[start_[i]];
        const std::int32_t* const neighbours = &neighbours_[start_[i]];
        const int count = count_[i];
        const float4 vi = load(v_[i]);

        // Columns of the gradient; of the divergence alone, products
        float4 gx = all(0), gy = all(0), gz = all(0), force = all(0);
        float divergence = 0;
        for (int k = 0; k < count; ++k)
        {
            const float4 g = load(pairs[k]);
            const float4 d = load(v_[neighbours[k]]) - vi;
            if constexpr (adjoint)
            {
                gx += d*all(g[0]);
                gy += d*all(g[1]);
                gz += d*all(g[2]);
            }
            if constexpr (central || !adjoint)
            {
                const float4 t = d*g;
                const float s = t[0] + t[1] + t[2];
                divergence += s;
                if constexpr (central)
                {
                    force += all(s*g[3])*g;
                }
            }
        }
        if constexpr (central)
        {
            store(central_[i], force);
        }

        const double u = v.x[i], w = v.y[i], t = v.z[i];
        const double V = f.V[i];
        double divV =
            adjoint ? double(gx[0]) + gy[1] + gz[2] : double(divergence);
        divV /= V;
        if (wallPressure)
        {
            divV -=
                u*pressureWall->x[i] + w*pressureWall->y[i]
              + t*pressureWall->z[i];
        }
        const double P = parts_.stiffness ? (*parts_.stiffness)[i]*divV : 0;
        P_[i] = float(P);

        if constexpr (adjoint)
        {
            double g[3][3] =
            {
                {gx[0]/V, gy[0]/V, gz[0]/V},
                {gx[1]/V, gy[1]/V, gz[1]/V},
                {gx[2]/V, gy[2]/V, gz[2]/V}
            };
            if (wallStress)
            {
                const double b[3] =
                    {viscousWall->x[i], viscousWall->y[i], viscousWall->z[i]};
                for (int a = 0; a < 3; ++a)
                {
                    g[0][a] -= u*b[a];
                    g[1][a] -= w*b[a];
                    g[2][a] -= t*b[a];
                }
            }

            const auto& Ls = *parts_.L;
            const double L[3][3] =
            {
                {Ls[0][i], Ls[1][i], Ls[2][i]},
                {Ls[1][i], Ls[3][i], Ls[4][i]},
                {Ls[2][i], Ls[4][i], Ls[5][i]}
            };
            double gL[3][3];
            for (int a = 0; a < 3; ++a)
            {
                for (int b = 0; b < 3; ++b)
                {
                    gL[a][b] =
                        g[a][0]*L[0][b] + g[a][1]*L[1][b] + g[a][2]*L[2][b];
                }
            }

            const double eta = (*parts_.eta)[i];
            const double mean =
                2*eta*(gL[0][0] + gL[1][1] + gL[2][2])/dimensions;
            double S[3][3];
            for (int a = 0; a < 3; ++a)
            {
                for (int b = 0; b < 3; ++b)
                {
                    S[a][b] = eta*(gL[a][b] + gL[b][a]) - (a == b ? mean : 0);
                }
            }
            if (dimensions == 2)
            {
                S[2][2] = 0;
            }

            for (int b = 0; b < 3; ++b)
            {
                float4 column = all(0);
                for (int a = 0; a < 3; ++a)
                {
                    column[a] = float
                    (
                        S[a][0]*L[0][b] + S[a][1]*L[1][b] + S[a][2]*L[2][b]
                    );
                }
                store(Q_[i][b], column);
            }
        }
    }
}


template<bool adjoint>
void Foam::melt::velocityProduct::sumForces
(
    const vectorArray& v,
    vectorArray& Kv
)
{
    const particles& f = system_->fluid;
    const int n = f.size();
    const vectorArray* const viscousWall = parts_.viscousWall;
    const vectorArray* const pressureWall = parts_.pressureWall;
    const bool wallStress = viscousWall && viscousWall->size();
    const bool wallPressure = pressureWall && pressureWall->size();
    const bool central = parts_.centralShare > 0;

    #pragma omp parallel for schedule(dynamic, 256)
    for (int i = 0; i < n; ++i)
    {
        const quad* const pairs = &pairs_[start_[i]];
        const std::int32_t* const neighbours = &neighbours_[start_[i]];
        const int count = count_[i];

        float4 sum = all(P_[i])*load(sumG_[i]);
        if constexpr (adjoint)
        {
            // Q_j alone in the loop, Q_i times the sum of g after it
            float4 other = all(0);
            for (int k = 0; k < count; ++k)
            {
                const float4 g = load(pairs[k]);
                const int j = neighbours[k];
                const std::array<quad, 3>& Q = Q_[j];
                sum += load(Q[0])*all(g[0]);
                other += load(Q[1])*all(g[1]);
                sum += load(Q[2])*all(g[2]);
                other += all(P_[j])*g;
            }
            const float4 g = load(sumG_[i]);
            const std::array<quad, 3>& Q = Q_[i];
            sum +=
                other + load(Q[0])*all(g[0]) + load(Q[1])*all(g[1])
              + load(Q[2])*all(g[2]);
        }
        else
        {
            for (int k = 0; k < count; ++k)
            {
                sum += all(P_[neighbours[k]])*load(pairs[k]);
            }
        }

        double x = sum[0], y = sum[1], z = sum[2];
        const double V = f.V[i];
        if (central)
        {
            const float4 c = load(central_[i]);
            const double u = v.x[i], w = v.y[i], t = v.z[i];
            const implicitOperator::blocks& b = wallBlocks_;
            x += c[0] - b[0][i]*u - b[1][i]*w - b[2][i]*t;
            y += c[1] - b[1][i]*u - b[3][i]*w - b[4][i]*t;
            z += c[2] - b[2][i]*u - b[4][i]*w - b[5][i]*t;
        }
        if (adjoint && wallStress)
        {
            const std::array<quad, 3>& Q = Q_[i];
            const double bx = V*viscousWall->x[i];
            const double by = V*viscousWall->y[i];
            const double bz = V*viscousWall->z[i];
            x += Q[0].a[0]*bx + Q[1].a[0]*by + Q[2].a[0]*bz;
            y += Q[0].a[1]*bx + Q[1].a[1]*by + Q[2].a[1]*bz;
            z += Q[0].a[2]*bx + Q[1].a[2]*by + Q[2].a[2]*bz;
        }
        if (wallPressure)
        {
            const double P = V*P_[i];
            x += P*pressureWall->x[i];
            y += P*pressureWall->y[i];
            z += P*pressureWall->z[i];
        }
        Kv.x[i] = -x;
        Kv.y[i] = -y;
        Kv.z[i] = -z;
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
    P_.resize(n);
    sumG_.resize(n);
    Q_.resize(parts_.L ? n : 0);
    central_.resize(parts_.centralShare > 0 ? n : 0);
    setPairs();
    nPairs_ = std::accumulate(count_.begin(), count_.end(), std::uint64_t(0));

    // What walls add to the diagonal of the central force: the rest of it
    for (std::vector<double>& component : wallBlocks_)
    {
        component.assign(central_.size(), 0);
    }
    const bool walls = !system.near.walls().empty() && central_.size();

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
    const bool central = parts_.centralShare > 0;
    if (parts_.L)
    {
        central ? setStress<true, true>(v) : setStress<true, false>(v);
        sumForces<true>(v, Kv);
    }
    else
    {
        central ? setStress<false, true>(v) : setStress<false, false>(v);
        sumForces<false>(v, Kv);
    }
}


std::size_t Foam::melt::velocityProduct::bytes() const
{
    return
        sizeof(quad)
       *(
            pairs_.capacity() + sumG_.capacity() + v_.capacity()
          + central_.capacity() + 3*Q_.capacity()
        )
      + sizeof(std::int32_t)
       *(neighbours_.capacity() + count_.capacity() + P_.capacity())
      + sizeof(std::size_t)*start_.capacity()
      + 6*sizeof(double)*wallBlocks_[0].capacity();
}

// ************************************************************************* //
