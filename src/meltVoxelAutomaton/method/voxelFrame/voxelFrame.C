/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelFrame.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::voxelFrame::voxelFrame
(
    const boundBox& domain,
    const vector& g,
    const scalar dx
)
:
    dx_(dx)
{
    direction vertical = vector::Z;
    for (direction k = 0; k < 3; ++k)
    {
        if (mag(g[k]) > mag(g[vertical]))
        {
            vertical = k;
        }
    }
    if (mag(g) - mag(g[vertical]) > SMALL*mag(g))
    {
        FatalErrorInFunction
            << "Gravity in constant/g is " << g << nl
            << "Accepted by the method voxelAutomaton: a vector along an axis"
            << exit(FatalError);
    }
    axis_ =
    {
        direction((vertical + 1) % 3), direction((vertical + 2) % 3), vertical
    };
    up_ = g[vertical] > 0 ? -1 : 1;

    // The whole number of voxels that is nearest: a resolution that was rounded
    // down makes no layer beyond the domain
    for (int k = 0; k < 3; ++k)
    {
        const scalar length = domain.span()[axis_[k]];
        n_[k] = std::max(1, int(std::lround(length/dx)));
        origin_[axis_[k]] = domain.centre()[axis_[k]] - 0.5*n_[k]*dx;
    }
    origin_[vertical] =
        up_ > 0 ? domain.min()[vertical] : domain.max()[vertical];
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::melt::voxelFrame::size() const
{
    vector result;
    for (int k = 0; k < 3; ++k)
    {
        result[axis_[k]] = n_[k]*dx_;
    }
    return result;
}


Foam::point Foam::melt::voxelFrame::position
(
    const scalar x,
    const scalar y,
    const scalar z
) const
{
    point p(origin_);
    p[axis_[0]] += x*dx_;
    p[axis_[1]] += y*dx_;
    p[axis_[2]] += up_*z*dx_;
    return p;
}


std::array<double, 3>
Foam::melt::voxelFrame::coordinates(const point& p) const
{
    const vector d((p - origin_)/dx_);
    return {d[axis_[0]], d[axis_[1]], up_*d[axis_[2]]};
}


Foam::vector Foam::melt::voxelFrame::normal(const int side) const
{
    vector n(Zero);
    n[axis_[side/2]] = (side % 2 ? 1 : -1)*(side > 3 ? up_ : 1);
    return n;
}


void Foam::melt::voxelFrame::range
(
    const boundBox& box,
    std::array<int, 3>& begin,
    std::array<int, 3>& end
) const
{
    const std::array<double, 3> a = coordinates(box.min());
    const std::array<double, 3> b = coordinates(box.max());
    for (int k = 0; k < 3; ++k)
    {
        const double low = std::min(a[k], b[k]), high = std::max(a[k], b[k]);
        begin[k] = int(std::floor(std::clamp(low, 0.0, double(n_[k]))));
        end[k] = int(std::ceil(std::clamp(high, 0.0, double(n_[k]))));
    }
}

// ************************************************************************* //
