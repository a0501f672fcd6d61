/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallLayers.H"
#include "mathematicalConstants.H"
#include "symmTensor.H"
#include "tensor.H"

#include <cmath>
#include <deque>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

namespace
{
    // Least distance of two particles of a layer, in spacings: they are one
    // spacing apart but where the layer closes upon itself
    constexpr scalar leastDistance = 0.7;

    // By how much a particle may be nearer to the wall than its layer
    constexpr scalar ownTolerance = 0.1;

    // Distance from an edge at which a foot point is on it, in spacings
    constexpr scalar edgeTolerance = 1e-6;

    // Sine of the angle to the axis of a wall below which it gives no direction
    constexpr scalar parallelSine = 0.1;


    // One layer behind a curved group of faces
    class curvedLayer
    {
        typedef wallParticleBuilder::site site;

        wallParticleBuilder& builder_;
        const wallSurface& surface_;
        const label groupi_;
        const scalar depth_;

        // Direction in which the wall is curved least, and where it begins
        const vector axis_;
        const scalar start_;

        // Steps along the axis and around it [m]
        const scalar alongStep_;
        scalar aroundStep_;


        // Move p to the layer along the normal
        bool project(const point& p, site& s) const
        {
            const wallSurface::foot foot(surface_.nearest(p));
            const scalar spacing = builder_.spacing();

            if
            (
                surface_.groupOf(foot.face) != groupi_
             || surface_.atSharpEdge
                (
                    foot.face,
                    foot.position,
                    edgeTolerance*spacing
                )
            )
            {
                return false;
            }

            vector n(surface_.normal(foot.face));
            if (foot.distance > ownTolerance*spacing)
            {
                const vector outward((p - foot.position)/foot.distance);
                n = (outward & n) > 0 ? outward : -outward;
            }

            s.position = foot.position - depth_*n;
            s.normal = n;
            s.offset = n & foot.position;
            s.face = foot.face;
            s.volume = alongStep_*aroundStep_*spacing;

            return builder_.ownedAt(s.position, depth_ - ownTolerance*spacing);
        }


        // Unit tangents along and around the axis
        static void tangents
        (
            const vector& n,
            const vector& axis,
            vector& along,
            vector& around
        )
        {
            along = axis - n*(axis & n);
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


        // Step around the axis that fits where the layer closes upon itself
        scalar closingStep(const site& first) const
        {
            const scalar spacing = builder_.spacing();
            site s(first);
            vector along, around;

            // Not longer than the way around a sphere around the mesh
            const label nMost = label
            (
                constant::mathematical::pi*surface_.mesh().bounds().mag()
               /spacing
            );

            for (label n = 1; n <= nMost; ++n)
            {
                tangents(s.normal, axis_, along, around);

                const vector toFirst(first.position - s.position);
                if
                (
                    n > 2
                 && mag(toFirst) < (1 + ownTolerance)*spacing
                 && (toFirst & around) > 0
                )
                {
                    const scalar length = (n - 1)*spacing + mag(toFirst);
                    return length/builder_.nFitting(length);
                }

                if (!project(s.position + spacing*around, s))
                {
                    break;
                }
            }

            return spacing;
        }


        // Site near a face's centre, at a half step along the axis
        bool seed(const label facei, site& s) const
        {
            const label meshFace = surface_.meshFace(facei);
            const point& centre = surface_.mesh().faceCentres()[meshFace];
            const vector n(surface_.normal(facei));

            const scalar steps = ((centre & axis_) - start_)/alongStep_;
            const scalar shift = std::floor(steps) + 0.5 - steps;

            vector along, around;
            tangents(n, axis_, along, around);

            return project
            (
                centre - depth_*n + shift*alongStep_*along,
                s
            );
        }


    public:

        curvedLayer
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


        void fill()
        {
            const scalar least = leastDistance*builder_.spacing();
            std::deque<site> front;
            bool first = true;

            for (const label facei : surface_.groups()[groupi_].faces)
            {
                site s;
                if (!seed(facei, s))
                {
                    continue;
                }
                if (first)
                {
                    aroundStep_ = closingStep(s);
                    first = false;
                    project(s.position, s);
                }
                if (builder_.add(s, least))
                {
                    front.push_back(s);
                }

                while (!front.empty())
                {
                    const site from(front.front());
                    front.pop_front();

                    vector along, around;
                    tangents(from.normal, axis_, along, around);

                    const vector steps[] =
                    {
                        alongStep_*along, -alongStep_*along,
                        aroundStep_*around, -aroundStep_*around
                    };

                    for (const vector& step : steps)
                    {
                        if
                        (
                            project(from.position + step, s)
                         && builder_.add(s, least)
                        )
                        {
                            front.push_back(s);
                        }
                    }
                }
            }
        }
    };


    // Direction in which the normals of the group vary least
    vector axisOf(const wallSurface& surface, const wallSurface::group& g)
    {
        symmTensor normals(Zero);

        for (const label facei : g.faces)
        {
            const vector& area =
                surface.mesh().faceAreas()[surface.meshFace(facei)];
            normals += sqr(area)/max(mag(area), VSMALL);
        }

        // Eigenvalues come in ascending order
        return eigenVectors(normals).x();
    }
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::addCurvedWallLayers
(
    wallParticleBuilder& builder,
    const label groupi
)
{
    const wallSurface& surface = builder.surface();
    const wallSurface::group& g = surface.groups()[groupi];
    const vector axis(axisOf(surface, g));

    scalar low = GREAT;
    scalar high = -GREAT;
    for (const label facei : g.faces)
    {
        for (const label pointi : surface.patch()[facei])
        {
            const scalar position = surface.patch().points()[pointi] & axis;
            low = min(low, position);
            high = max(high, position);
        }
    }

    const scalar step = (high - low)/builder.nFitting(high - low);

    for (label layer = 0; layer < builder.nLayers(); ++layer)
    {
        curvedLayer(builder, groupi, layer, axis, low, step).fill();
    }
}


// ************************************************************************* //
