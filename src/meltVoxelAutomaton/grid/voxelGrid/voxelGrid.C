/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelGrid.H"

#include <algorithm>
#include <cstring>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Nothing was and is in the 8 voxels from i on
bool columnIsVoid(const Foam::melt::voxelBrick& b, const int i)
{
    std::int64_t something = 0;
    for (int k = i; k < i + 8; ++k)
    {
        something |= b.energy[k] | b.mass[k] | b.phase[k] | b.rock[k];
    }
    return !something;
}


} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::voxelGrid::voxelGrid
(
    const std::array<int, 3>& n,
    const double dx,
    const voxelMaterial& material,
    const std::array<bool, 5>& open
)
:
    n_(n),
    nBricks_{(n[0] + 7)/8, (n[1] + 7)/8, (n[2] + 7)/8},
    dx_(dx),
    material_(material),
    void_(),
    rock_(),
    brick_(std::size_t(nBricks_[0])*nBricks_[1]*nBricks_[2], &void_),
    own_(brick_.size()),
    open_(open)
{
    std::fill_n(rock_.phase, voxelBrick::size, std::uint8_t(ROCK));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::melt::voxelBrick& Foam::melt::voxelGrid::make(const int index)
{
    #pragma omp critical (meltVoxelGridMake)
    if (!own_[index])
    {
        own_[index].reset(new voxelBrick(*brick_[index]));
        brick_[index] = own_[index].get();
        listChanged_ = true;
    }
    return *own_[index];
}


Foam::melt::voxelGrid::columnState Foam::melt::voxelGrid::refreshColumn
(
    voxelBrick& b,
    const int i
)
{
    // One thing after the other, each for all eight: whole vectors
    double h[8];
    std::uint8_t phase[8];
    #pragma omp simd
    for (int k = 0; k < 8; ++k)
    {
        h[k] = material_.h(std::max(b.mass[i + k], 1), b.energy[i + k]);
    }
    #pragma omp simd
    for (int k = 0; k < 8; ++k)
    {
        const double T = material_.curve.T(h[k]);
        b.T[i + k] = b.mass[i + k] > 0 ? T : b.T[i + k];
    }
    #pragma omp simd
    for (int k = 0; k < 8; ++k)
    {
        const voxelPhase melt = material_.flows(h[k]) ? LIQUID : SOLID;
        const voxelPhase open = b.mass[i + k] > 0 ? melt : EMPTY;
        phase[k] = b.phase[i + k] == ROCK ? ROCK : open;
    }

    columnState s{0, 0, 0, false, false};
    std::int64_t left = 0;
    for (int k = 0; k < 8; ++k)
    {
        s.nLiquid += phase[k] == LIQUID;
        s.nSolid += phase[k] == SOLID;
        s.nRock += phase[k] == ROCK;
        s.used |= phase[k] != EMPTY || b.rock[i + k] > 0;
        s.solidsChanged |= (phase[k] == SOLID) != (b.phase[i + k] == SOLID);
        left |= phase[k] == EMPTY ? b.energy[i + k] : 0;
        b.phase[i + k] = phase[k];
    }
    for (int k = i; left && k < i + 8; ++k)
    {
        if (b.phase[k] == EMPTY)
        {
            addResidual(b.energy[k]);
            b.energy[k] = 0;
        }
    }
    return s;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const std::vector<int>& Foam::melt::voxelGrid::list()
{
    if (listChanged_)
    {
        list_.clear();
        for (std::size_t i = 0; i < own_.size(); ++i)
        {
            if (own_[i])
            {
                list_.push_back(int(i));
            }
        }
        listChanged_ = false;
    }
    return list_;
}


std::uint8_t Foam::melt::voxelGrid::outsidePhase
(
    const int x,
    const int y,
    const int z
) const
{
    const bool isOpen =
        z < 0 ? open_[4]
      : z >= n_[2] ? true
      : x < 0 ? open_[0]
      : x >= n_[0] ? open_[1]
      : y < 0 ? open_[2]
      : open_[3];

    return isOpen ? EMPTY : ROCK;
}


void Foam::melt::voxelGrid::fill
(
    const int x,
    const int y,
    const int z,
    const double share,
    const double T
)
{
    voxelBrick& b = ownAt(x, y, z);
    const int i = voxelBrick::offset(x, y, z);
    const auto mass = std::int32_t
    (
        std::min<std::int64_t>
        (
            std::llround(share*b.capacity(i)), b.capacity(i) - b.mass[i]
        )
    );
    b.energy[i] += material_.energy(mass, material_.curve.h(T));
    b.mass[i] += mass;
    b.changed = true;
}


void Foam::melt::voxelGrid::fillRock
(
    const int x,
    const int y,
    const int z,
    const double share
)
{
    const int level = int(std::lround(256*share));
    if (level > 0)
    {
        voxelBrick& b = ownAt(x, y, z);
        const int i = voxelBrick::offset(x, y, z);
        b.rock[i] = std::uint8_t(std::min(level, 255));
        b.phase[i] = level > 255 ? ROCK : EMPTY;
        b.changed = true;
    }
}


void Foam::melt::voxelGrid::refresh()
{
    const std::vector<int>& bricks = list();
    const int n = int(bricks.size());
    std::vector<char> disposable(n, 0);
    bool solidsChanged = false;

    #pragma omp parallel for schedule(dynamic, 8) reduction(||:solidsChanged)
    for (int bricki = 0; bricki < n; ++bricki)
    {
        voxelBrick& b = *own_[bricks[bricki]];
        if (!b.changed)
        {
            continue;
        }
        b.nLiquid = 0;
        b.nSolid = 0;
        bool used = false;
        bool rock = true;
        for (int i = 0; i < voxelBrick::size; i += 8)
        {
            if (columnIsVoid(b, i))
            {
                rock = false;
                continue;
            }
            const columnState state(refreshColumn(b, i));
            b.nLiquid += state.nLiquid;
            b.nSolid += state.nSolid;
            used = used || state.used;
            rock = rock && state.nRock == 8;
            solidsChanged = solidsChanged || state.solidsChanged;
        }
        b.changed = false;
        b.conducting = true;
        b.unfiltered = true;
        disposable[bricki] = !used ? 1 : rock ? 2 : 0;
    }
    solidsChanged_ = solidsChanged_ || solidsChanged;

    for (int bricki = 0; bricki < n; ++bricki)
    {
        if (disposable[bricki])
        {
            const int index = bricks[bricki];
            brick_[index] = disposable[bricki] == 1 ? &void_ : &rock_;
            own_[index].reset();
            listChanged_ = true;
        }
    }
}


bool Foam::melt::voxelGrid::takeSolidsChanged()
{
    const bool result = solidsChanged_;
    solidsChanged_ = false;
    return result;
}


std::int64_t Foam::melt::voxelGrid::totalMass() const
{
    std::int64_t total = 0;
    for (const auto& b : own_)
    {
        for (int i = 0; b && i < voxelBrick::size; ++i)
        {
            total += b->mass[i];
        }
    }
    return total;
}


std::int64_t Foam::melt::voxelGrid::totalEnergy() const
{
    std::int64_t total = residual_;
    for (const auto& b : own_)
    {
        for (int i = 0; b && i < voxelBrick::size; ++i)
        {
            total += b->energy[i];
        }
    }
    return total;
}


std::size_t Foam::melt::voxelGrid::bytes() const
{
    std::size_t n = 0;
    for (const auto& b : own_)
    {
        n += bool(b);
    }
    return
        n*sizeof(voxelBrick) + brick_.size()*2*sizeof(void*)
      + list_.capacity()*sizeof(int);
}

// ************************************************************************* //
