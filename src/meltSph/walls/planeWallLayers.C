/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallLayers.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

namespace
{
    // Part of a rectangle's area that may miss for it to be one
    constexpr scalar areaTolerance = 1e-4;

    // Distance of a foot point from the wall's faces, in spacings: the mean
    // plane is not exactly theirs
    constexpr scalar footTolerance = 1e-3;

    // Least distance of particles of different walls, in spacings
    constexpr scalar leastDistance = 0.5;


    // Sites along one direction of the plane
    struct lattice
    {
        vector direction;

        // Where the first cell begins, and the width of cells [m]
        scalar start;
        scalar step;

        // First and last cell
        label first;
        label last;

        scalar site(const label i) const
        {
            return start + (i + 0.5)*step;
        }
    };


    struct interval
    {
        scalar low = GREAT;
        scalar high = -GREAT;

        void add(const scalar value)
        {
            low = min(low, value);
            high = max(high, value);
        }
    };


    interval extent
    (
        const wallSurface& surface,
        const wallSurface::group& g,
        const vector& direction
    )
    {
        interval result;

        for (const label facei : g.faces)
        {
            for (const label pointi : surface.patch()[facei])
            {
                result.add(surface.patch().points()[pointi] & direction);
            }
        }

        return result;
    }


    // Longest edge that only one face of the group has
    edge longestOuterEdge
    (
        const wallSurface& surface,
        const wallSurface::group& g
    )
    {
        const indirectPrimitivePatch& patch = surface.patch();
        const label groupi = surface.groupOf(g.faces[0]);
        scalar longest = -1;
        edge result;

        for (const label facei : g.faces)
        {
            for (const label edgei : patch.faceEdges()[facei])
            {
                label nFaces = 0;
                for (const label other : patch.edgeFaces()[edgei])
                {
                    nFaces += (surface.groupOf(other) == groupi);
                }

                const edge& e = patch.edges()[edgei];
                const scalar length = e.mag(patch.localPoints());

                // Equal but for round-off: the first of them
                if (nFaces == 1 && length > longest*(1 + footTolerance))
                {
                    longest = length;
                    result = e;
                }
            }
        }

        return result;
    }


    scalar areaOf(const wallSurface& surface, const wallSurface::group& g)
    {
        scalar area = 0;
        for (const label facei : g.faces)
        {
            area += mag(surface.mesh().faceAreas()[surface.meshFace(facei)]);
        }
        return area;
    }


    lattice latticeAlong
    (
        const wallParticleBuilder& builder,
        const vector& direction,
        const interval& sides,
        const bool fit
    )
    {
        const scalar length = sides.high - sides.low;

        lattice result;
        result.direction = direction;
        result.start = sides.low;
        result.step =
            fit ? length/builder.nFitting(length) : builder.spacing();

        // Cells of the whole wall, of which those near the region
        const boundBox& region = builder.region();
        const scalar middle = region.midpoint() & direction;
        const scalar reach =
            (cmptMag(direction) & region.span())/2 + builder.supportRadius();

        const scalar low = max(sides.low, middle - reach);
        const scalar high = min(sides.high, middle + reach);

        result.first = label(std::floor((low - sides.low)/result.step));
        result.last = min
        (
            label(std::ceil((high - sides.low)/result.step)),
            label(std::ceil(length/result.step - footTolerance))
        ) - 1;

        return result;
    }
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::addPlaneWallLayers
(
    wallParticleBuilder& builder,
    const label groupi
)
{
    const wallSurface& surface = builder.surface();
    const wallSurface::group& g = surface.groups()[groupi];
    const vector& n = g.normal;

    const edge side(longestOuterEdge(surface, g));
    vector along(side.vec(surface.patch().localPoints()));
    along -= n*(n & along);
    along /= mag(along);
    const vector across(n ^ along);

    const interval a(extent(surface, g, along));
    const interval b(extent(surface, g, across));
    const bool rectangle =
        areaOf(surface, g)
      > (1 - areaTolerance)*(a.high - a.low)*(b.high - b.low);

    const lattice i(latticeAlong(builder, along, a, rectangle));
    const lattice j(latticeAlong(builder, across, b, rectangle));

    const scalar tolerance = footTolerance*builder.spacing();
    const scalar least = leastDistance*builder.spacing();
    const scalar volume = i.step*j.step*builder.spacing();

    for (label jj = j.first; jj <= j.last; ++jj)
    for (label ii = i.first; ii <= i.last; ++ii)
    {
        const point inPlane(i.site(ii)*along + j.site(jj)*across);
        const wallSurface::foot foot
        (
            surface.nearest(inPlane + g.offset*n)
        );

        if (foot.distance > tolerance || surface.groupOf(foot.face) != groupi)
        {
            continue;
        }

        for (label layer = 0; layer < builder.nLayers(); ++layer)
        {
            const scalar depth = builder.depth(layer);
            const point p(inPlane + (g.offset - depth)*n);

            if (builder.wanted(p) && builder.ownedAt(p, depth - tolerance))
            {
                builder.add({p, n, g.offset, volume, foot.face}, least);
            }
        }
    }
}


// ************************************************************************* //
