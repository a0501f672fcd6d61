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

using Foam::melt::float8;
using Foam::melt::vectorArray;

Foam::symmTensor at(const Foam::melt::implicitParts::blocks& b, const int i)
{
    return {b[0][i], b[1][i], b[2][i], b[3][i], b[4][i], b[5][i]};
}


//- Zero where there are no walls
Foam::vector at(const vectorArray* a, const int i)
{
    return a && a->size()
      ? Foam::vector(a->x[i], a->y[i], a->z[i])
      : Foam::vector(Foam::Zero);
}


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
void Foam::melt::velocityProduct::setStress(const vectorArray& velocity)
{
    const neighbourhood& near = system_->near;

    near.kernel().inUnitsOfH().visit([&](const auto& kernel)
    {
        near_.forEach([&](const int i, const auto& row)
        {
            const auto W = kernel;
            const quad vi = v_[i];
            float8 xx{}, xy{}, xz{}, yx{}, yy{}, yz{}, zx{}, zy{}, zz{};
            float8 fx{}, fy{}, fz{};

            for (int k = 0; k < row.size(); k += 8)
            {
                const std::int32_t* const j = row.sources + k;
                const pairVectors p
                (
                    W, places_.data(), unit_, near.solid(), i, j
                );
                const std::array<float8, 4> vj(gather(v_.data(), j));
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
                vector(velocity.x[i], velocity.y[i], velocity.z[i]),
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
    const vector& v,
    const tensor& gradient,
    const vector& central
)
{
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
        const symmTensor L(at(*parts_.L, i));
        const vector b(at(parts_.viscousWall, i));
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
        const symmTensor A(at(*parts_.pressureA, i));
        const vector b(at(parts_.pressureWall, i));
        const double P = (*parts_.stiffness)[i]*((G && A) - (v & b));
        Q = Q + P*A;
        own += V*P*b;
    }
    if (parts_.centralWall && !(*parts_.centralWall)[0].empty())
    {
        own -= parts_.centralShare*(at(*parts_.centralWall, i) & v);
    }

    for (int a = 0; a < 3; ++a)
    {
        Q_[i][a] =
            {{float(Q(0, a)), float(Q(1, a)), float(Q(2, a)), float(own[a])}};
    }
}


void Foam::melt::velocityProduct::sumForces(vectorArray& Kv) const
{
    const neighbourhood& near = system_->near;
    const double h = near.kernel().h();

    near.kernel().inUnitsOfH().visit([&](const auto& kernel)
    {
        near_.forEach([&](const int i, const auto& row)
        {
            const auto W = kernel;

            const quad* const Q = Q_.data()->data();

            // Q_j alone in the loop, Q_i times the sum of g after it
            float8 fx{}, fy{}, fz{}, gx{}, gy{}, gz{};
            for (int k = 0; k < row.size(); k += 8)
            {
                const std::int32_t* const j = row.sources + k;
                const pairVectors p
                (
                    W, places_.data(), unit_, near.solid(), i, j
                );
                const float8 g[3] = {p.c*p.x, p.c*p.y, p.c*p.z};
                gx += g[0];
                gy += g[1];
                gz += g[2];
                for (int a = 0; a < 3; ++a)
                {
                    const std::array<float8, 4> column(gather<3>(Q + a, j));
                    fx += column[0]*g[a];
                    fy += column[1]*g[a];
                    fz += column[2]*g[a];
                }
            }

            const quad* const Qi = Q + 3*i;
            const vector g(sum(gx), sum(gy), sum(gz));
            vector own(sum(fx), sum(fy), sum(fz));
            for (int a = 0; a < 3; ++a)
            {
                own += g[a]*vector(Qi[a].a[0], Qi[a].a[1], Qi[a].a[2]);
            }
            own *= system_->fluid.V[i]/h;
            Kv.x[i] = -(own.x() + Qi[0].a[3]);
            Kv.y[i] = -(own.y() + Qi[1].a[3]);
            Kv.z[i] = -(own.z() + Qi[2].a[3]);
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
    places_.resize(n);
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
        places_[i] =
        {
            {
                space.place(f.x[i], 0),
                space.place(f.y[i], 1),
                space.place(f.z[i], 2)
            },
            float(f.V[i]/volume)
        };
    }

    const double radius2 = sqr(kernel.support()/h);
    near_.select(system.near.fluid(), [&](const int i, const int j)
    {
        double q2 = 0;
        for (int a = 0; a < 3; ++a)
        {
            q2 += sqr
            (
                unit_[a]*std::int32_t(places_[i].x[a] - places_[j].x[a])
            );
        }
        return q2 < radius2 && !system.near.idle(i);
    });
}


void Foam::melt::velocityProduct::apply(const vectorArray& v, vectorArray& Kv)
{
    const int n = v.size();
    const double* const eta =
        parts_.centralShare > 0 ? system_->fluid.eta.data() : nullptr;

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        v_[i] =
        {{
            float(v.x[i]), float(v.y[i]), float(v.z[i]),
            eta ? float(eta[i]) : 0.0f
        }};
    }

    system_->near.countPairs(2*near_.nPairs());
    eta ? setStress<true>(v) : setStress<false>(v);
    sumForces(Kv);
}


std::size_t Foam::melt::velocityProduct::bytes() const
{
    return
        sizeof(place)*places_.capacity()
      + sizeof(quad)*(v_.capacity() + 3*Q_.capacity())
      + near_.bytes();
}

// ************************************************************************* //
