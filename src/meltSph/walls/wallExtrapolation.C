/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallExtrapolation.H"

#include <algorithm>

void Foam::melt::wallExtrapolation
(
    const neighbourhood& near,
    const particles& f,
    const std::array<double, 3>& g,
    wallState& walls
)
{
    near.countPass(near.fluidOfWalls());

    near.visit([&](const auto& W, const auto& space)
    {
        const int n = near.fluidOfWalls().empty() ? 0 : int(walls.size());

        #pragma omp parallel for schedule(dynamic, 256)
        for (int i = 0; i < n; ++i)
        {
            const auto row = near.fluidOfWalls().sourcesOf(i);
            if (row.size() == 0)
            {
                continue;
            }

            double weight = 0, p = 0, u = 0, v = 0, w = 0;
            for (int k = 0; k < row.size(); ++k)
            {
                const int j = row[k];
                double dx = walls.x[i] - f.x[j];
                double dy = walls.y[i] - f.y[j];
                double dz = walls.z[i] - f.z[j];
                space.nearestImage(dx, dy, dz);
                const double c = W.value(dx*dx + dy*dy + dz*dz);
                weight += c;
                p += c
                   *(f.p[j] + f.rho[j]*(g[0]*dx + g[1]*dy + g[2]*dz));
                u += c*f.u[j];
                v += c*f.v[j];
                w += c*f.w[j];
            }
            if (weight == 0)
            {
                // All of them within the skin
                walls.p[i] = 0;
                walls.u[i] = walls.wallU[i];
                walls.v[i] = walls.wallV[i];
                walls.w[i] = walls.wallW[i];
                continue;
            }

            walls.p[i] = std::max(0.0, p/weight);
            u /= weight;
            v /= weight;
            w /= weight;
            if (walls.slip[i])
            {
                const double turned = 2
                   *(
                        walls.nx[i]*(u - walls.wallU[i])
                      + walls.ny[i]*(v - walls.wallV[i])
                      + walls.nz[i]*(w - walls.wallW[i])
                    );
                walls.u[i] = u - turned*walls.nx[i];
                walls.v[i] = v - turned*walls.ny[i];
                walls.w[i] = w - turned*walls.nz[i];
            }
            else
            {
                walls.u[i] = 2*walls.wallU[i] - u;
                walls.v[i] = 2*walls.wallV[i] - v;
                walls.w[i] = 2*walls.wallW[i] - w;
            }
        }
    });
}

// ************************************************************************* //
