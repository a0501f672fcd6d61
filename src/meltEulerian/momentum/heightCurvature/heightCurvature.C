/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heightCurvature.H"

#include <algorithm>
#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using triple = Foam::melt::staggeredGrid::triple;

// Cells of a column on each side of the one that it is for
const int reach = 5;

// Cells that are full or empty to this end a column [-]
const double sharp = 1e-6;

// Where a column has no such end, its last cell may be so far from it [-]
const double blunt = 1e-2;

// Normals of a gradient that is less than that by a cell so full are none [-]
const double faint = 0.1;

// Curvature by normals that is an edge, in one over the least edge of a cell [-]
const double edge = 1.5;


triple shifted(triple c, const int a, const int by)
{
    c[a] += by;
    return c;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::heightCurvature::free(const triple& c) const
{
    return grid_.inside(c) && !grid_.blocked(grid_.cell(c));
}


bool Foam::melt::heightCurvature::atSurface(const triple& c) const
{
    const double alpha = alpha_[grid_.cell(c)];
    for (int a = 0; a < 3; ++a)
    {
        for (const int by : {-1, 1})
        {
            const triple beside(shifted(c, a, by));
            if
            (
                free(beside)
             && std::abs(alpha_[grid_.cell(beside)] - alpha) > sharp
            )
            {
                return true;
            }
        }
    }
    return false;
}


std::array<double, 3>
Foam::melt::heightCurvature::gradient(const triple& c) const
{
    std::array<double, 3> result{0, 0, 0};
    const double centre = alpha_[grid_.cell(c)];
    triple by;
    for (by[2] = -1; by[2] <= 1; ++by[2])
    {
        for (by[1] = -1; by[1] <= 1; ++by[1])
        {
            for (by[0] = -1; by[0] <= 1; ++by[0])
            {
                const triple other{c[0] + by[0], c[1] + by[1], c[2] + by[2]};
                const double alpha =
                    free(other) ? alpha_[grid_.cell(other)] : centre;
                for (int a = 0; a < 3; ++a)
                {
                    result[a] += by[a]*alpha/grid_.d()[a];
                }
            }
        }
    }
    return result;
}


bool Foam::melt::heightCurvature::height
(
    const triple& c,
    const int a,
    const int up,
    double& h
) const
{
    // Cells below: as many as there are to a full one, which a wall under melt
    // is. Melt over air is a drop or a sheet within the column
    double cells = 0;
    int below = 0;
    bool wet = false;
    for (bool full = false; !full; ++below)
    {
        const triple at(shifted(c, a, -up*below));
        const bool wall = !free(at);
        const double alpha = wall ? 1 : alpha_[grid_.cell(at)];
        if (below > reach || (wall && !wet) || (wet && alpha <= sharp))
        {
            return false;
        }
        wet = wet || alpha > sharp;
        full = alpha >= 1 - (below == reach ? blunt : sharp);
        cells += full ? 1 : alpha;
    }

    int above = 0;
    for (bool empty = false; !empty; ++above)
    {
        const triple at(shifted(c, a, up*above));
        if (above > reach || !free(at))
        {
            return false;
        }
        const double alpha = alpha_[grid_.cell(at)];
        empty = alpha <= (above == reach ? blunt : sharp);
        cells += above == 0 ? 0 : alpha;
    }
    h = (cells - below + 0.5)*grid_.d()[a];
    return true;
}


bool Foam::melt::heightCurvature::fromHeights
(
    const triple& c,
    const int a,
    const int up,
    double& kappa
) const
{
    const int b0 = (a + 1) % 3, b1 = (a + 2) % 3;
    double h[3][3];
    if (!height(c, a, up, h[1][1]))
    {
        return false;
    }
    for (int i = -1; i <= 1; ++i)
    {
        for (int j = -1; j <= 1; ++j)
        {
            // Mirrored at what is not free, and in the direction of no flow
            triple at(c);
            at[b0] += grid_.solved(b0) && free(shifted(c, b0, i)) ? i : 0;
            at[b1] += grid_.solved(b1) && free(shifted(at, b1, j)) ? j : 0;
            if (!height(at, a, up, h[i + 1][j + 1]))
            {
                return false;
            }
        }
    }

    const double dx = grid_.d()[b0], dy = grid_.d()[b1];
    const double hx = 0.5*(h[2][1] - h[0][1])/dx;
    const double hy = 0.5*(h[1][2] - h[1][0])/dy;
    const double hxx = (h[2][1] - 2*h[1][1] + h[0][1])/(dx*dx);
    const double hyy = (h[1][2] - 2*h[1][1] + h[1][0])/(dy*dy);
    const double hxy =
        0.25*(h[2][2] - h[2][0] - h[0][2] + h[0][0])/(dx*dy);
    kappa =
       -(hxx*(1 + hy*hy) + hyy*(1 + hx*hx) - 2*hxy*hx*hy)
       /std::pow(1 + hx*hx + hy*hy, 1.5);
    return true;
}


bool Foam::melt::heightCurvature::fromHeights
(
    const triple& c,
    double& kappa
) const
{
    const std::array<double, 3> g(gradient(c));
    std::array<int, 3> directions{0, 1, 2};
    std::stable_sort
    (
        directions.begin(),
        directions.end(),
        [&](const int i, const int j)
        {
            return std::abs(g[i]) > std::abs(g[j]);
        }
    );
    return std::any_of
    (
        directions.begin(),
        directions.end(),
        [&](const int a)
        {
            return
                grid_.solved(a)
             && g[a] != 0
             && fromHeights(c, a, g[a] > 0 ? -1 : 1, kappa);
        }
    );
}


double Foam::melt::heightCurvature::fromNormals(const triple& c) const
{
    // Normals to the air at the corners of the cell, from the 8 cells around
    // each: the divergence of their means over the faces
    const double centre = alpha_[grid_.cell(c)];
    double kappa = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
        std::array<double, 3> side, normal{0, 0, 0};
        for (int a = 0; a < 3; ++a)
        {
            side[a] = corner >> a & 1 ? 1 : -1;
        }
        for (int i = 0; i < 8; ++i)
        {
            triple at(c);
            for (int a = 0; a < 3; ++a)
            {
                at[a] += grid_.solved(a) && (i >> a & 1) ? int(side[a]) : 0;
            }
            const double alpha = free(at) ? alpha_[grid_.cell(at)] : centre;
            for (int a = 0; a < 3; ++a)
            {
                normal[a] -= side[a]*(i >> a & 1 ? alpha : -alpha)/grid_.d()[a];
            }
        }
        const double size = std::sqrt
        (
            normal[0]*normal[0] + normal[1]*normal[1] + normal[2]*normal[2]
        );
        for (int a = 0; a < 3; ++a)
        {
            if (size*grid_.d()[a] > faint)
            {
                kappa += 0.25*side[a]*normal[a]/size/grid_.d()[a];
            }
        }
    }
    return kappa;
}


bool Foam::melt::heightCurvature::withoutHeights
(
    const triple& c,
    const std::vector<char>& ofHeights,
    double& kappa
) const
{
    double sum = 0;
    int n = 0;
    triple by;
    for (by[2] = -1; by[2] <= 1; ++by[2])
    {
        for (by[1] = -1; by[1] <= 1; ++by[1])
        {
            for (by[0] = -1; by[0] <= 1; ++by[0])
            {
                const triple at{c[0] + by[0], c[1] + by[1], c[2] + by[2]};
                if (grid_.inside(at) && ofHeights[grid_.cell(at)])
                {
                    sum += kappa_[grid_.cell(at)];
                    ++n;
                }
            }
        }
    }
    double least = std::numeric_limits<double>::max();
    for (int a = 0; a < 3; ++a)
    {
        if (grid_.solved(a))
        {
            least = std::min(least, grid_.d()[a]);
        }
    }
    const double ofEdge = fromNormals(c);
    const bool atEdge = std::abs(ofEdge)*least > edge;
    kappa = atEdge ? ofEdge : n ? sum/n : 0;
    return atEdge || n;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::heightCurvature::heightCurvature
(
    const staggeredGrid& grid,
    const std::vector<double>& alpha
)
:
    grid_(grid),
    alpha_(alpha),
    kappa_(grid.nCells(), 0),
    known_(grid.nCells(), 0)
{
    std::vector<int> rest;
    for (int cell = 0; cell < grid.nCells(); ++cell)
    {
        const triple c(grid.position(cell));
        if (!grid.blocked(cell) && atSurface(c))
        {
            known_[cell] = fromHeights(c, kappa_[cell]);
            if (!known_[cell])
            {
                rest.push_back(cell);
            }
        }
    }
    const std::vector<char> ofHeights(known_);
    for (const int cell : rest)
    {
        known_[cell] =
            withoutHeights(grid.position(cell), ofHeights, kappa_[cell]);
    }
}

// ************************************************************************* //
