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
    // Least distance of particles of different walls, in spacings
    constexpr scalar leastDistance = 0.5;

    // By how much an edge's particle may be nearer to another wall, in
    // spacings: the edge of a curved wall is a polygon
    constexpr scalar ownTolerance = 0.1;

    // Cosine between the normals of two walls up to which sites in equal steps
    // of both depths make a good lattice; beyond, they go on arcs
    constexpr scalar obliqueCosine = 0.5;


    // Position behind an edge, relative to it, and volume per edge length
    struct offset
    {
        vector position;
        scalar area;
    };


    // At every pair of depths behind both walls; n are the normals
    std::vector<offset> latticeBehind
    (
        const wallParticleBuilder& builder,
        const vector& n0,
        const vector& n1
    )
    {
        const scalar c = n0 & n1;
        const scalar area = sqr(builder.spacing())/std::sqrt(1 - sqr(c));
        std::vector<offset> offsets;

        for (label i = 0; i < builder.nLayers(); ++i)
        for (label j = 0; j < builder.nLayers(); ++j)
        {
            const scalar d0 = builder.depth(i);
            const scalar d1 = builder.depth(j);
            const vector p
            (
                -(n0*(d0 - c*d1) + n1*(d1 - c*d0))/(1 - sqr(c))
            );

            if (mag(p) < builder.supportRadius())
            {
                offsets.push_back({p, area});
            }
        }

        return offsets;
    }


    // On arcs around the edge from one normal to the other
    std::vector<offset> arcsBehind
    (
        const wallParticleBuilder& builder,
        const vector& n0,
        const vector& n1
    )
    {
        const scalar angle = std::acos(min(max(n0 & n1, -1.0), 1.0));
        const vector tangent(normalised(n1 - n0*(n0 & n1)));
        std::vector<offset> offsets;

        for (label layer = 0; layer < builder.nLayers(); ++layer)
        {
            const scalar radius = builder.depth(layer);
            const scalar length = angle*radius;
            const label n = label(std::round(length/builder.spacing()));

            for (label i = 0; i < n; ++i)
            {
                const scalar phi = (i + 0.5)*angle/n;
                offsets.push_back
                ({
                    -radius*(n0*std::cos(phi) + tangent*std::sin(phi)),
                    builder.spacing()*length/n
                });
            }
        }

        return offsets;
    }


    // Add a particle with the plane, of the walls through `origin`, that it
    // is farthest behind
    template<class Faces>
    void addBehind
    (
        wallParticleBuilder& builder,
        const point& origin,
        const vector& position,
        const Faces& faces,
        const scalar volume
    )
    {
        const wallSurface& surface = builder.surface();
        const point p(origin + position);

        label farthest = -1;
        scalar depth = -GREAT;
        for (const label facei : faces)
        {
            // Equal but for round-off: the first of them
            const scalar d = -(surface.normal(facei) & position);
            if (d > depth + leastDistance*builder.spacing())
            {
                depth = d;
                farthest = facei;
            }
        }

        if
        (
            builder.wanted(p)
         && builder.ownedAt(p, mag(position) - ownTolerance*builder.spacing())
        )
        {
            const vector n(surface.normal(farthest));
            wallParticleBuilder::site s{p, n, n & origin, volume, farthest};
            label others = 0;
            for (const label facei : faces)
            {
                if (facei != farthest)
                {
                    s.otherFaces[others++] = facei;
                }
            }
            builder.add(s, leastDistance*builder.spacing());
        }
    }
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::addConvexWallEdges(wallParticleBuilder& builder)
{
    const wallSurface& surface = builder.surface();

    for (const wallSurface::edgeChain& chain : surface.convexEdges())
    {
        scalarField ends(chain.points.size(), Zero);
        for (label i = 1; i < ends.size(); ++i)
        {
            ends[i] = ends[i-1] + mag(chain.points[i] - chain.points[i-1]);
        }

        const label n = builder.nFitting(ends.last());
        const scalar step = ends.last()/n;
        label edgei = 0;

        for (label i = 0; i < n; ++i)
        {
            const scalar s = (i + 0.5)*step;
            while (edgei < chain.faces.size() - 1 && s > ends[edgei + 1])
            {
                ++edgei;
            }

            const vector edge(chain.points[edgei + 1] - chain.points[edgei]);
            const point origin
            (
                chain.points[edgei]
              + edge*((s - ends[edgei])/(ends[edgei + 1] - ends[edgei]))
            );

            const labelPair& faces = chain.faces[edgei];
            const vector n0(surface.normal(faces.first()));
            const vector n1(surface.normal(faces.second()));

            const std::vector<offset> offsets
            (
                mag(n0 & n1) < obliqueCosine
              ? latticeBehind(builder, n0, n1)
              : arcsBehind(builder, n0, n1)
            );

            for (const offset& o : offsets)
            {
                addBehind(builder, origin, o.position, faces, o.area*step);
            }
        }
    }
}


void Foam::melt::addConvexWallCorners(wallParticleBuilder& builder)
{
    const wallSurface& surface = builder.surface();

    for (const wallSurface::corner& corner : surface.convexCorners())
    {
        const tensor normals
        (
            surface.normal(corner.faces[0]),
            surface.normal(corner.faces[1]),
            surface.normal(corner.faces[2])
        );
        const scalar determinant = mag(det(normals));

        if (determinant < obliqueCosine)
        {
            continue;
        }

        const tensor position(inv(normals));
        const scalar volume = pow3(builder.spacing())/determinant;

        for (label i = 0; i < builder.nLayers(); ++i)
        for (label j = 0; j < builder.nLayers(); ++j)
        for (label k = 0; k < builder.nLayers(); ++k)
        {
            const vector depths
            (
                builder.depth(i),
                builder.depth(j),
                builder.depth(k)
            );
            const vector p(-(position & depths));

            if (mag(p) < builder.supportRadius())
            {
                addBehind(builder, corner.position, p, corner.faces, volume);
            }
        }
    }
}


// ************************************************************************* //
