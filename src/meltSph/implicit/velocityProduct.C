/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocityProduct.H"
#include "neighbourVectors.H"
#include "sphSystem.H"
#include "symmTensor.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::melt::float4;
using Foam::melt::float8;

//- pairViscosity over b of eight pairs, by one division
[[gnu::always_inline]] inline float8 pairViscosityOver
(
    const float etai,
    const float8& etaj,
    const float8& b
)
{
    const float8 sum = etai + etaj;
    const float8 product = etai*etaj;
    return (product > 0 ? 2*product : sum)/(product > 0 ? sum*b : b);
}

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<bool central>
void Foam::melt::velocityProduct::setStress()
{
    const neighbourhood& near = system_->near;
    const auto active = [&](const int i) { return !near.idle(i); };

    near.kernel().inUnitsOfH().visit([&](const auto& kernel)
    {
        near.fluid().forEach(active, [&](const int i, const auto& row)
        {
            const auto W = kernel;
            const quad vi = v_[i].v;
            float8 xx{}, xy{}, xz{}, yx{}, yy{}, yz{}, zx{}, zy{}, zz{};
            float8 fx{}, fy{}, fz{};

            for (int k = 0; k < row.size(); k += 8)
            {
                const std::int32_t* const j = row.sources + k;
                const pairVectors p
                (
                    W, v_, unit_, near.solid(), i, j
                );
                const std::array<float8, 4> vj(gather(v_, v_[0].v, j));
                const float8 u = vj[0] - vi.a[0];
                const float8 v = vj[1] - vi.a[1];
                const float8 w = vj[2] - vi.a[2];
                const float8 gx = p.c*p.x, gy = p.c*p.y, gz = p.c*p.z;
                xx += u*gx;
                xy += u*gy;
                xz += u*gz;
                yx += v*gx;
                yy += v*gy;
                yz += v*gz;
                zx += w*gx;
                zy += w*gy;
                zz += w*gz;
                if constexpr (central)
                {
                    const float8 t =
                        (u*p.x + v*p.y + w*p.z)
                       *pairViscosityOver(vi.a[3], vj[3], p.q2 + 0.01f);
                    fx += t*gx;
                    fy += t*gy;
                    fz += t*gz;
                }
            }

            setStress
            (
                i,
                tensor
                (
                    sum(xx), sum(xy), sum(xz),
                    sum(yx), sum(yy), sum(yz),
                    sum(zx), sum(zy), sum(zz)
                ),
                vector(sum(fx), sum(fy), sum(fz))
            );
        });
    });
}


void Foam::melt::velocityProduct::setStress
(
    const int i,
    const tensor& gradient,
    const vector& central
)
{
    const vector v(v_[i].v.a[0], v_[i].v.a[1], v_[i].v.a[2]);
    const smoothingKernel& kernel = system_->near.kernel();
    const int dimensions = kernel.dimensions();
    const double V = system_->fluid.V[i];
    const tensor G(gradient/kernel.h());

    // What walls take is own
    vector own
    (
        -2*parts_.centralShare*(dimensions + 2)*V/sqr(kernel.h())*central
    );
    tensor Q(Zero);
    if (parts_.L)
    {
        const symmTensor L(implicitParts::at(*parts_.L, i));
        const vector b((*parts_.viscousWall)[i]);
        const tensor corrected((G - v*b) & L);
        symmTensor S
        (
            twoSymm(corrected) - 2.0/dimensions*tr(corrected)*symmTensor::I
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
        const symmTensor A(implicitParts::at(*parts_.pressureA, i));
        const vector b((*parts_.pressureWall)[i]);
        const double P = (*parts_.stiffness)[i]*((G && A) - (v & b));
        Q = Q + P*A;
        own += V*P*b;
    }
    if (parts_.centralWall)
    {
        own -= (*parts_.centralWall)[i] & v;
    }

    for (int a = 0; a < 3; ++a)
    {
        Q_[i][a] =
            {{float(Q(0, a)), float(Q(1, a)), float(Q(2, a)), float(own[a])}};
    }
}


template<class Number>
void Foam::melt::velocityProduct::sumForces(vectorArrayOf<Number>& Kv) const
{
    const neighbourhood& near = system_->near;
    const double h = near.kernel().h();
    const auto active = [&](const int i) { return !near.idle(i); };

    near.kernel().inUnitsOfH().visit([&](const auto& kernel)
    {
        near.fluid().forEach(active, [&](const int i, const auto& row)
        {
            const auto W = kernel;

            // Q_j alone in the loop, Q_i times the sum of g after it
            constexpr int most = 128;
            alignas(32) float g[3][most];
            float4 force[3] = {};
            float8 sumG[3] = {};
            for (int first = 0; first < row.size(); first += most)
            {
                const std::int32_t* const j = row.sources + first;
                const int n = std::min(most, row.size() - first);
                for (int k = 0; k < n; k += 8)
                {
                    const pairVectors p
                    (
                        W, v_, unit_, near.solid(), i, j + k
                    );
                    const float8 c[3] = {p.c*p.x, p.c*p.y, p.c*p.z};
                    for (int a = 0; a < 3; ++a)
                    {
                        sumG[a] += c[a];
                        std::memcpy(&g[a][k], &c[a], sizeof(c[a]));
                    }
                }
                // Columns are vectors already: not worth transposing
                for (int k = 0; k < n; ++k)
                {
                    const std::array<quad, 3>& Qj = Q_[j[k]];
                    for (int a = 0; a < 3; ++a)
                    {
                        force[a] += load(Qj[a])*g[a][k];
                    }
                }
            }

            const std::array<quad, 3>& Qi = Q_[i];
            for (int a = 0; a < 3; ++a)
            {
                force[a] += load(Qi[a])*sum(sumG[a]);
            }
            const float4 total = force[0] + force[1] + force[2];
            const double scale = system_->fluid.V[i]/h;
            Kv.x[i] = Number(-(scale*total[0] + Qi[0].a[3]));
            Kv.y[i] = Number(-(scale*total[1] + Qi[1].a[3]));
            Kv.z[i] = Number(-(scale*total[2] + Qi[2].a[3]));
        });
    });
}

// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::melt::velocityProduct::build
(
    const sphSystem& system,
    const implicitParts& p
)
{
    system_ = &system;
    parts_ = p;

    const particles& f = system.fluid;
    const smoothingKernel& kernel = system.near.kernel();
    const double h = kernel.h();
    const double volume = std::pow(h, kernel.dimensions())*kernel.depth();
    const int n = f.size();
    v_.resize(n);
    Q_.resize(n);

    const fixedPointSpace space(f, system.near.box());
    for (int a = 0; a < 3; ++a)
    {
        unit_[a] = float(space.unit(a)/h);
    }
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        v_[i].at =
        {
            {
                space.place(f.x[i], 0),
                space.place(f.y[i], 1),
                space.place(f.z[i], 2)
            },
            float(f.V[i]/volume)
        };
    }
}


template<class Number>
void Foam::melt::velocityProduct::apply
(
    const vectorArrayOf<Number>& v,
    vectorArrayOf<Number>& Kv
)
{
    const int n = v.size();
    const double* const eta =
        parts_.centralShare > 0 ? system_->fluid.eta.data() : nullptr;

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        v_[i].v =
        {{
            float(v.x[i]), float(v.y[i]), float(v.z[i]),
            eta ? float(eta[i]) : 0.0f
        }};
    }

    system_->near.countFluidForcePass();
    system_->near.countFluidForcePass();
    eta ? setStress<true>() : setStress<false>();
    sumForces(Kv);
}


template void Foam::melt::velocityProduct::apply
(
    const vectorArrayOf<float>&, vectorArrayOf<float>&
);

template void Foam::melt::velocityProduct::apply
(
    const vectorArrayOf<double>&, vectorArrayOf<double>&
);


std::size_t Foam::melt::velocityProduct::bytes() const
{
    return sizeof(motion)*v_.capacity() + sizeof(Q_[0])*Q_.capacity();
}

// ************************************************************************* //
