/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "artificialViscosity.H"

#include <algorithm>

void Foam::melt::addArtificialViscosity
(
    const neighbourhood& near,
    const double alpha,
    const double beta,
    const double soundSpeed,
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
    const double h = near.kernel().h();
    const double alphaC = alpha*soundSpeed;

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
                const double r2 = dx*dx + dy*dy + dz*dz;
                const double approach = std::min
                (
                    0.0,
                    (ui - u[j])*dx + (vi - v[j])*dy + (wi - w[j])*dz
                );
                const double mu = h*approach/(r2 + 0.01*h*h);
                const double c =
                    m[j]*mu*(beta*mu - alphaC)/(0.5*(rhoi + rho[j]))
                   *W.gradientOverR(r2);
                sx += c*dx;
                sy += c*dy;
                sz += c*dz;
            }

            f.ax[i] -= sx;
            f.ay[i] -= sy;
            f.az[i] -= sz;
        });
    });
}

// ************************************************************************* //
