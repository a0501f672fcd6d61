/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neighbourhood.H"
#include "blockSum.H"

void Foam::melt::neighbourhood::setWalls(wallState& walls)
{
    std::vector<int> order;
    wallGrid_.sort
    (
        walls.x.data(), walls.y.data(), walls.z.data(), int(walls.size()),
        radius(), order, box_
    );

    const auto permute = [&](auto& a)
    {
        auto sorted = a;
        for (std::size_t i = 0; i < order.size(); ++i)
        {
            sorted[i] = a[order[i]];
        }
        a.swap(sorted);
    };
    for
    (
        wallState::array* a :
        {
            &walls.x, &walls.y, &walls.z,
            &walls.nx, &walls.ny, &walls.nz, &walls.offset, &walls.volume,
            &walls.wallU, &walls.wallV, &walls.wallW,
            &walls.u, &walls.v, &walls.w, &walls.p,
            &walls.heatTransfer, &walls.T
        }
    )
    {
        permute(*a);
    }
    permute(walls.slip);
    permute(walls.patch);
    permute(walls.face);
    permute(walls.otherPatches);
}


void Foam::melt::neighbourhood::wrap(particles& fluid)
{
    particles::array* const positions[3] = {&fluid.x, &fluid.y, &fluid.z};
    for (int a = 0; a < 3; ++a)
    {
        if (box_.period(a) > 0)
        {
            particles::array& x = *positions[a];
            crossed_[a] += box_.period(a)*blockSum
            (
                fluid.size(),
                [&](const int i)
                {
                    return fluid.m[i]*box_.periodsBeyond(x[i], a);
                }
            );
            for (double& coordinate : x)
            {
                coordinate = box_.inside(coordinate, a);
            }
        }
    }
}


void Foam::melt::neighbourhood::findBesideWalls(const int n)
{
    besideWalls_.clear();
    wallIndex_.assign(n, -1);
    for (int i = 0; i < n; ++i)
    {
        if (walls_.sourcesOf(i).size())
        {
            wallIndex_[i] = int(besideWalls_.size());
            besideWalls_.push_back(i);
        }
    }
}


void Foam::melt::neighbourhood::build(particles& fluid, const wallState& walls)
{
    wrap(fluid);

    std::vector<int> order;
    grid_.sort
    (
        fluid.x.data(), fluid.y.data(), fluid.z.data(), fluid.size(),
        radius(), order, box_
    );
    fluid.permute(order);

    fluid_.buildSelf
    (
        fluid.x.data(), fluid.y.data(), fluid.z.data(), fluid.size(),
        grid_, radius(), box_
    );

    if (walls.size())
    {
        walls_.build
        (
            fluid.x.data(), fluid.y.data(), fluid.z.data(), fluid.size(),
            walls.x.data(), walls.y.data(), walls.z.data(),
            wallGrid_, radius(), box_
        );
        fluidOfWalls_.build
        (
            walls.x.data(), walls.y.data(), walls.z.data(), int(walls.size()),
            fluid.x.data(), fluid.y.data(), fluid.z.data(),
            grid_, radius(), box_
        );
        findBesideWalls(fluid.size());
    }

    solid_.clear();
    idle_.clear();
    nIdlePairs_ = 0;
    nIdleWallPairs_ = 0;
    moved_ = 0;
    ++nBuilds_;
}


void Foam::melt::neighbourhood::setSolids(const std::vector<int>& body)
{
    const int n = int(body.size());
    solid_.clear();
    idle_.clear();
    nIdlePairs_ = 0;
    nIdleWallPairs_ = 0;
    if
    (
        std::all_of
        (
            body.begin(), body.end(), [](const int b) { return b < 0; }
        )
    )
    {
        return;
    }

    solid_.resize(n);
    for (int i = 0; i < n; ++i)
    {
        solid_[i] = body[i] >= 0;
    }
    idle_.assign(n, 0);
    fluid_.forEach
    (
        [&](const int i) { return body[i] >= 0; },
        [&](const int i, const auto& row)
        {
            bool others = body[i] < 0;
            for (int k = 0; k < row.size(); ++k)
            {
                others |= body[row[k]] != body[i];
            }
            idle_[i] = !others;
        }
    );

    for (int i = 0; i < n; ++i)
    {
        if (idle_[i])
        {
            nIdlePairs_ += fluid_.nPairs(i);
            nIdleWallPairs_ += walls_.sourcesOf(i).size();
        }
    }
}

// ************************************************************************* //
