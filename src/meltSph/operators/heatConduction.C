/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatConduction.H"
#include "blockSum.H"

#include <algorithm>

double Foam::melt::heatConduction
(
    const neighbourhood& near,
    const wallState& walls,
    const double uniformKappa,
    const double spacing,
    particles& f
)
{
    const double* const x = f.x.data();
    const double* const y = f.y.data();
    const double* const z = f.z.data();
    const double* const V = f.V.data();
    const double* const T = f.T.data();
    const bool uniform = f.kappa.empty();
    const double* const kappa = f.kappa.data();

    // Heat from walls to each particle [W]
    std::vector<double> fromWalls(near.walls().empty() ? 0 : f.size());

    near.kernel().visit([&](const auto& W)
    {
        near.fluid().forEach([&](const int i, const auto& row)
        {
            const double xi = x[i], yi = y[i], zi = z[i];
            const double Ti = T[i];
            const double ki = uniform ? uniformKappa : kappa[i];
            double sum = 0;

            if (uniform)
            {
                #pragma omp simd reduction(+:sum)
                for (int k = 0; k < row.size(); ++k)
                {
                    const int j = row[k];
                    const double dx = xi - x[j];
                    const double dy = yi - y[j];
                    const double dz = zi - z[j];
                    sum +=
                        V[j]*(Ti - T[j])
                       *W.gradientOverR(dx*dx + dy*dy + dz*dz);
                }
                sum *= 2*ki;
            }
            else
            {
                #pragma omp simd reduction(+:sum)
                for (int k = 0; k < row.size(); ++k)
                {
                    const int j = row[k];
                    const double dx = xi - x[j];
                    const double dy = yi - y[j];
                    const double dz = zi - z[j];
                    sum +=
                        V[j]*(ki*kappa[j]/(ki + kappa[j]))*(Ti - T[j])
                       *W.gradientOverR(dx*dx + dy*dy + dz*dz);
                }
                sum *= 4;
            }

            double wallSum = 0;
            const auto wallRow = near.walls().sourcesOf(i);
            for (int k = 0; k < wallRow.size(); ++k)
            {
                const int j = wallRow[k];
                if (walls.heatTransfer[j] == 0)
                {
                    continue;
                }
                const double dx = xi - walls.x[j];
                const double dy = yi - walls.y[j];
                const double dz = zi - walls.z[j];
                const double toWall = std::max
                (
                    0.5*spacing,
                    walls.nx[j]*xi + walls.ny[j]*yi + walls.nz[j]*zi
                  - walls.offset[j]
                );
                const double behind =
                    walls.offset[j]
                  - walls.nx[j]*walls.x[j]
                  - walls.ny[j]*walls.y[j]
                  - walls.nz[j]*walls.z[j];
                const double resistance = ki/walls.heatTransfer[j];

                wallSum +=
                    walls.volume[j]*2*ki*(Ti - walls.T[j])
                   *((toWall + behind)/(toWall + resistance))
                   *W.gradientOverR(dx*dx + dy*dy + dz*dz);
            }

            f.dH[i] = (sum + wallSum)/f.rho[i];
            if (!fromWalls.empty())
            {
                fromWalls[i] = wallSum*V[i];
            }
        });
    });

    return blockSum
    (
        int(fromWalls.size()),
        [&](const int i) { return fromWalls[i]; }
    );
}

// ************************************************************************* //
