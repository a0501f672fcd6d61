/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "triangleMesh.H"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

struct vec
{
    double x, y, z;
};

vec cross(const vec& a, const vec& b)
{
    return {a.y*b.z - a.z*b.y, a.z*b.x - a.x*b.z, a.x*b.y - a.y*b.x};
}

double dot(const vec& a, const vec& b)
{
    return a.x*b.x + a.y*b.y + a.z*b.z;
}

vec point(const Foam::melt::triangleMesh& mesh, const std::size_t corner)
{
    const double* p = &mesh.points[3*mesh.triangles[corner]];
    return {p[0], p[1], p[2]};
}

vec edge(const vec& from, const vec& to)
{
    return {to.x - from.x, to.y - from.y, to.z - from.z};
}

}


double Foam::melt::triangleMesh::volume() const
{
    double sum = 0;
    if (triangles.empty())
    {
        return sum;
    }

    // Relative to a point of the surface: no cancellation far from the origin
    const vec o = point(*this, 0);
    for (std::size_t i = 0; i < triangles.size(); i += 3)
    {
        const vec a = edge(o, point(*this, i));
        const vec b = edge(o, point(*this, i + 1));
        const vec c = edge(o, point(*this, i + 2));
        sum += dot(a, cross(b, c));
    }
    return sum/6;
}


double Foam::melt::triangleMesh::area() const
{
    double sum = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 3)
    {
        const vec a = point(*this, i);
        const vec n = cross
        (
            edge(a, point(*this, i + 1)),
            edge(a, point(*this, i + 2))
        );
        sum += std::sqrt(dot(n, n));
    }
    return sum/2;
}


std::size_t Foam::melt::triangleMesh::nBadEdges() const
{
    // Edges as (smaller, larger) point with the direction of the walk
    using directedEdge = std::pair<std::pair<int, int>, int>;
    std::vector<directedEdge> edges;
    edges.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
        const int a = triangles[i];
        const int b = triangles[i % 3 == 2 ? i - 2 : i + 1];
        edges.push_back({std::minmax(a, b), a < b ? 1 : -1});
    }
    std::sort(edges.begin(), edges.end());

    std::size_t bad = 0;
    for (std::size_t first = 0, last; first < edges.size(); first = last)
    {
        int sum = 0;
        for
        (
            last = first;
            last < edges.size() && edges[last].first == edges[first].first;
            ++last
        )
        {
            sum += edges[last].second;
        }
        if (last - first != 2 || sum != 0)
        {
            ++bad;
        }
    }
    return bad;
}
