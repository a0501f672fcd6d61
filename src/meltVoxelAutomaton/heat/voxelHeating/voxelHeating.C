/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelHeating.H"
#include "voxelRays.H"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

class voxelShade
:
    public occlusion
{
    const voxelGrid& grid_;

    const voxelFrame& frame_;

public:

    voxelShade(const voxelGrid& grid, const voxelFrame& frame)
    :
        grid_(grid),
        frame_(frame)
    {}

    virtual boolList blocked
    (
        const surfaceElements& elements,
        const labelList& set,
        const pointField& to
    ) const
    {
        // Off the face, by less than anything that matters
        const scalar off = 1e-6*frame_.dx();

        boolList result(set.size());
        #pragma omp parallel for schedule(dynamic, 64)
        for (label k = 0; k < set.size(); ++k)
        {
            const label i = set[k];
            result[k] = voxelRays::blocked
            (
                grid_,
                frame_.coordinates
                (
                    elements.position[i] + off*elements.normal[i]
                ),
                frame_.coordinates(to[k])
            );
        }
        return result;
    }
};

} // End anonymous namespace


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


void Foam::melt::voxelHeating::give
(
    voxelGrid& grid,
    const int x,
    const int y,
    const int z,
    const scalar heat,
    const scalar dt
)
{
    voxelBrick& b = grid.ownAt(x, y, z);
    const auto energy =
        std::int64_t(std::llround(heat/grid.material().energyUnit));
    b.energy[voxelBrick::offset(x, y, z)] += energy;
    b.changed = true;
    (energy > 0 ? in : out) += std::abs(energy);
    fastest = max(fastest, std::abs(energy)/(voxelMaterial::energyRange*dt));
}


void Foam::melt::voxelHeating::giveSurface
(
    voxelGrid& grid,
    const exposedFace& face,
    const scalar T,
    const scalar power,
    const scalar slope,
    const scalar dt
)
{
    if (power == 0)
    {
        return;
    }
    const voxelMaterial& material = grid.material();

    // The voxel itself, the one below, solids beside and above it, with what
    // counts of their masses
    struct part
    {
        int x, y, z;
        scalar mass;
    };
    std::array<part, 7> parts;
    int n = 0;
    scalar total = 0;
    const auto add = [&](const int x, const int y, const int z, const scalar w)
    {
        const scalar mass = w*grid.mass(x, y, z)*material.massUnit;
        if (mass > 0)
        {
            parts[n++] = {x, y, z, mass};
            total += mass;
        }
    };
    add(face.x, face.y, face.z, 1);
    const scalar vacant =
        1 - scalar(grid.mass(face.x, face.y, face.z))/voxelMaterial::full;
    for (int side = 0; side < 6; ++side)
    {
        const std::array<int, 3> d = exposedFaces::normal(side);
        const int x = face.x + d[0], y = face.y + d[1], z = face.z + d[2];
        const std::uint8_t phase = grid.phase(x, y, z);
        if
        (
            grid.inside(x, y, z)
         && (phase == SOLID || (side == 4 && phase == LIQUID))
        )
        {
            add(x, y, z, vacant);
        }
    }

    const auto h = [&](const part& p)
    {
        return material.h
        (
            grid.mass(p.x, p.y, p.z),
            grid.brickAt(p.x, p.y, p.z).energy
            [
                voxelBrick::offset(p.x, p.y, p.z)
            ]
        );
    };
    const scalar hFilm = h(parts[0]);
    const scalar heat =
        power*dt/(1 + slope*dt/(total*material.curve.Cp(hFilm)));
    for (int i = 0; i < n; ++i)
    {
        const part& p = parts[i];
        scalar share = heat*p.mass/total;
        if (slope > 0)
        {
            // Not beyond the temperature at which the power would be 0: on its
            // way the voxel's heat capacity may fall
            const scalar balance =
                p.mass*(material.curve.h(T + power/slope) - h(p));
            share =
                power > 0
              ? min(share, max(balance, scalar(0)))
              : max(share, min(balance, scalar(0)));
        }
        give(grid, p.x, p.y, p.z, share, dt);
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
        give(grid, voxels[i][0], voxels[i][1], voxels[i][2], power[i]*dt, dt);
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
        fastest = VGREAT;
    }
}


void Foam::melt::voxelHeating::heat
(
    voxelGrid& grid,
    const scalar time,
    const scalar dt
)
{
    fastest = 0;
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
        giveSurface(grid, f, T, power, slope, dt);
    }

    if (sources_.inVolume())
    {
        heatVolume(grid, time, dt);
    }
    grid.refresh();
}

// ************************************************************************* //
