/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelHeating.H"
#include "filmHeating.H"
#include "voxelShade.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::melt::voxelHeating::conductivity
(
    const voxelGrid& grid,
    const exposedFace& face
)
{
    return
        grid.phase(face.x, face.y, face.z) == LIQUID
      ? grid.material().kappaLiquid : grid.material().kappaSolid;
}


Foam::melt::surfaceElements Foam::melt::voxelHeating::elements
(
    const voxelGrid& grid
) const
{
    const label nFree = label(faces_.free.size());
    const label n = nFree + label(faces_.atSides.size());
    const scalar face = sqr(frame_.dx());

    surfaceElements e;
    e.position.resize(n);
    e.normal.resize(n);
    e.area.resize(n);
    e.smoothArea.resize(n);
    e.T.resize(n);
    e.resistance.resize(n);
    e.free.resize(n);

    #pragma omp parallel for
    for (label i = 0; i < n; ++i)
    {
        const exposedFace& f =
            i < nFree ? faces_.free[i] : faces_.atSides[i - nFree];
        const std::array<int, 3> normal = exposedFaces::normal(f.side);
        e.position[i] = frame_.position
        (
            f.x + 0.5*(1 + normal[0]),
            f.y + 0.5*(1 + normal[1]),
            f.z + 0.5*(1 + normal[2])
        );
        e.normal[i] = frame_.normal(f.side);
        e.area[i] = f.area*face;
        e.smoothArea[i] = f.smooth*face;
        e.T[i] = grid.T(f.x, f.y, f.z);

        // Heat comes to the centre of a voxel, half a voxel behind the face of
        // a full one. That of a film comes to the voxel behind it, too
        // (giveSurface), as if its centre were that much nearer
        const scalar kappa = conductivity(grid, f);
        const scalar behind =
            scalar(grid.mass(f.x, f.y, f.z))/voxelMaterial::full - 0.5;
        e.resistance[i] =
            kappa > 0 && behind > 0
          ? behind*frame_.dx()/(kappa*e.area[i]) : 0;
        e.free[i] = i < nFree;
    }
    return e;
}


void Foam::melt::voxelHeating::addWalls
(
    const voxelGrid& grid,
    const surfaceElements& elements,
    absorbedHeat& absorbed
) const
{
    label i = label(faces_.free.size());
    for (const exposedFace& f : faces_.atSides)
    {
        const voxelWalls::contact c = walls_.at(f.side, f.x, f.y, f.z);
        const scalar inner = 2*conductivity(grid, f)/frame_.dx();
        const scalar hA =
            (c.h < 0 ? inner : c.h > 0 ? inner*c.h/(inner + c.h) : 0)
           *elements.area[i];
        absorbed.power[i] += hA*(c.T - elements.T[i]);
        absorbed.slope[i] += hA;
        ++i;
    }
}


void Foam::melt::voxelHeating::heatVolume
(
    voxelGrid& grid,
    const scalar time,
    const scalar dt
)
{
    DynamicList<point> positions;
    DynamicList<scalar> volumes;
    std::vector<std::array<int, 3>> voxels;
    const scalar volumeUnit = pow3(frame_.dx())/voxelMaterial::full;
    for (const int index : grid.list())
    {
        const voxelBrick& b = grid.brick(index);
        const std::array<int, 3> o = grid.origin(index);
        for (int i = 0; i < voxelBrick::size; ++i)
        {
            if (b.mass[i] > 0)
            {
                const int x = o[0] + (i >> 6);
                const int y = o[1] + ((i >> 3) & 7);
                const int z = o[2] + (i & 7);
                voxels.push_back({x, y, z});
                positions.append(frame_.position(x + 0.5, y + 0.5, z + 0.5));
                volumes.append(b.mass[i]*volumeUnit);
            }
        }
    }
    const scalarField power
    (
        sources_.heatVolume(time, pointField(positions), scalarField(volumes))
    );
    forAll(power, i)
    {
        account.give
        (
            grid, voxels[i][0], voxels[i][1], voxels[i][2], power[i]*dt, dt
        );
    }
}


void Foam::melt::voxelHeating::check
(
    const voxelGrid& grid,
    const scalar time
) const
{
    for (const heatSource& source : sources_)
    {
        for (const point& p : source.outside(time))
        {
            const std::array<double, 3> x = frame_.coordinates(p);
            const int i = int(std::floor(x[0]));
            const int j = int(std::floor(x[1]));
            const int k = int(std::floor(x[2]));
            if (grid.inside(i, j, k) && grid.phase(i, j, k) != EMPTY)
            {
                FatalIOErrorInFunction(source.dict())
                    << "Heat source " << source.name() << " at " << p
                    << " is inside melt or terrain." << nl
                    << "Accepted: a position in the open" << exit(FatalIOError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::voxelHeating::voxelHeating
(
    const dictionary& meltProperties,
    const voxelFrame& frame,
    const voxelWalls& walls,
    const voxelGrid& grid,
    const scalar time
)
:
    frame_(frame),
    walls_(walls),
    sources_(meltProperties)
{
    if (time == 0)
    {
        check(grid, time);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::voxelHeating::update()
{
    if (sources_.update())
    {
        account.fastest = VGREAT;
    }
}


void Foam::melt::voxelHeating::heat
(
    voxelGrid& grid,
    const scalar time,
    const scalar dt
)
{
    account.fastest = 0;
    if (!active())
    {
        return;
    }

    faces_.build(grid);
    const surfaceElements e(elements(grid));
    absorbedHeat absorbed
    (
        sources_.heatSurface(time, e, voxelShade(grid, frame_))
    );
    addWalls(grid, e, absorbed);

    // The faces of a voxel follow each other, those at sides apart
    const label nFree = label(faces_.free.size());
    const auto faceOf = [&](const label i) -> const exposedFace&
    {
        return i < nFree ? faces_.free[i] : faces_.atSides[i - nFree];
    };
    for (label i = 0; i < e.size();)
    {
        const exposedFace& f = faceOf(i);
        const scalar T = e.T[i];
        scalar power = 0, slope = 0;
        for (; i < e.size(); ++i)
        {
            const exposedFace& g = faceOf(i);
            if (g.x != f.x || g.y != f.y || g.z != f.z)
            {
                break;
            }
            power += absorbed.power[i];
            slope += absorbed.slope[i];
        }
        filmHeating::give(grid, f, T, power, slope, dt, account);
    }

    if (sources_.inVolume())
    {
        heatVolume(grid, time, dt);
    }
    grid.refresh();
}

// ************************************************************************* //
