/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceDistance.H"
#include "triSurfaceSearch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Distances [m] from points to a surface
Foam::scalarField distances
(
    const Foam::pointField& points,
    const Foam::triSurface& surface
)
{
    using namespace Foam;

    const triSurfaceSearch search(surface);
    List<pointIndexHit> nearest;
    search.findNearest(points, scalarField(points.size(), GREAT), nearest);

    scalarField distance(points.size());
    forAll(points, i)
    {
        distance[i] = mag(nearest[i].rawPoint() - points[i]);
    }
    return distance;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::surfaceDistance::surfaceDistance
(
    const triSurface& a,
    const triSurface& b
)
{
    if (a.empty() || b.empty())
    {
        mean = Hausdorff = a.empty() && b.empty() ? 0 : GREAT;
        return;
    }

    const scalarField ab(distances(a.points(), b));
    const scalarField ba(distances(b.points(), a));
    mean = 0.5*(average(ab) + average(ba));
    Hausdorff = Foam::max(Foam::max(ab), Foam::max(ba));
}


// ************************************************************************* //
