/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lubricationRule.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Longest step where there is no limit [s]
constexpr double unlimited = 1e30;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::lubricationRule::lubricationRule
(
    const filmViscosity& film,
    const double weight,
    const double thicknessLimit,
    const double waveSteps
)
:
    film_(film),
    weight_(weight),
    thicknessLimit_(thicknessLimit),
    waveSteps_(waveSteps),
    flows_(film, weight, thicknessLimit)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::melt::lubricationRule::prepare(voxelGrid& grid)
{
    segments_.build(grid);
    if (weight_ <= 0)
    {
        return unlimited;
    }
    const double dx = grid.dx();
    const double g = weight_/grid.material().rho;
    std::vector<openSegments::slot>& slots = segments_.slots();
    double fastest = 0;

    #pragma omp parallel for schedule(dynamic, 4) reduction(max:fastest)
    for (int i = 0; i < int(slots.size()); ++i)
    {
        if (slots[i].wet == 0)
        {
            continue;
        }
        for (openSegment& segment : slots[i].segments)
        {
            if (segment.height > 0)
            {
                const double h = std::min(segment.height, thicknessLimit_);
                segment.fluidity = film_.fluidity(segment.T, weight_*h*dx);
                const double viscous =
                    weight_*segment.fluidity*h*h*h*dx
                   /(3*filmFlows::maxPortion);
                const double wave = waveSteps_*std::sqrt(g*h/dx);
                fastest = std::max(fastest, std::min(viscous, wave));
            }
        }
    }
    return fastest > 0 ? 1/fastest : unlimited;
}


void Foam::melt::lubricationRule::spread(voxelGrid& grid, const double dt)
{
    flows_.find(grid, segments_, dt);
    maxSpeed_ =
        exchange_.exchange(grid, segments_, flows_.list())*grid.dx()/dt;
    grid.refresh();
}

// ************************************************************************* //
