/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pressureForce.H"

void Foam::melt::addPressureForce
(
    const neighbourhood& near,
    const wallState& walls,
    particles& f
)
{
    const double* const x = f.x.data();
    const double* const y = f.y.data();
    const double* const z = f.z.data();
    const double* const V = f.V.data();
    const double* const p = f.p.data();

    near.kernel().visit([&](const auto& W)
    {
        near.fluid().forEach([&](const int i, const auto& row)
        {
            const double xi = x[i], yi = y[i], zi = z[i], pi = p[i];
            double sx = 0, sy = 0, sz = 0;

            #pragma omp simd reduction(+:sx,sy,sz)
            for (int k = 0; k < row.size(); ++k)
            {
                const int j = row[k];
                const double dx = xi - x[j], dy = yi - y[j], dz = zi - z[j];
                const double c =
                    V[j]*(pi + p[j])
                   *W.gradientOverR(dx*dx + dy*dy + dz*dz);
                sx += c*dx;
                sy += c*dy;
                sz += c*dz;
            }

            const auto wallRow = near.walls().sourcesOf(i);
            for (int k = 0; k < wallRow.size(); ++k)
            {
                const int j = wallRow[k];
                const double dx = xi - walls.x[j];
                const double dy = yi - walls.y[j];
                const double dz = zi - walls.z[j];
                const double c =
                    walls.volume[j]*(pi + walls.p[j])
                   *W.gradientOverR(dx*dx + dy*dy + dz*dz);
                sx += c*dx;
                sy += c*dy;
                sz += c*dz;
            }

            f.ax[i] -= sx/f.rho[i];
            f.ay[i] -= sy/f.rho[i];
            f.az[i] -= sz/f.rho[i];
        });
    });
}

// ************************************************************************* //
