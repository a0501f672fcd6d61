/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceTension.H"
#include "heightCurvature.H"

#include <algorithm>
#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::surfaceTension::addAcceleration
(
    const staggeredGrid& grid,
    const std::vector<double>& alpha,
    const double wetFrom,
    const double sigma,
    const double rho,
    faceVelocities& acceleration
)
{
    const heightCurvature kappa(grid, alpha);
    const auto wet = [&](const int cell)
    {
        return alpha[cell] < wetFrom ? 0 : alpha[cell];
    };
    grid.forAllFaces([&](int a, int face, int lower, int upper)
    {
        if
        (
            lower < 0 || upper < 0
         || grid.at(a, face) != staggeredGrid::condition::interior
        )
        {
            return;
        }
        const double below = wet(lower), above = wet(upper);
        const int n = kappa.known(lower) + kappa.known(upper);
        if (n && below != above)
        {
            // Force over the mass of stokesSystem: half of both cells' liquid
            acceleration[a][face] +=
                sigma*(kappa[lower] + kappa[upper])/n*(above - below)
               /(0.5*(above + below)*rho*grid.d()[a]);
        }
    });
}


double Foam::melt::surfaceTension::capillaryTime
(
    const staggeredGrid& grid,
    const double sigma,
    const double rho
)
{
    double dx = std::numeric_limits<double>::max();
    for (int a = 0; a < 3; ++a)
    {
        if (grid.solved(a))
        {
            dx = std::min(dx, grid.d()[a]);
        }
    }
    return std::sqrt(rho*dx*dx*dx/(2*M_PI*sigma));
}

// ************************************************************************* //
