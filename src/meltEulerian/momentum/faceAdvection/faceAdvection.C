/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceAdvection.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::melt::faceVelocities;
using Foam::melt::staggeredGrid;
using triple = staggeredGrid::triple;

//- Van Leer's slope
double limited(const double a, const double b)
{
    return a*b > 0 ? 2*a*b/(a + b) : 0;
}


//- Component b at a face normal to a: of the faces around it
double around
(
    const staggeredGrid& grid,
    const faceVelocities& U,
    const int a,
    const triple& c,
    const int b
)
{
    if (a == b)
    {
        return U[a][grid.face(a, c)];
    }
    double sum = 0;
    int number = 0;
    for (const int lower : {0, 1})
    {
        for (const int upper : {0, 1})
        {
            triple cell(c);
            cell[a] -= lower;
            if (grid.inside(cell))
            {
                cell[b] += upper;
                sum += U[b][grid.face(b, cell)];
                ++number;
            }
        }
    }
    return sum/number;
}


//- Component a at the face that is a number of steps away in direction b; what
//  is beyond a wall continues it there: 2 Uwall - U, or U if it slips
double along
(
    const staggeredGrid& grid,
    const faceVelocities& U,
    const int a,
    const triple& c,
    const int b,
    const int step
)
{
    triple to(c);
    to[b] += step;
    const double here = U[a][grid.face(a, c)];
    const bool beyond =
        a == b
      ? !grid.inside(b, to[b]) && to[b] != grid.n()[b]
      : !grid.inside(b, to[b]);
    if (beyond)
    {
        if (a == b || std::abs(step) > 1)
        {
            return here;
        }
        triple wall(c);
        wall[b] += step > 0;
        if (!grid.inside(c))
        {
            --wall[a];
        }
        const int face = grid.face(b, wall);
        return
            grid.at(b, face) == staggeredGrid::condition::noSlip
          ? 2*grid.wallVelocity(b, face, a) - here : here;
    }
    return U[a][grid.face(a, to)];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::melt::faceVelocities Foam::melt::faceAdvection::advected
(
    const strainElements& elements,
    const faceVelocities& U,
    const double dt
)
{
    const staggeredGrid& grid = elements.grid();
    faceVelocities result(U);
    for (int a = 0; a < 3; ++a)
    {
        triple c, n(grid.n());
        n[a] = grid.nLayers(a);
        for (c[2] = 0; c[2] < n[2]; ++c[2])
        {
            for (c[1] = 0; c[1] < n[1]; ++c[1])
            {
                for (c[0] = 0; c[0] < n[0]; ++c[0])
                {
                    const int face = grid.face(a, c);
                    if (elements.velocity(a, face) < 0)
                    {
                        continue;
                    }
                    const double u = U[a][face];
                    double rate = 0;
                    for (int b = 0; b < 3; ++b)
                    {
                        if (!grid.solved(b))
                        {
                            continue;
                        }
                        const double speed = around(grid, U, a, c, b);
                        const int up = speed > 0 ? -1 : 1;
                        const double upwind = along(grid, U, a, c, b, up);
                        const double centred =
                            limited
                            (
                                along(grid, U, a, c, b, -up) - u, u - upwind
                            );
                        const double behind =
                            limited
                            (
                                u - upwind,
                                upwind - along(grid, U, a, c, b, 2*up)
                            );
                        rate += std::abs(speed)/grid.d()[b]
                           *(u - upwind + 0.5*(centred - behind));
                    }
                    result[a][face] = u - dt*rate;
                }
            }
        }
    }
    return result;
}

// ************************************************************************* //
