/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "strainElements.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::melt::staggeredGrid;
using triple = staggeredGrid::triple;

//- Calls action(c) for c from 0 to below end
template<class Action>
void forAllIn(const triple& end, const Action& action)
{
    triple c;
    for (c[2] = 0; c[2] < end[2]; ++c[2])
    {
        for (c[1] = 0; c[1] < end[1]; ++c[1])
        {
            for (c[0] = 0; c[0] < end[0]; ++c[0])
            {
                action(c);
            }
        }
    }
}


triple shifted(triple c, const int a, const int by)
{
    c[a] += by;
    return c;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::strainElements::number()
{
    for (int a = 0; a < 3; ++a)
    {
        velocity_[a].assign(grid_.nFaces(a), -1);
        if (grid_.solved(a))
        {
            triple end(grid_.n());
            end[a] = grid_.nLayers(a);
            forAllIn(end, [&](const triple& c)
            {
                const triple lower(shifted(c, a, -1));
                const int face = grid_.face(a, c);
                const auto condition = grid_.at(a, face);
                const bool wet =
                    (grid_.inside(c) && alpha_[grid_.cell(c)] > 0)
                 || (grid_.inside(lower) && alpha_[grid_.cell(lower)] > 0);
                if
                (
                    wet
                 && (
                        condition == staggeredGrid::condition::interior
                     || condition == staggeredGrid::condition::open
                    )
                )
                {
                    velocity_[a][face] = nVelocities_++;
                }
            });
        }
    }

    // A cell between walls only has no pressure
    pressure_.assign(grid_.nCells(), -1);
    forAllIn(grid_.n(), [&](const triple& c)
    {
        const int cell = grid_.cell(c);
        bool moves = false;
        for (int a = 0; a < 3; ++a)
        {
            moves = moves
             || velocity_[a][grid_.face(a, c)] >= 0
             || velocity_[a][grid_.face(a, shifted(c, a, 1))] >= 0;
        }
        if (alpha_[cell] > 0 && moves)
        {
            pressure_[cell] = nPressures_++;
        }
    });
}


bool Foam::melt::strainElements::add
(
    element& e,
    const int a,
    const int face,
    const double coeff
) const
{
    const int unknown = velocity_[a][face];
    if (unknown >= 0)
    {
        e.unknown[e.n] = unknown;
        e.coeff[e.n] = coeff;
        ++e.n;
        return true;
    }
    const auto condition = grid_.at(a, face);
    if
    (
        condition == staggeredGrid::condition::noSlip
     || condition == staggeredGrid::condition::slip
    )
    {
        e.constant += coeff*grid_.wallVelocity(a, face, a);
        return true;
    }
    return false;
}


void Foam::melt::strainElements::addNormalRates()
{
    forAllIn(grid_.n(), [&](const triple& c)
    {
        const int cell = grid_.cell(c);
        if (alpha_[cell] > 0)
        {
            for (int a = 0; a < 3; ++a)
            {
                element e{};
                e.plane = -1;
                if (grid_.solved(a))
                {
                    const double perCell = 1/grid_.d()[a];
                    add(e, a, grid_.face(a, shifted(c, a, 1)), perCell);
                    add(e, a, grid_.face(a, c), -perCell);
                }
                if (e.n)
                {
                    e.weight = alpha_[cell]*grid_.volume();
                    e.cells[0] = cell;
                    e.nCells = 1;
                    elements_.push_back(e);
                }
            }
        }
    });
}


void Foam::melt::strainElements::addShearRates(const int plane)
{
    const int a = plane, b = (plane + 1) % 3;
    if (!grid_.solved(a) || !grid_.solved(b))
    {
        return;
    }
    const double da = grid_.d()[a], db = grid_.d()[b];

    triple end(grid_.n());
    end[a] = grid_.nLayers(a);
    end[b] = grid_.nLayers(b);
    forAllIn(end, [&](const triple& c)
    {
        // Cells -- +- -+ ++ of the edge in the directions a, b
        const triple cells[4] =
        {
            shifted(shifted(c, a, -1), b, -1), shifted(c, b, -1),
            shifted(c, a, -1), c
        };
        bool free[4];
        double liquid[4];
        element e{};
        for (int i = 0; i < 4; ++i)
        {
            free[i] =
                grid_.inside(cells[i]) && !grid_.blocked(grid_.cell(cells[i]));
            liquid[i] = free[i] ? alpha_[grid_.cell(cells[i])] : 0;
            if (liquid[i] > 0)
            {
                e.cells[e.nCells++] = grid_.cell(cells[i]);
            }
        }
        if (!e.nCells)
        {
            return;
        }
        const double quarter = 0.25*grid_.volume();
        e.plane = plane;

        // Does the velocity normal to p, of the wall between the cells i0, i1
        // on its solid side and j0, j1 on its free side, shear
        const auto wall = [&]
        (
            const int p, const int q, const int j0, const int j1, const int side
        )
        {
            // Faces of the wall, normal to q, and the face in the melt
            int faces = 0;
            double velocity = 0;
            bool film = true;
            for (const int j : {j0, j1})
            {
                const triple beyond(shifted(cells[j], q, side));
                film = film
                 && grid_.inside(beyond)
                 && !grid_.blocked(grid_.cell(beyond))
                 && alpha_[grid_.cell(beyond)] == 0;
                const int face = grid_.face
                (
                    q, shifted(cells[j], q, side > 0 ? 0 : 1)
                );
                if (grid_.at(q, face) == staggeredGrid::condition::noSlip)
                {
                    e.weight += quarter*liquid[j];
                    velocity += grid_.wallVelocity(q, face, p);
                    ++faces;
                }
            }

            // A film within a cell has the drag of its parabolic profile
            const double thickness = 0.5*(liquid[j0] + liquid[j1]);
            const double length =
                side*grid_.d()[q]*(film ? thickness/3 : 0.5);
            if
            (
                faces
             && add(e, p, grid_.face(p, cells[j1]), 1/length)
             && e.n
            )
            {
                e.constant -= velocity/faces/length;
                elements_.push_back(e);
            }
        };

        const int nFree = free[0] + free[1] + free[2] + free[3];
        if (nFree == 2 && free[2] && free[3])
        {
            wall(a, b, 2, 3, 1);
        }
        else if (nFree == 2 && free[0] && free[1])
        {
            wall(a, b, 0, 1, -1);
        }
        else if (nFree == 2 && free[1] && free[3])
        {
            wall(b, a, 1, 3, 1);
        }
        else if (nFree == 2 && free[0] && free[2])
        {
            wall(b, a, 0, 2, -1);
        }
        else if (nFree > 2)
        {
            e.weight =
                quarter*(liquid[0] + liquid[1] + liquid[2] + liquid[3]);
            if
            (
                add(e, a, grid_.face(a, c), 1/db)
             && add(e, a, grid_.face(a, cells[1]), -1/db)
             && add(e, b, grid_.face(b, c), 1/da)
             && add(e, b, grid_.face(b, cells[2]), -1/da)
             && e.n
            )
            {
                elements_.push_back(e);
            }
        }
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::strainElements::strainElements
(
    const staggeredGrid& grid,
    const std::vector<double>& alpha,
    const double wetFrom
)
:
    grid_(grid),
    alpha_(alpha)
{
    for (int cell = 0; cell < grid_.nCells(); ++cell)
    {
        if (alpha_[cell] < wetFrom || grid_.blocked(cell))
        {
            alpha_[cell] = 0;
        }
    }
    number();
    addNormalRates();
    for (const int plane : {0, 1, 2})
    {
        addShearRates(plane);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<double>
Foam::melt::strainElements::shearRate(const double* u) const
{
    // Squares of each plane, a quarter from each edge, and of the normal rates
    std::vector<std::array<double, 4>> square(grid_.nCells(), {0, 0, 0, 0});
    std::vector<double> rates(elements_.size());
    for (std::size_t i = 0; i < elements_.size(); ++i)
    {
        const element& e = elements_[i];
        rates[i] = e.rate(u);
        for (int j = 0; j < e.nCells; ++j)
        {
            square[e.cells[j]][e.shear() ? e.plane : 3] +=
                rates[i]*rates[i]*(e.shear() ? 0.25 : 2);
        }
    }
    for (std::size_t i = 0; i < elements_.size(); ++i)
    {
        const element& e = elements_[i];
        double others = 0;
        for (int j = 0; j < e.nCells; ++j)
        {
            for (int k = 0; k < 4; ++k)
            {
                others += k == e.plane ? 0 : square[e.cells[j]][k];
            }
        }
        const double own = e.shear() ? rates[i]*rates[i] : 0;
        rates[i] = std::sqrt(own + others/e.nCells);
    }
    return rates;
}

// ************************************************************************* //
