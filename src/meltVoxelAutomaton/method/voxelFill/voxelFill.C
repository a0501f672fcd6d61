/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelFill.H"
#include "fvMesh.H"
#include "initialTemperature.H"
#include "shape.H"
#include "Time.H"

#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

// Points along an edge of a voxel at the surface
constexpr int perEdge = 3;

//- Calls share(x, y, z, share) for each voxel that is not empty
void forAllFilled
(
    const shape& body,
    const voxelFrame& frame,
    const std::function<void(int, int, int, double)>& filled
)
{
    std::array<int, 3> begin, end;
    frame.range(body.bounds(), begin, end);

    // One more to all sides, that what is at the border has surroundings
    const std::array<int, 3> size
    {
        end[0] - begin[0] + 2, end[1] - begin[1] + 2, end[2] - begin[2] + 2
    };
    const auto index = [&](const int x, const int y, const int z)
    {
        return (x*size[1] + y)*size[2] + z;
    };

    pointField centres(size[0]*size[1]*size[2]);
    for (int x = 0; x < size[0]; ++x)
    {
        for (int y = 0; y < size[1]; ++y)
        {
            for (int z = 0; z < size[2]; ++z)
            {
                centres[index(x, y, z)] = frame.position
                (
                    begin[0] + x - 0.5, begin[1] + y - 0.5, begin[2] + z - 0.5
                );
            }
        }
    }
    const boolList inside(body.inside(centres));

    for (int x = 1; x < size[0] - 1; ++x)
    {
        for (int y = 1; y < size[1] - 1; ++y)
        {
            DynamicList<point> points;
            std::vector<int> mixed;
            std::vector<double> share(size[2], 0);
            for (int z = 1; z < size[2] - 1; ++z)
            {
                const bool centre = inside[index(x, y, z)];
                const bool uniform =
                    inside[index(x - 1, y, z)] == centre
                 && inside[index(x + 1, y, z)] == centre
                 && inside[index(x, y - 1, z)] == centre
                 && inside[index(x, y + 1, z)] == centre
                 && inside[index(x, y, z - 1)] == centre
                 && inside[index(x, y, z + 1)] == centre;
                share[z] = uniform && centre;
                if (!uniform)
                {
                    mixed.push_back(z);
                    for (int i = 0; i < 27; ++i)
                    {
                        points.append
                        (
                            frame.position
                            (
                                begin[0] + x - 1 + (i/9 + 0.5)/perEdge,
                                begin[1] + y - 1 + (i/3 % 3 + 0.5)/perEdge,
                                begin[2] + z - 1 + (i % 3 + 0.5)/perEdge
                            )
                        );
                    }
                }
            }
            if (!mixed.empty())
            {
                const boolList in(body.inside(pointField(points)));
                forAll(in, i)
                {
                    share[mixed[i/27]] += in[i]/27.0;
                }
            }
            for (int z = 1; z < size[2] - 1; ++z)
            {
                if (share[z] > 0)
                {
                    filled
                    (
                        begin[0] + x - 1,
                        begin[1] + y - 1,
                        begin[2] + z - 1,
                        share[z]
                    );
                }
            }
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::voxelFill::fillTerrain
(
    const meltScene& scene,
    const voxelFrame& frame,
    voxelGrid& grid
)
{
    const dictionary& terrain = scene.dict().subOrEmptyDict("terrain");
    for (const word& name : terrain.toc())
    {
        const autoPtr<shape> body
        (
            shape::New
            (
                name, terrain.subDict(name), scene.mesh().time().globalPath()
            )
        );
        forAllFilled
        (
            *body,
            frame,
            [&](const int x, const int y, const int z, const double share)
            {
                grid.fillRock(x, y, z, share);
            }
        );
    }
    grid.refresh();
}


void Foam::melt::voxelFill::fillMelt
(
    const meltScene& scene,
    const voxelFrame& frame,
    voxelGrid& grid
)
{
    const dictionary& shapes = scene.dict().subDict("shapes");
    for (const shape& body : scene.shapes())
    {
        const autoPtr<initialTemperature> T
        (
            initialTemperature::New
            (
                shapes.subDict(body.name()).subDict("T"), body
            )
        );
        struct place
        {
            int x, y, z;
            double share;
        };
        std::vector<place> places;
        DynamicList<point> centres;
        forAllFilled
        (
            body,
            frame,
            [&](const int x, const int y, const int z, const double share)
            {
                places.push_back({x, y, z, share});
                centres.append(frame.position(x + 0.5, y + 0.5, z + 0.5));
            }
        );
        const scalarField values(T->value(pointField(centres)));
        for (std::size_t i = 0; i < places.size(); ++i)
        {
            const place& p = places[i];
            grid.fill(p.x, p.y, p.z, p.share, values[i]);
        }
    }
    grid.refresh();

    if (grid.totalMass() == 0)
    {
        FatalIOErrorInFunction(shapes)
            << "The grid is empty: no shape fills a voxel of "
            << scene.resolution() << " m that terrain leaves free." << nl
            << "Accepted: a shape thicker than that" << exit(FatalIOError);
    }
}

// ************************************************************************* //
