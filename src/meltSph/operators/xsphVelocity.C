/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "xsphVelocity.H"

void Foam::melt::xsphVelocity
(
    const neighbourhood& near,
    const double epsilon,
    particles& f
)
{
    const double* const x = f.x.data();
    const double* const y = f.y.data();
    const double* const z = f.z.data();
    const double* const u = f.u.data();
    const double* const v = f.v.data();
    const double* const w = f.w.data();
    const double* const rho = f.rho.data();
    const double* const m = f.m.data();

    near.kernel().visit([&](const auto& W)
    {
        near.fluid().forEach([&](const int i, const auto& row)
        {
            const double xi = x[i], yi = y[i], zi = z[i];
            const double ui = u[i], vi = v[i], wi = w[i], rhoi = rho[i];
            double sx = 0, sy = 0, sz = 0;

            #pragma omp simd reduction(+:sx,sy,sz)
            for (int k = 0; k < row.size(); ++k)
            {
                const int j = row[k];
                const double dx = xi - x[j], dy = yi - y[j], dz = zi - z[j];
                const double c =
                    2*m[j]/(rhoi + rho[j])
                   *W.value(dx*dx + dy*dy + dz*dz);
                sx += c*(u[j] - ui);
                sy += c*(v[j] - vi);
                sz += c*(w[j] - wi);
            }

            f.du[i] = epsilon*sx;
            f.dv[i] = epsilon*sy;
            f.dw[i] = epsilon*sz;
        });
    });
}

// ************************************************************************* //
