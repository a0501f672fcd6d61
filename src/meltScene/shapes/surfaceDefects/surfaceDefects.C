/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceDefects.H"
#include "DynamicList.H"
#include "Map.H"
#include "triSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

//- Number of connected sets of these edges
static label nConnectedSets(const UList<edge>& edges)
{
    Map<DynamicList<label>> neighbours;
    for (const edge& e : edges)
    {
        neighbours(e.first()).append(e.second());
        neighbours(e.second()).append(e.first());
    }

    label nSets = 0;
    labelHashSet visited;
    DynamicList<label> front;
    for (const edge& e : edges)
    {
        if (visited.insert(e.first()))
        {
            ++nSets;
            front.append(e.first());
        }

        while (front.size())
        {
            for (const label pointi : neighbours[front.remove()])
            {
                if (visited.insert(pointi))
                {
                    front.append(pointi);
                }
            }
        }
    }

    return nSets;
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::surfaceDefects::surfaceDefects(const triSurface& surface)
:
    nOpenEdges_(0),
    nHoles_(0),
    nTurnedEdges_(0)
{
    const edgeList& edges = surface.edges();
    const labelListList& edgeFaces = surface.edgeFaces();
    DynamicList<edge> openEdges;

    forAll(edges, edgei)
    {
        label balance = 0;
        for (const label facei : edgeFaces[edgei])
        {
            balance += surface.localFaces()[facei].edgeDirection(edges[edgei]);
        }

        if (edgeFaces[edgei].size() == 1)
        {
            openEdges.append(edges[edgei]);
        }
        else if (balance != 0)
        {
            ++nTurnedEdges_;
        }
    }

    nOpenEdges_ = openEdges.size();
    nHoles_ = nConnectedSets(openEdges);
}


// ************************************************************************* //
