/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

namespace
{
    const scalar featureAngle = degToRad(30.0);

    // Deviation of a plane group's points from its mean plane, relative to
    // the group's size: the accuracy of meshes in ascii files
    constexpr scalar planeTolerance = 1e-5;

    // Relative inflation of the bounds of the search tree, as in meshSearch
    constexpr scalar boundsMargin = 1e-4;


    labelList facesOf(const polyMesh& mesh, const labelUList& patches)
    {
        DynamicList<label> faces;

        for (const label patchi : patches)
        {
            const polyPatch& patch = mesh.boundaryMesh()[patchi];
            faces.append(identity(patch.size(), patch.start()));
        }

        return labelList(faces);
    }


    treeBoundBox boundsOf(const polyMesh& mesh)
    {
        treeBoundBox bounds(mesh.points());
        bounds.inflate(boundsMargin);
        return bounds;
    }
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::wallSurface::findSharpEdges()
{
    const labelListList& edgeFaces = patch_.edgeFaces();
    sharp_.setSize(edgeFaces.size());
    onSharpEdge_.setSize(patch_.nPoints(), false);

    forAll(edgeFaces, edgei)
    {
        const labelList& faces = edgeFaces[edgei];

        sharp_[edgei] =
            faces.size() != 2
         || (normals_[faces[0]] & normals_[faces[1]]) < Foam::cos(featureAngle);

        if (sharp_[edgei])
        {
            onSharpEdge_[patch_.edges()[edgei].first()] = true;
            onSharpEdge_[patch_.edges()[edgei].second()] = true;
        }
    }
}


void Foam::melt::wallSurface::findGroups()
{
    groupOfFace_.setSize(patch_.size(), -1);

    forAll(groupOfFace_, seed)
    {
        if (groupOfFace_[seed] >= 0)
        {
            continue;
        }

        const label groupi = groups_.size();
        DynamicList<label> faces;
        faces.append(seed);
        groupOfFace_[seed] = groupi;

        for (label next = 0; next < faces.size(); ++next)
        {
            for (const label edgei : patch_.faceEdges()[faces[next]])
            {
                if (sharp_[edgei])
                {
                    continue;
                }
                for (const label facei : patch_.edgeFaces()[edgei])
                {
                    if (groupOfFace_[facei] < 0)
                    {
                        groupOfFace_[facei] = groupi;
                        faces.append(facei);
                    }
                }
            }
        }

        group g;
        g.faces = faces;
        sort(g.faces);

        vector area = Zero;
        boundBox bounds;
        for (const label facei : g.faces)
        {
            area -= mesh_.faceAreas()[meshFaces_[facei]];
            bounds.add(patch_.points(), patch_[facei]);
        }
        const bool flat = mag(area) > VSMALL;
        g.normal = flat ? area/mag(area) : normals_[seed];

        // The plane through the middle of the points
        scalar low = GREAT;
        scalar high = -GREAT;
        for (const label facei : g.faces)
        {
            for (const label pointi : patch_[facei])
            {
                const scalar height = g.normal & patch_.points()[pointi];
                low = min(low, height);
                high = max(high, height);
            }
        }
        g.offset = (low + high)/2;
        g.plane = flat && (high - low) < planeTolerance*bounds.mag();

        groups_.push_back(std::move(g));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::wallSurface::wallSurface
(
    const polyMesh& mesh,
    const labelUList& patches
)
:
    mesh_(mesh),
    meshFaces_(facesOf(mesh, patches)),
    patch_(IndirectList<face>(mesh.faces(), meshFaces_), mesh.points()),
    tree_
    (
        treeDataFace(true, mesh, meshFaces_),
        boundsOf(mesh),
        8,      // levels, leaf size, duplicity: as meshSearch has them
        10,
        3.0
    ),
    normals_(meshFaces_.size())
{
    forAll(normals_, facei)
    {
        const vector& area = mesh.faceAreas()[meshFaces_[facei]];
        normals_[facei] = -area/max(mag(area), VSMALL);
    }

    findSharpEdges();
    findGroups();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::melt::wallSurface::normal(const label facei) const
{
    const group& g = groups_[groupOfFace_[facei]];

    return g.plane ? g.normal : normals_[facei];
}


Foam::melt::wallSurface::foot Foam::melt::wallSurface::nearest
(
    const point& p
) const
{
    const pointIndexHit hit(tree_.findNearest(p, VGREAT));

    return {hit.hitPoint(), hit.index(), mag(hit.hitPoint() - p)};
}


bool Foam::melt::wallSurface::atSharpEdge
(
    const label facei,
    const point& p,
    const scalar tolerance
) const
{
    const pointField& points = patch_.localPoints();

    for (const label edgei : patch_.faceEdges()[facei])
    {
        if
        (
            sharp_[edgei]
         && patch_.edges()[edgei].line(points).nearestDist(p).distance()
          < tolerance
        )
        {
            return true;
        }
    }

    for (const label pointi : patch_.localFaces()[facei])
    {
        if (onSharpEdge_[pointi] && mag(points[pointi] - p) < tolerance)
        {
            return true;
        }
    }

    return false;
}


// ************************************************************************* //
