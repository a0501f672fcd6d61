/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shapeVoxels.H"
#include "cutCells.H"
#include "DynamicList.H"

#include <algorithm>
#include <cstdlib>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::shapeVoxels::cut(const std::array<int, 3>& v) const
{
    for (int k = 0; k < 3; ++k)
    {
        if (v[k] < low_[k] || v[k] + 1 > high_[k])
        {
            return true;
        }
    }
    const bool centre = inside(v[0], v[1], v[2]);
    for (int i = 0; i < 27; ++i)
    {
        if
        (
            inside(v[0] + i/9 - 1, v[1] + i/3 % 3 - 1, v[2] + i % 3 - 1)
         != centre
        )
        {
            return true;
        }
    }
    return false;
}


std::vector<int>
Foam::melt::shapeVoxels::axes(const std::array<int, 3>& v) const
{
    std::array<int, 3> n{0, 0, 0};
    for (int i = 0; i < 27; ++i)
    {
        const std::array<int, 3> d{i/9 - 1, i/3 % 3 - 1, i % 3 - 1};
        if (inside(v[0] + d[0], v[1] + d[1], v[2] + d[2]))
        {
            // Across faces, edges, corners: 4, 2, 1
            const int weight = 8 >> (d[0]*d[0] + d[1]*d[1] + d[2]*d[2]);
            for (int k = 0; k < 3; ++k)
            {
                n[k] += weight*d[k];
            }
        }
    }
    int largest = 0;
    for (int& component : n)
    {
        component = std::abs(component);
        largest = std::max(largest, component);
    }
    std::vector<int> result;
    for (int k = 0; k < 3; ++k)
    {
        if (n[k] == largest)
        {
            result.push_back(k);
        }
    }
    return result;
}


void Foam::melt::shapeVoxels::findPlane(const int x)
{
    // Of cut voxels: their place among the filled ones, centre and axis, as
    // often as there are axes
    std::vector<std::size_t> places;
    DynamicList<point> centres;
    DynamicList<label> along;
    std::vector<double> weights;
    for (int y = first_[1] + 1; y < first_[1] + size_[1] - 1; ++y)
    {
        for (int z = first_[2] + 1; z < first_[2] + size_[2] - 1; ++z)
        {
            const std::array<int, 3> v{x, y, z};
            if (cut(v))
            {
                const std::vector<int> axes(this->axes(v));
                for (const int axis : axes)
                {
                    places.push_back(filled_.size());
                    weights.push_back(1.0/axes.size());
                    centres.append(frame_.position(x + 0.5, y + 0.5, z + 0.5));
                    along.append(frame_.component(axis));
                }
                filled_.push_back({v, 0});
            }
            else if (inside(x, y, z))
            {
                filled_.push_back({v, 1});
            }
        }
    }

    const scalarField shares
    (
        cutCells::shares
        (
            body_,
            pointField(centres),
            labelList(along),
            frame_.dx()*vector::one
        )
    );
    forAll(shares, i)
    {
        filled_[places[i]].share += weights[i]*shares[i];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::shapeVoxels::shapeVoxels
(
    const shape& body,
    const voxelFrame& frame
)
:
    body_(body),
    frame_(frame)
{
    const boundBox bounds(body.bounds());
    low_ = frame.coordinates(bounds.min());
    high_ = frame.coordinates(bounds.max());
    std::array<int, 3> end;
    frame.range(bounds, first_, end);
    for (int k = 0; k < 3; ++k)
    {
        if (low_[k] > high_[k])
        {
            std::swap(low_[k], high_[k]);
        }
        --first_[k];
        size_[k] = end[k] + 1 - first_[k];
    }

    pointField centres(size_[0]*size_[1]*size_[2]);
    forAll(centres, i)
    {
        centres[i] = frame.position
        (
            first_[0] + i/(size_[1]*size_[2]) + 0.5,
            first_[1] + i/size_[2] % size_[1] + 0.5,
            first_[2] + i % size_[2] + 0.5
        );
    }
    inside_ = body.inside(centres);

    for (int x = first_[0] + 1; x < first_[0] + size_[0] - 1; ++x)
    {
        findPlane(x);
    }
    filled_.erase
    (
        std::remove_if
        (
            filled_.begin(),
            filled_.end(),
            [](const filledVoxel& voxel) { return voxel.share == 0; }
        ),
        filled_.end()
    );
}

// ************************************************************************* //
