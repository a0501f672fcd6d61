/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceSlope.H"
#include "surfaceEdge.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Cells to either side in which a line of them ends at the surface
const int reach = 3;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double Foam::melt::surfaceSlope::melt
(
    const direction axis,
    const int step,
    const direction other,
    const int across
) const
{
    staggeredGrid::triple there(c_);
    there[axis] += step;
    there[other] += across;
    return grid_.inside(there) ? alpha_[grid_.cell(there)] : 0;
}


double Foam::melt::surfaceSlope::depth
(
    const direction axis,
    const int side,
    const direction other,
    const int across
) const
{
    double result = melt(axis, 0, other, across);
    for (int step = 1; result < 1; ++step)
    {
        const double behind = melt(axis, -step*side, other, across);
        if (behind <= result)
        {
            break;
        }
        result = behind;
    }
    return result;
}


double Foam::melt::surfaceSlope::height
(
    const direction axis,
    const direction other,
    const int across
) const
{
    double sum = 0;
    for (int step = -reach; step <= reach; ++step)
    {
        sum += melt(axis, step, other, across);
    }
    return sum;
}


double Foam::melt::surfaceSlope::across
(
    const direction axis,
    const vector& free,
    const direction other,
    const vector& sum
) const
{
    const int side = free[axis] > 0 ? 1 : -1;
    const int down = sum[other] > 0 ? 1 : -1;

    // The outermost of the lines of cells, this one or the next, is partly
    // filled all the way: the edge is in it
    const bool last = melt(axis, 0, other, down) == 0;
    const double outer = depth(axis, side, other, last ? 0 : down);
    const double inner = depth(axis, side, other, last ? -down : 0);

    // Rounding of the fractions beside each other on a flat side
    const double same = 0.99;
    if (outer < same*inner)
    {
        const double slope =
            height(axis, other, -down)
          - height(axis, other, 0)/(last ? outer/inner : 1);
        return
            down*min(mag(sum[other]), max(slope, scalar(0))*mag(free[axis]));
    }
    return
        sum[other]
       *(
            1 - edgeSharpness
            (
                alpha_[grid_.cell(c_)],
                melt(axis, side, other, -down),
                melt(axis, -side, other, down)
            )
        );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::surfaceSlope::surfaceSlope
(
    const staggeredGrid& grid,
    const std::vector<double>& alpha,
    const label cell
)
:
    grid_(grid),
    alpha_(alpha),
    c_(grid.position(cell))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::melt::surfaceSlope::at
(
    const vector& free,
    const vector& sum
) const
{
    direction axis = 0;
    while (free[axis] == 0)
    {
        ++axis;
    }
    vector result(free);
    for (direction other = 0; other < 3; ++other)
    {
        if (other != axis && sum[other] != 0)
        {
            result[other] = across(axis, free, other, sum);
        }
    }
    return result;
}

// ************************************************************************* //
