/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleCloud.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::unitTest::particleCloud::particleCloud
(
    const lattice& points,
    const unsigned seed
)
:
    lattice_(points),
    generator_(seed),
    near
    (
        smoothingKernel(points.kernel, points.h(), points.dimensions()),
        0.1,
        points.box()
    )
{
    const double rho = 1000;
    particles& f = fluid;
    f.resize(points.n[0]*points.n[1]*points.n[2]);
    for (particles::array* a : f.arrays())
    {
        a->resize(f.size());
    }
    f.kappa.clear();
    f.conductionScale.assign(f.size(), 1);

    for (int i = 0; i < f.size(); ++i)
    {
        const auto coordinate = [&](const int cell)
        {
            return
                points.spacing
               *(cell + 0.5 + points.jitter*random(-1, 1));
        };
        f.x[i] = coordinate(i%points.n[0]);
        f.y[i] = coordinate(i/points.n[0]%points.n[1]);
        f.z[i] =
            points.dimensions() == 2 ? 0
          : coordinate(i/(points.n[0]*points.n[1]));
        f.rho[i] = rho;
        f.m[i] = rho*points.particleVolume();
        f.V[i] = points.particleVolume();
        f.T[i] = 300;
        f.id[i] = i;
    }
    build();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::unitTest::particleCloud::inside
(
    const int i,
    const double distance
) const
{
    const std::array<double, 3> position{fluid.x[i], fluid.y[i], fluid.z[i]};
    for (int a = 0; a < lattice_.dimensions(); ++a)
    {
        if
        (
            position[a] < distance
         || position[a] > lattice_.n[a]*lattice_.spacing - distance
        )
        {
            return false;
        }
    }
    return true;
}


double Foam::melt::unitTest::particleCloud::random
(
    const double low,
    const double high
)
{
    return std::uniform_real_distribution<double>(low, high)(generator_);
}


void Foam::melt::unitTest::particleCloud::randomise
(
    particles::array& a,
    const double low,
    const double high
)
{
    for (double& value : a)
    {
        value = random(low, high);
    }
}


void Foam::melt::unitTest::particleCloud::randomiseVelocity(const double speed)
{
    randomise(fluid.u, -speed, speed);
    randomise(fluid.v, -speed, speed);
    if (lattice_.dimensions() == 3)
    {
        randomise(fluid.w, -speed, speed);
    }
}


void Foam::melt::unitTest::particleCloud::randomiseDensity(const double share)
{
    for (int i = 0; i < size(); ++i)
    {
        fluid.rho[i] *= 1 + random(-share, share);
        fluid.m[i] *= 1 + random(-share, share);
        fluid.V[i] = fluid.m[i]/fluid.rho[i];
    }
}


void Foam::melt::unitTest::particleCloud::setVelocity
(
    const std::function<vector3(double, double, double)>& U
)
{
    for (int i = 0; i < size(); ++i)
    {
        const vector3 value = U(fluid.x[i], fluid.y[i], fluid.z[i]);
        fluid.u[i] = value[0];
        fluid.v[i] = value[1];
        fluid.w[i] = value[2];
    }
}


void Foam::melt::unitTest::particleCloud::addWall
(
    const int axis,
    const bool upper
)
{
    const double dx = lattice_.spacing;
    const int layers = int(std::ceil(near.radius()/dx));
    const double sign = upper ? -1 : 1;
    const double end = upper ? lattice_.n[axis]*dx : 0;

    // As wide as the box and a radius more at each side
    std::array<int, 3> low, high;
    for (int a = 0; a < 3; ++a)
    {
        const bool alone = a == 2 && lattice_.dimensions() == 2;
        low[a] = alone || lattice_.periodic[a] ? 0 : -layers;
        high[a] = lattice_.n[a] - low[a];
    }
    low[axis] = 0;
    high[axis] = layers;

    std::array<int, 3> c;
    for (c[2] = low[2]; c[2] < high[2]; ++c[2])
    {
        for (c[1] = low[1]; c[1] < high[1]; ++c[1])
        {
            for (c[0] = low[0]; c[0] < high[0]; ++c[0])
            {
                vector3 x;
                for (int a = 0; a < 3; ++a)
                {
                    x[a] = dx*(c[a] + 0.5);
                }
                x[axis] = end - sign*x[axis];
                walls.x.push_back(x[0]);
                walls.y.push_back(x[1]);
                walls.z.push_back(lattice_.dimensions() == 2 ? 0 : x[2]);
                walls.nx.push_back(axis == 0 ? sign : 0);
                walls.ny.push_back(axis == 1 ? sign : 0);
                walls.nz.push_back(axis == 2 ? sign : 0);
                walls.offset.push_back(sign*end);
                walls.volume.push_back(lattice_.particleVolume());
                walls.patch.push_back(2*axis + upper);
                walls.face.push_back(0);
                walls.otherPatches.push_back({-1, -1});
            }
        }
    }

    for
    (
        wallState::array* a :
        {
            &walls.wallU, &walls.wallV, &walls.wallW,
            &walls.u, &walls.v, &walls.w,
            &walls.p, &walls.heatTransfer, &walls.T
        }
    )
    {
        a->resize(walls.size());
    }
    walls.slip.resize(walls.size());
}


void Foam::melt::unitTest::particleCloud::build()
{
    if (walls.size())
    {
        near.setWalls(walls);
    }
    near.build(fluid, walls);
}

// ************************************************************************* //
