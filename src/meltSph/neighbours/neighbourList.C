/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neighbourList.H"

#include <limits>

template<class Offset, class Space>
void Foam::melt::neighbourList::fill
(
    std::vector<block<Offset>>& blocks,
    const double* const target[3],
    const double* const source[3],
    const cellGrid& sources,
    const double radius,
    const bool self,
    const Space& space
)
{
    const double radius2 = radius*radius;
    const double* const xs = source[0];
    const double* const ys = source[1];
    const double* const zs = source[2];

    blocks.resize((nTargets_ + blockSize - 1)/blockSize);

    #pragma omp parallel for schedule(dynamic)
    for (int b = 0; b < int(blocks.size()); ++b)
    {
        block<Offset>& rows = blocks[b];
        const int end =
            nTargets_ < (b + 1)*blockSize ? nTargets_ : (b + 1)*blockSize;

        rows.start.assign(1, 0);
        rows.start.reserve(blockSize + 1);
        std::size_t count = 0;

        for (int i = b*blockSize; i < end; ++i)
        {
            const double x = target[0][i];
            const double y = target[1][i];
            const double z = target[2][i];
            const int base = narrow_ ? i : 0;

            cellGrid::runs runs;
            const int nRuns = sources.neighbourRuns(x, y, z, runs);

            std::size_t candidates = 0;
            for (int r = 0; r < nRuns; ++r)
            {
                candidates += runs[r].end - runs[r].begin;
            }
            if (rows.offsets.size() < count + candidates)
            {
                rows.offsets.resize(count + candidates + count/4);
            }

            // Every candidate is written, and kept by moving on
            Offset* const out = rows.offsets.data();
            for (int r = 0; r < nRuns; ++r)
            {
                for (int j = runs[r].begin; j < runs[r].end; ++j)
                {
                    double dx = x - xs[j];
                    double dy = y - ys[j];
                    double dz = z - zs[j];
                    space.nearestImage(dx, dy, dz);
                    out[count] = Offset(j - base);
                    count +=
                        (dx*dx + dy*dy + dz*dz < radius2)
                      & !(self & (i == j));
                }
            }
            rows.start.push_back(std::uint32_t(count));
        }

        rows.offsets.resize(count);
        rows.offsets.shrink_to_fit();
    }
}


void Foam::melt::neighbourList::buildSelf
(
    const double* x, const double* y, const double* z, const int n,
    const cellGrid& grid, const double radius,
    const periodicBox& box
)
{
    clear();
    nTargets_ = n;
    narrow_ =
        !box.any()
     && grid.reach() <= std::numeric_limits<std::int16_t>::max();

    const double* const points[3] = {x, y, z};
    if (box.any())
    {
        fill(wideBlocks_, points, points, grid, radius, true, box);
    }
    else if (narrow_)
    {
        fill(narrowBlocks_, points, points, grid, radius, true, openSpace());
    }
    else
    {
        fill(wideBlocks_, points, points, grid, radius, true, openSpace());
    }
}


void Foam::melt::neighbourList::build
(
    const double* x, const double* y, const double* z, const int n,
    const double* xs, const double* ys, const double* zs,
    const cellGrid& sources, const double radius,
    const periodicBox& box
)
{
    clear();
    nTargets_ = n;

    const double* const targets[3] = {x, y, z};
    const double* const points[3] = {xs, ys, zs};
    if (box.any())
    {
        fill(wideBlocks_, targets, points, sources, radius, false, box);
    }
    else
    {
        fill(wideBlocks_, targets, points, sources, radius, false, openSpace());
    }
}


void Foam::melt::neighbourList::clear()
{
    nTargets_ = 0;
    narrow_ = false;
    narrowBlocks_.clear();
    wideBlocks_.clear();
}


std::uint64_t Foam::melt::neighbourList::nPairs() const
{
    std::uint64_t n = 0;
    for (const auto& b : narrowBlocks_)
    {
        n += b.offsets.size();
    }
    for (const auto& b : wideBlocks_)
    {
        n += b.offsets.size();
    }
    return n;
}


std::uint64_t Foam::melt::neighbourList::bytes() const
{
    std::uint64_t n = 0;
    for (const auto& b : narrowBlocks_)
    {
        n += sizeof(std::uint32_t)*b.start.capacity()
           + sizeof(std::int16_t)*b.offsets.capacity();
    }
    for (const auto& b : wideBlocks_)
    {
        n += sizeof(std::uint32_t)*b.start.capacity()
           + sizeof(std::int32_t)*b.offsets.capacity();
    }
    return n;
}

// ************************************************************************* //
