/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"

#include <algorithm>
#include <map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::wallSurface::convex(const label edgei) const
{
    const labelList& faces = patch_.edgeFaces()[edgei];

    if (!sharp_[edgei] || faces.size() != 2)
    {
        return false;
    }

    const point middle(patch_.edges()[edgei].centre(patch_.localPoints()));
    const point centre(mesh_.faceCentres()[meshFaces_[faces[1]]]);

    return ((centre - middle) & normals_[faces[0]]) > 0;
}


Foam::labelPair Foam::melt::wallSurface::groupsOfEdge(const label edgei) const
{
    const labelList& faces = patch_.edgeFaces()[edgei];
    const label a = groupOfFace_[faces[0]];
    const label b = groupOfFace_[faces[1]];

    return labelPair(min(a, b), max(a, b));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<Foam::melt::wallSurface::edgeChain>
Foam::melt::wallSurface::convexEdges() const
{
    std::vector<edgeChain> chains;
    boolList done(patch_.nEdges(), false);

    // The edges of the same two groups at a point
    const auto edgesAt = [&](const label pointi, const labelPair& groups)
    {
        DynamicList<label> edges;
        for (const label edgei : patch_.pointEdges()[pointi])
        {
            if (convex(edgei) && groupsOfEdge(edgei) == groups)
            {
                edges.append(edgei);
            }
        }
        return labelList(edges);
    };

    const auto follow = [&](label edgei, label pointi)
    {
        const labelPair groups(groupsOfEdge(edgei));
        DynamicList<point> points;
        DynamicList<labelPair> faces;
        points.append(patch_.localPoints()[pointi]);

        while (!done[edgei])
        {
            done[edgei] = true;
            pointi = patch_.edges()[edgei].otherVertex(pointi);
            points.append(patch_.localPoints()[pointi]);

            const labelList& edgeFaces = patch_.edgeFaces()[edgei];
            labelPair pair(edgeFaces[0], edgeFaces[1]);
            if (groupOfFace_[pair.first()] != groups.first())
            {
                pair.flip();
            }
            faces.append(pair);

            const labelList edges(edgesAt(pointi, groups));
            if (edges.size() == 2)
            {
                edgei = (edges[0] == edgei) ? edges[1] : edges[0];
            }
        }

        chains.push_back({pointField(points), List<labelPair>(faces)});
    };

    // Chains with ends first, then closed ones
    for (const bool closed : {false, true})
    {
        forAll(patch_.edges(), edgei)
        {
            if (done[edgei] || !convex(edgei))
            {
                continue;
            }

            const edge& e = patch_.edges()[edgei];
            for (const label pointi : {e.first(), e.second()})
            {
                if
                (
                    !done[edgei]
                 && (
                        closed
                     || edgesAt(pointi, groupsOfEdge(edgei)).size() != 2
                    )
                )
                {
                    follow(edgei, pointi);
                }
            }
        }
    }

    return chains;
}


std::vector<Foam::melt::wallSurface::corner>
Foam::melt::wallSurface::convexCorners() const
{
    std::vector<corner> corners;

    forAll(patch_.localPoints(), pointi)
    {
        // A face of each group
        std::map<label, label> faceOfGroup;
        for (const label facei : patch_.pointFaces()[pointi])
        {
            faceOfGroup.insert({groupOfFace_[facei], facei});
        }

        const labelList& edges = patch_.pointEdges()[pointi];
        const label nConvex = std::count_if
        (
            edges.begin(),
            edges.end(),
            [&](const label edgei) { return convex(edgei); }
        );

        if (faceOfGroup.size() == 3 && nConvex == 3)
        {
            corner c;
            c.position = patch_.localPoints()[pointi];
            label i = 0;
            for (const auto& entry : faceOfGroup)
            {
                c.faces[i++] = entry.second;
            }
            corners.push_back(c);
        }
    }

    return corners;
}


// ************************************************************************* //
