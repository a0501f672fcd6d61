/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallContact.H"

#include <limits>

int Foam::melt::keepInFrontOfWalls
(
    const neighbourhood& near,
    const wallState& walls,
    particles& f
)
{
    if (near.walls().empty())
    {
        return 0;
    }

    int count = 0;

    #pragma omp parallel for schedule(static) reduction(+:count)
    for (int i = 0; i < f.size(); ++i)
    {
        const auto row = near.walls().sourcesOf(i);
        int nearest = -1;
        double nearest2 = std::numeric_limits<double>::max();
        for (int k = 0; k < row.size(); ++k)
        {
            const int j = row[k];
            double dx = f.x[i] - walls.x[j];
            double dy = f.y[i] - walls.y[j];
            double dz = f.z[i] - walls.z[j];
            near.box().nearestImage(dx, dy, dz);
            const double r2 = dx*dx + dy*dy + dz*dz;
            if (r2 < nearest2)
            {
                nearest2 = r2;
                nearest = j;
            }
        }
        if (nearest < 0)
        {
            continue;
        }

        const double nx = walls.nx[nearest];
        const double ny = walls.ny[nearest];
        const double nz = walls.nz[nearest];
        const double distance =
            nx*f.x[i] + ny*f.y[i] + nz*f.z[i] - walls.offset[nearest];
        if (distance >= 0)
        {
            continue;
        }

        ++count;
        f.x[i] -= 2*distance*nx;
        f.y[i] -= 2*distance*ny;
        f.z[i] -= 2*distance*nz;

        const double inward =
            nx*(f.u[i] - walls.wallU[nearest])
          + ny*(f.v[i] - walls.wallV[nearest])
          + nz*(f.w[i] - walls.wallW[nearest]);
        if (inward < 0)
        {
            f.u[i] -= inward*nx;
            f.v[i] -= inward*ny;
            f.w[i] -= inward*nz;
        }
    }
    return count;
}

// ************************************************************************* //
