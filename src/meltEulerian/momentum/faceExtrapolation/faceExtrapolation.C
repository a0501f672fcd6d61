/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceExtrapolation.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::melt::staggeredGrid;
using Foam::melt::strainElements;
using triple = staggeredGrid::triple;

bool isWall(const staggeredGrid& grid, const int a, const int face)
{
    return
        grid.at(a, face) == staggeredGrid::condition::noSlip
     || grid.at(a, face) == staggeredGrid::condition::slip;
}


//- One component of the velocity
void extrapolate
(
    const strainElements& elements,
    const int layers,
    const int a,
    std::vector<double>& u
)
{
    const staggeredGrid& grid = elements.grid();
    triple n(grid.n());
    n[a] = grid.nLayers(a);

    // Faces of the layer found last, and which are known
    std::vector<triple> front;
    std::vector<char> known(u.size(), 0);
    triple c;
    for (c[2] = 0; c[2] < n[2]; ++c[2])
    {
        for (c[1] = 0; c[1] < n[1]; ++c[1])
        {
            for (c[0] = 0; c[0] < n[0]; ++c[0])
            {
                const int face = grid.face(a, c);
                if (elements.velocity(a, face) >= 0)
                {
                    known[face] = 1;
                    front.push_back(c);
                }
                else if (!isWall(grid, a, face))
                {
                    u[face] = 0;
                }
            }
        }
    }

    const auto forNeighbours = [&](const triple& at, const auto& action)
    {
        for (int b = 0; b < 3; ++b)
        {
            for (const int step : {-1, 1})
            {
                triple next(at);
                next[b] += step;
                if (grid.inside(b, next[b]) || (a == b && next[b] == n[b] - 1))
                {
                    action(next, grid.face(a, next));
                }
            }
        }
    };

    for (int layer = 0; layer < layers; ++layer)
    {
        std::vector<triple> next;
        for (const triple& at : front)
        {
            forNeighbours(at, [&](const triple& to, const int face)
            {
                if (!known[face] && !isWall(grid, a, face))
                {
                    known[face] = 2;
                    next.push_back(to);
                }
            });
        }
        for (const triple& at : next)
        {
            double sum = 0;
            int number = 0;
            forNeighbours(at, [&](const triple&, const int face)
            {
                if (known[face] == 1)
                {
                    sum += u[face];
                    ++number;
                }
            });
            u[grid.face(a, at)] = sum/number;
        }
        for (const triple& at : next)
        {
            known[grid.face(a, at)] = 1;
        }
        front.swap(next);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::faceExtrapolation::extrapolate
(
    const strainElements& elements,
    const int layers,
    faceVelocities& U
)
{
    for (int a = 0; a < 3; ++a)
    {
        if (elements.grid().solved(a))
        {
            ::extrapolate(elements, layers, a, U[a]);
        }
    }
}

// ************************************************************************* //
