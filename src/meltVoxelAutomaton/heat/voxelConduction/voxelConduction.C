/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelConduction.H"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// A brick and one layer around it
constexpr int side = 10;

enum filling
{
    EMPTY_COLUMN,
    MIXED_COLUMN,
    FULL_COLUMN
};


struct surroundings
{
    double T[side*side*side];

    //- 1 if liquid, else 0
    double liquid[side*side*side];

    double filled[side*side*side];

    //- Of ten voxels on each other
    filling column[side][side];
};


void gather
(
    const Foam::melt::voxelGrid& grid,
    const int index,
    surroundings& s
)
{
    using namespace Foam::melt;
    const std::array<int, 3> o = grid.origin(index);
    const std::array<int, 3>& nb = grid.nBricks();

    for (int n = 0; n < 27; ++n)
    {
        const int dx = n/9 - 1, dy = n/3 % 3 - 1, dz = n % 3 - 1;
        const int bx = o[0]/8 + dx, by = o[1]/8 + dy, bz = o[2]/8 + dz;
        const bool there =
            bx >= 0 && bx < nb[0] && by >= 0 && by < nb[1]
         && bz >= 0 && bz < nb[2];
        const voxelBrick* b =
            there ? &grid.brick(grid.brickIndex(bx, by, bz)) : nullptr;
        const bool melt = b && (b->nLiquid || b->nSolid);

        const auto begin = [](const int d) { return d > 0 ? 9 : d < 0 ? 0 : 1; };
        const auto end = [](const int d) { return d > 0 ? 10 : d < 0 ? 1 : 9; };
        for (int x = begin(dx); x < end(dx); ++x)
        {
            for (int y = begin(dy); y < end(dy); ++y)
            {
                for (int z = begin(dz); z < end(dz); ++z)
                {
                    const int to = (x*side + y)*side + z;
                    const int i = voxelBrick::offset(x - 1, y - 1, z - 1);
                    const bool filled = melt && b->mass[i] > 0;
                    s.T[to] = filled ? b->T[i] : 0;
                    s.filled[to] =
                        filled ? double(b->mass[i])/voxelMaterial::full : 0;
                    s.liquid[to] = filled && b->phase[i] == LIQUID;
                }
            }
        }
    }

    for (int i = 0; i < side*side; ++i)
    {
        const double* const f = s.filled + side*i;
        const double least = *std::min_element(f, f + side);
        s.column[i/side][i % side] =
            least >= 1 ? FULL_COLUMN
          : *std::max_element(f, f + side) > 0 ? MIXED_COLUMN
          : EMPTY_COLUMN;
    }
}


//- Add to the area of the links from eight voxels to the other eight what a link
//  across lacks of it at either end
void mirror
(
    const double* a,
    const double* b,
    const int across,
    const double weight,
    double* area
)
{
    #pragma omp simd
    for (int z = 0; z < 8; ++z)
    {
        const double both = std::min(a[z], b[z]);
        area[z] += weight
           *(
                std::max(both - a[z + across], 0.0)
              + std::max(both - b[z + across], 0.0)
            );
    }
}


//- The same of a link to a corner, for which one of three voxels is enough
void mirrorCorner
(
    const double* a,
    const double* b,
    const std::array<int, 3>& across,
    const double weight,
    double* area
)
{
    const auto fullest = [&](const double* v)
    {
        return std::max(std::max(v[across[0]], v[across[1]]), v[across[2]]);
    };
    for (int z = 0; z < 8; ++z)
    {
        const double both = std::min(a[z], b[z]);
        area[z] += weight
           *(
                std::max(both - fullest(a + z), 0.0)
              + std::max(both - fullest(b + z), 0.0)
            );
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::voxelConduction::voxelConduction(const int neighbours)
:
    sum_(0)
{
    const double f =
        neighbours == 6 ? 1 : neighbours == 18 ? 3
      : neighbours == 26 ? 13.0/3 : 0;
    if (f == 0)
    {
        throw std::invalid_argument("neighbours: 6, 18 or 26");
    }
    const int farthest = neighbours == 6 ? 1 : neighbours == 18 ? 2 : 3;

    for (int n = 0; n < 27; ++n)
    {
        const std::array<int, 3> d{n/9 - 1, n/3 % 3 - 1, n % 3 - 1};
        const int l2 = d[0]*d[0] + d[1]*d[1] + d[2]*d[2];
        if (l2 == 0 || l2 > farthest)
        {
            continue;
        }
        link l{(d[0]*side + d[1])*side + d[2], 1/(f*l2), {}, {}, 0, 0};
        sum_ += l.weight;
        if (l2 < farthest)
        {
            l.mirrored = 0.5/(f*(l2 + 1));
            constexpr int unit[3] = {side*side, side, 1};
            for (int k = 0; k < 3; ++k)
            {
                if (d[k] == 0)
                {
                    l.across.push_back(-unit[k]);
                    l.across.push_back(unit[k]);
                }
            }
        }
        if (l2 + 1 < farthest)
        {
            l.twiceMirrored = 0.5/(f*(l2 + 2));
            for (int i = 0; i < 4; ++i)
            {
                const int a = l.across[i % 2], b = l.across[2 + i/2];
                l.twiceAcross.push_back({a, b, a + b});
            }
        }
        links_.push_back(l);
    }

    // With 26 neighbours the mirror may give more than a gap takes
    sum_ = neighbours == 26 ? 4 : sum_;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::voxelConduction::conductBrick
(
    voxelGrid& grid,
    const int index,
    const double dt
)
{
    thread_local surroundings s;
    gather(grid, index, s);

    const voxelMaterial& material = grid.material();
    const double toUnits = dt*grid.dx()/material.energyUnit;

    // Conductivity of a pair with 0, 1, 2 liquid voxels as a polynomial
    const double solid = material.kappaSolid, liquid = material.kappaLiquid;
    const double mixed =
        solid + liquid > 0 ? 2*solid*liquid/(solid + liquid) : 0;
    const double linear = 2*mixed - 1.5*solid - 0.5*liquid;
    const double square = 0.5*(solid + liquid) - mixed;

    voxelBrick& b = grid.own(index);
    bool exchanged = false;

    for (int x = 0; x < 8; ++x)
    {
        for (int y = 0; y < 8; ++y)
        {
            const int row = ((x + 1)*side + y + 1)*side + 1;
            if (s.column[x + 1][y + 1] == EMPTY_COLUMN)
            {
                continue;
            }
            bool gaps = false;
            for (int i = 0; i < 9; ++i)
            {
                gaps = gaps || s.column[x + i/3][y + i % 3] != FULL_COLUMN;
            }
            std::int64_t gained[8] = {};
            for (const link& l : links_)
            {
                const int other = row + l.step;
                double area[8];
                #pragma omp simd
                for (int z = 0; z < 8; ++z)
                {
                    area[z] = l.weight
                       *std::min(s.filled[row + z], s.filled[other + z]);
                }
                if (gaps)
                {
                    const double* a = s.filled + row;
                    const double* b = s.filled + other;
                    for (const int step : l.across)
                    {
                        mirror(a, b, step, l.mirrored, area);
                    }
                    for (const std::array<int, 3>& steps : l.twiceAcross)
                    {
                        mirrorCorner(a, b, steps, l.twiceMirrored, area);
                    }
                }
                #pragma omp simd
                for (int z = 0; z < 8; ++z)
                {
                    // Odd in the two voxels: they round alike
                    const double m = s.liquid[row + z] + s.liquid[other + z];
                    const double kappa = solid + m*(linear + m*square);
                    gained[z] += std::int64_t
                    (
                        toUnits*kappa*area[z]
                       *(s.T[other + z] - s.T[row + z])
                    );
                }
            }
            for (int z = 0; z < 8; ++z)
            {
                b.energy[voxelBrick::offset(x, y, z)] += gained[z];
                exchanged = exchanged || gained[z];
            }
        }
    }
    return exchanged;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::voxelConduction::conduct(voxelGrid& grid, const double dt)
{
    const std::vector<int>& bricks = grid.list();
    const std::array<int, 3>& nb = grid.nBricks();
    const int n = int(bricks.size());

    // Bricks that changed, and those beside them
    std::vector<char> visit(std::size_t(nb[0])*nb[1]*nb[2], 0);
    for (const int index : bricks)
    {
        if (grid.brick(index).conducting)
        {
            const std::array<int, 3> o = grid.origin(index);
            for (int i = 0; i < 27; ++i)
            {
                const int bx = o[0]/8 + i/9 - 1;
                const int by = o[1]/8 + i/3 % 3 - 1;
                const int bz = o[2]/8 + i % 3 - 1;
                if
                (
                    bx >= 0 && bx < nb[0] && by >= 0 && by < nb[1]
                 && bz >= 0 && bz < nb[2]
                )
                {
                    visit[grid.brickIndex(bx, by, bz)] = 1;
                }
            }
        }
    }

    // Temperatures and phases are those of before until the refresh
    #pragma omp parallel for schedule(dynamic, 2)
    for (int i = 0; i < n; ++i)
    {
        const voxelBrick& b = grid.brick(bricks[i]);
        if (visit[bricks[i]] && (b.nLiquid || b.nSolid))
        {
            visit[bricks[i]] = conductBrick(grid, bricks[i], dt) ? 2 : 1;
        }
    }
    for (const int index : bricks)
    {
        voxelBrick& b = grid.own(index);
        updates_ += visit[index] ? b.nLiquid + b.nSolid : 0;
        b.changed = b.changed || visit[index] == 2;
        b.conducting = false;
    }
    grid.refresh();
}


double Foam::melt::voxelConduction::maxDeltaT(const voxelGrid& grid) const
{
    const voxelMaterial& material = grid.material();
    const double kappa = std::max(material.kappaSolid, material.kappaLiquid);
    const double Cp =
        std::min(material.curve.CpSolid, material.curve.CpLiquid);

    return
        kappa > 0
      ? material.rho*Cp*grid.dx()*grid.dx()/(kappa*sum_)
      : 1e30;
}

// ************************************************************************* //
