/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vdbSurface.H"

#include <openvdb/tools/VolumeToMesh.h>
#include <stdexcept>

openvdb::FloatGrid::Ptr Foam::melt::vdbGrid
(
    const std::array<double, 3>& origin,
    const double voxel
)
{
    openvdb::initialize();

    auto transform = openvdb::math::Transform::createLinearTransform(voxel);
    transform->postTranslate(openvdb::Vec3d(origin.data()));

    auto grid = openvdb::FloatGrid::create(0);
    grid->setTransform(transform);
    return grid;
}


Foam::melt::triangleMesh Foam::melt::vdbSurface
(
    const openvdb::FloatGrid& grid,
    const double level
)
{
    if (!(level > 0))
    {
        throw std::invalid_argument("vdbSurface: level must be positive");
    }

    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> triangles;
    std::vector<openvdb::Vec4I> quads;
    const double noAdaptivity = 0;
    openvdb::tools::volumeToMesh
    (
        grid, points, triangles, quads, level, noAdaptivity
    );

    triangleMesh mesh;
    mesh.points.reserve(3*points.size());
    for (const openvdb::Vec3s& p : points)
    {
        mesh.points.insert(mesh.points.end(), {p[0], p[1], p[2]});
    }

    // OpenVDB takes small values for the inside (level sets): turned round
    mesh.triangles.reserve(3*triangles.size() + 6*quads.size());
    const auto add = [&](const auto a, const auto b, const auto c)
    {
        mesh.triangles.insert(mesh.triangles.end(), {int(c), int(b), int(a)});
    };
    for (const openvdb::Vec3I& t : triangles)
    {
        add(t[0], t[1], t[2]);
    }
    for (const openvdb::Vec4I& q : quads)
    {
        // The shorter diagonal
        if
        (
            (points[q[0]] - points[q[2]]).lengthSqr()
         <= (points[q[1]] - points[q[3]]).lengthSqr()
        )
        {
            add(q[0], q[1], q[2]);
            add(q[0], q[2], q[3]);
        }
        else
        {
            add(q[0], q[1], q[3]);
            add(q[1], q[2], q[3]);
        }
    }
    return mesh;
}
