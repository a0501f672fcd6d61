/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "curvedWallLayer.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <deque>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{
    // Least distance of two particles of a layer, in spacings
    constexpr double leastDistance = 0.7;

    // By how much a particle may be nearer to the wall than its layer, and how
    // near a foot point is to p where it gives no direction, in spacings
    constexpr double tolerance = 0.1;

    // Distance from an edge at which a foot point is on it, in spacings
    constexpr double edgeTolerance = 1e-6;

    // Sine of the angle to the axis of a wall below which it gives no direction
    constexpr double parallelSine = 0.1;

    // Halvings that find where a way ends, to a thousandth of a step
    constexpr int nHalvings = 10;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::curvedWallLayer::tangents
(
    const vector& n,
    vector& along,
    vector& around
) const
{
    along = axis_ - n*(axis_ & n);
    if (mag(along) < parallelSine)
    {
        const vector other
        (
            mag(n.x()) < mag(n.y()) ? vector(1, 0, 0) : vector(0, 1, 0)
        );
        along = other - n*(other & n);
    }
    along /= mag(along);
    around = n ^ along;
}


bool Foam::melt::curvedWallLayer::project(const point& p, site& s) const
{
    const wallSurface::foot foot(surface_.nearest(p));
    const scalar spacing = builder_.spacing();

    if
    (
        surface_.groupOf(foot.face) != groupi_
     || surface_.atSharpEdge(foot.face, foot.position, edgeTolerance*spacing)
    )
    {
        return false;
    }

    vector n(surface_.normal(foot.face));
    if (foot.distance > tolerance*spacing)
    {
        const vector direction((p - foot.position)/foot.distance);
        n = (direction & n) > 0 ? direction : -direction;
    }

    s.position = foot.position - depth_*n;
    s.normal = n;
    s.offset = n & foot.position;
    s.face = foot.face;
    s.volume = alongStep_*aroundStep_*spacing;

    return builder_.ownedAt(s.position, depth_ - tolerance*spacing);
}


bool Foam::melt::curvedWallLayer::seed(const label facei, site& s) const
{
    const label meshFace = surface_.meshFace(facei);
    const point& centre = surface_.mesh().faceCentres()[meshFace];
    const vector n(surface_.normal(facei));

    const scalar steps = ((centre & axis_) - start_)/alongStep_;
    const scalar shift = std::floor(steps) + 0.5 - steps;

    vector along, around;
    tangents(n, along, around);

    return project(centre - depth_*n + shift*alongStep_*along, s);
}


Foam::melt::curvedWallLayer::way Foam::melt::curvedWallLayer::wayAround
(
    const site& first,
    const scalar sign
) const
{
    // Not longer than the way around a sphere around the mesh
    const scalar step = builder_.spacing();
    const label nMost = label
    (
        constant::mathematical::pi*surface_.mesh().bounds().mag()/step
    );

    site s(first);
    site next(first);
    vector along, around;

    for (label n = 0; n < nMost; ++n)
    {
        tangents(s.normal, along, around);
        around *= sign;

        const vector toFirst(first.position - s.position);
        if
        (
            n > 1
         && mag(toFirst) < (1 + tolerance)*step
         && (toFirst & around) > 0
        )
        {
            return {n*step + mag(toFirst), true};
        }

        if (!project(s.position + step*around, next))
        {
            scalar reached = 0;
            scalar part = 0.5;
            for (int i = 0; i < nHalvings; ++i, part /= 2)
            {
                if (project(s.position + (reached + part)*step*around, next))
                {
                    reached += part;
                }
            }
            return {(n + reached)*step, false};
        }
        s = next;
    }

    // A spiral: no way to fit a step to
    return {0, true};
}


void Foam::melt::curvedWallLayer::fit(site& first)
{
    const way forward(wayAround(first, 1));

    if (forward.closed)
    {
        if (forward.length > 0)
        {
            aroundStep_ = forward.length/builder_.nFitting(forward.length);
        }
        project(first.position, first);
        return;
    }

    const way backward(wayAround(first, -1));
    const scalar length = forward.length + backward.length;
    aroundStep_ = length/builder_.nFitting(length);

    const scalar steps = backward.length/aroundStep_;
    const scalar shift = std::floor(steps) + 0.5 - steps;

    vector along, around;
    tangents(first.normal, along, around);
    site shifted;
    project(first.position, first);
    if (project(first.position + shift*aroundStep_*around, shifted))
    {
        first = shifted;
    }
}


void Foam::melt::curvedWallLayer::spreadFrom(const site& first)
{
    const scalar least = leastDistance*builder_.spacing();
    std::deque<site> front;

    if (builder_.add(first, least))
    {
        front.push_back(first);
    }

    while (!front.empty())
    {
        const site from(front.front());
        front.pop_front();

        vector along, around;
        tangents(from.normal, along, around);

        const vector steps[] =
        {
            alongStep_*along, -alongStep_*along,
            aroundStep_*around, -aroundStep_*around
        };

        for (const vector& step : steps)
        {
            site s;
            if (project(from.position + step, s) && builder_.add(s, least))
            {
                front.push_back(s);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::curvedWallLayer::curvedWallLayer
(
    wallParticleBuilder& builder,
    const label groupi,
    const label layer,
    const vector& axis,
    const scalar start,
    const scalar alongStep
)
:
    builder_(builder),
    surface_(builder.surface()),
    groupi_(groupi),
    depth_(builder.depth(layer)),
    axis_(axis),
    start_(start),
    alongStep_(alongStep),
    aroundStep_(builder.spacing())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::curvedWallLayer::fill()
{
    bool fitted = false;

    // The first seed reaches all but what the region or other walls cut off
    for (const label facei : surface_.groups()[groupi_].faces)
    {
        site s;
        if (seed(facei, s))
        {
            if (!fitted)
            {
                fit(s);
                fitted = true;
            }
            spreadFrom(s);
        }
    }
}


// ************************************************************************* //
