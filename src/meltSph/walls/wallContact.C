/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallContact.H"

#include <array>
#include <limits>

namespace Foam
{
namespace melt
{
namespace
{

//- Wall particle nearest to fluid particle i of those in front of the planes of
//  the wall particles given; -1: none
int nearestWall
(
    const neighbourhood& near,
    const wallState& walls,
    const particles& f,
    const int i,
    const std::array<int, 3>& before,
    const int nBefore
)
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
        bool wanted = r2 < nearest2;
        for (int b = 0; wanted && b < nBefore; ++b)
        {
            const int w = before[b];
            wanted =
                walls.nx[w]*walls.x[j] + walls.ny[w]*walls.y[j]
              + walls.nz[w]*walls.z[j] > walls.offset[w];
        }
        if (wanted)
        {
            nearest2 = r2;
            nearest = j;
        }
    }
    return nearest;
}


//- Put particle i back in front of the plane of wall particle j
bool putBack(const wallState& walls, const int j, particles& f, const int i)
{
    const double nx = walls.nx[j];
    const double ny = walls.ny[j];
    const double nz = walls.nz[j];
    const double distance =
        nx*f.x[i] + ny*f.y[i] + nz*f.z[i] - walls.offset[j];
    if (distance >= 0)
    {
        return false;
    }

    f.x[i] -= 2*distance*nx;
    f.y[i] -= 2*distance*ny;
    f.z[i] -= 2*distance*nz;

    const double inward =
        nx*(f.u[i] - walls.wallU[j])
      + ny*(f.v[i] - walls.wallV[j])
      + nz*(f.w[i] - walls.wallW[j]);
    if (inward < 0)
    {
        f.u[i] -= inward*nx;
        f.v[i] -= inward*ny;
        f.w[i] -= inward*nz;
    }
    return true;
}

} // End anonymous namespace
} // End namespace melt
} // End namespace Foam


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
        std::array<int, 3> planes;
        bool wasBehind = false;
        for (int n = 0; n < 3; ++n)
        {
            planes[n] = nearestWall(near, walls, f, i, planes, n);
            if (planes[n] < 0)
            {
                break;
            }
            wasBehind = putBack(walls, planes[n], f, i) || wasBehind;
        }
        count += wasBehind;
    }
    return count;
}

// ************************************************************************* //
