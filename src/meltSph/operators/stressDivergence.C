/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stressDivergence.H"

void Foam::melt::addStressDivergence
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
    const double* const sxx = f.S[0].data();
    const double* const sxy = f.S[1].data();
    const double* const sxz = f.S[2].data();
    const double* const syy = f.S[3].data();
    const double* const syz = f.S[4].data();
    const double* const szz = f.S[5].data();

    near.kernel().visit([&](const auto& W)
    {
        near.fluid().forEach([&](const int i, const auto& row)
        {
            const double xi = x[i], yi = y[i], zi = z[i];
            const double xx = sxx[i], xy = sxy[i], xz = sxz[i];
            const double yy = syy[i], yz = syz[i], zz = szz[i];
            double sx = 0, sy = 0, sz = 0;

            #pragma omp simd reduction(+:sx,sy,sz)
            for (int k = 0; k < row.size(); ++k)
            {
                const int j = row[k];
                double dx = xi - x[j], dy = yi - y[j], dz = zi - z[j];
                const double c =
                    V[j]*W.gradientOverR(dx*dx + dy*dy + dz*dz);
                dx *= c;
                dy *= c;
                dz *= c;
                sx += (xx + sxx[j])*dx + (xy + sxy[j])*dy + (xz + sxz[j])*dz;
                sy += (xy + sxy[j])*dx + (yy + syy[j])*dy + (yz + syz[j])*dz;
                sz += (xz + sxz[j])*dx + (yz + syz[j])*dy + (zz + szz[j])*dz;
            }

            const auto wallRow = near.walls().sourcesOf(i);
            for (int k = 0; k < wallRow.size(); ++k)
            {
                const int j = wallRow[k];
                const double dx = xi - walls.x[j];
                const double dy = yi - walls.y[j];
                const double dz = zi - walls.z[j];
                const double c =
                    2*walls.volume[j]*W.gradientOverR(dx*dx + dy*dy + dz*dz);

                double tx = xx*dx + xy*dy + xz*dz;
                double ty = xy*dx + yy*dy + yz*dz;
                double tz = xz*dx + yz*dy + zz*dz;

                if (walls.slip[j])
                {
                    // S d + R S R d, halved
                    const double nx = walls.nx[j];
                    const double ny = walls.ny[j];
                    const double nz = walls.nz[j];
                    const double nd = dx*nx + dy*ny + dz*nz;
                    const double rx = dx - 2*nd*nx;
                    const double ry = dy - 2*nd*ny;
                    const double rz = dz - 2*nd*nz;
                    const double qx = xx*rx + xy*ry + xz*rz;
                    const double qy = xy*rx + yy*ry + yz*rz;
                    const double qz = xz*rx + yz*ry + zz*rz;
                    const double nq = qx*nx + qy*ny + qz*nz;
                    tx = 0.5*(tx + qx) - nq*nx;
                    ty = 0.5*(ty + qy) - nq*ny;
                    tz = 0.5*(tz + qz) - nq*nz;
                }

                sx += c*tx;
                sy += c*ty;
                sz += c*tz;
            }

            f.ax[i] += sx/f.rho[i];
            f.ay[i] += sy/f.rho[i];
            f.az[i] += sz/f.rho[i];
        });
    });
}

// ************************************************************************* //
