/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shapeTestTools.H"
#include "edgeHashes.H"
#include "meltUnitTests.H"
#include "OSspecific.H"
#include "Random.H"

#include <fstream>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

Foam::dictionary Foam::melt::unitTest::dictOf(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


Foam::autoPtr<Foam::melt::shape>
Foam::melt::unitTest::shapeOf(const std::string& text)
{
    return shape::New("body", dictOf(text), runTime().globalPath());
}


Foam::triSurface Foam::melt::unitTest::sphereSurface(const label level)
{
    DynamicList<point> points
    ({
        point(1, 0, 0), point(-1, 0, 0),
        point(0, 1, 0), point(0, -1, 0),
        point(0, 0, 1), point(0, 0, -1)
    });
    List<labelledTri> triangles
    ({
        labelledTri(0, 2, 4, 0), labelledTri(2, 1, 4, 0),
        labelledTri(1, 3, 4, 0), labelledTri(3, 0, 4, 0),
        labelledTri(2, 0, 5, 0), labelledTri(1, 2, 5, 0),
        labelledTri(3, 1, 5, 0), labelledTri(0, 3, 5, 0)
    });

    for (label i = 0; i < level; ++i)
    {
        EdgeMap<label> middles;
        const auto middle = [&](const label a, const label b)
        {
            const edge e(a, b);
            if (!middles.found(e))
            {
                const point sum(points[a] + points[b]);
                middles.insert(e, points.size());
                points.append(sum/mag(sum));
            }
            return middles[e];
        };

        DynamicList<labelledTri> finer(4*triangles.size());
        for (const labelledTri& t : triangles)
        {
            const label ab = middle(t[0], t[1]);
            const label bc = middle(t[1], t[2]);
            const label ca = middle(t[2], t[0]);
            finer.append(labelledTri(t[0], ab, ca, 0));
            finer.append(labelledTri(t[1], bc, ab, 0));
            finer.append(labelledTri(t[2], ca, bc, 0));
            finer.append(labelledTri(ab, bc, ca, 0));
        }
        triangles = finer;
    }

    return triSurface(triangles, pointField(points));
}


Foam::fileName Foam::melt::unitTest::geometryDirectory()
{
    return runTime().globalPath()/"constant/geometry";
}


void Foam::melt::unitTest::writeGeometry
(
    const triSurface& surface,
    const fileName& name
)
{
    mkDir(geometryDirectory());
    surface.write(geometryDirectory()/name);
}


Foam::fileName Foam::melt::unitTest::writeGeometry
(
    const std::string& text,
    const fileName& name
)
{
    mkDir(geometryDirectory());
    const fileName path(geometryDirectory()/name);
    std::ofstream(path.c_str()) << text;
    return path;
}


std::vector<Foam::melt::windingNumber::triangle>
Foam::melt::unitTest::trianglesOf(const triSurface& surface)
{
    const auto corner = [&](const label pointi)
    {
        const point& p = surface.points()[pointi];
        return windingNumber::vector(p.x(), p.y(), p.z());
    };

    std::vector<windingNumber::triangle> triangles;
    for (const labelledTri& t : surface)
    {
        triangles.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
    }
    return triangles;
}


Foam::pointField Foam::melt::unitTest::randomPoints
(
    const label n,
    const boundBox& box
)
{
    Random random(1);
    pointField points(n);
    for (point& p : points)
    {
        p = random.position(box.min(), box.max());
    }
    return points;
}


// ************************************************************************* //
