/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "filmFlows.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double Foam::melt::filmFlows::surfaceBeside
(
    const voxelGrid& grid,
    openSegments& segments,
    const openSegment& segment,
    const int x,
    const int y
)
{
    if (!grid.inside(x, y, segment.z0))
    {
        return
            grid.outsidePhase(x, y, segment.z0) == EMPTY
          ? segment.base : segment.surface();
    }
    const openSegments::slot* s = segments.slotOfColumn(grid, x, y);
    const int column = (x & 7)*8 + (y & 7);
    for (int i = s ? s->start[column] : 0; s && i < s->start[column + 1]; ++i)
    {
        const openSegment& beside = s->segments[i];
        if (beside.z0 <= segment.z1 && beside.z1 >= segment.z0)
        {
            return beside.surface();
        }
    }
    return segment.surface();
}


void Foam::melt::filmFlows::findSlopes
(
    const voxelGrid& grid,
    openSegments& segments,
    openSegments::slot& s
)
{
    for (std::uint64_t columns = s.wet; columns; columns &= columns - 1)
    {
        const int column = __builtin_ctzll(columns);
        const int x = 8*s.bx + column/8, y = 8*s.by + column % 8;
        for (int i = s.start[column]; i < s.start[column + 1]; ++i)
        {
            openSegment& a = s.segments[i];
            const auto surface = [&](const int dx, const int dy)
            {
                return surfaceBeside(grid, segments, a, x + dx, y + dy);
            };
            if (a.height > 0)
            {
                a.slope =
                {
                    0.5*(surface(1, 0) - surface(-1, 0)),
                    0.5*(surface(0, 1) - surface(0, -1))
                };
            }
        }
    }
}


double Foam::melt::filmFlows::portion
(
    const voxelGrid& grid,
    const openSegment& donor,
    const double receiverBase,
    const double receiverSurface,
    const double slopeAcross,
    const int openingTop,
    const double dt
) const
{
    const double floor = std::max(donor.base, receiverBase);
    const double h = std::min(donor.surface(), openingTop + 1.0) - floor;
    const double drop = donor.surface() - receiverSurface;
    if (!(h > 0 && drop > 0))
    {
        return 0;
    }
    const double dx = grid.dx();
    const double thick = std::min(h, thicknessLimit_);
    const double thin = std::clamp(receiverSurface - floor, 0.0, thick);
    const double slope = drop/std::sqrt(1 + drop*drop);
    double fluidity = donor.fluidity;
    if (film_.dependsOnStress())
    {
        const double whole = std::hypot(drop, slopeAcross);
        const double sine = whole/std::sqrt(1 + whole*whole);
        fluidity = film_.fluidity(donor.T, weight_*thick*dx*sine);
    }
    const double cube = 0.25*(thick + thin)*(thick*thick + thin*thin);
    const double mobility = weight_*fluidity*dt*dx/3*cube;

    return std::min({mobility*slope, maxPortion*drop, maxPortion*h});
}


void Foam::melt::filmFlows::flowBetween
(
    const voxelGrid& grid,
    openSegments::slot& slotA, const int i, const int ax, const int ay,
    openSegments::slot& slotB, const int j, const int bx, const int by,
    const double dt,
    std::vector<filmFlow>& flows
) const
{
    openSegment& a = slotA.segments[i];
    openSegment& b = slotB.segments[j];
    const int openingTop = std::min(a.z1, b.z1);
    const int opening = std::max(a.z0, b.z0);
    if (opening > openingTop || (a.height <= 0 && b.height <= 0))
    {
        return;
    }
    const bool fromA =
        b.height <= 0 || (a.height > 0 && a.surface() >= b.surface());
    openSegment& donor = fromA ? a : b;
    openSegment& receiver = fromA ? b : a;

    // Across the flow; what is dry has no slope of its own
    const int across = ax == bx ? 0 : 1;
    const double slopeAcross =
        receiver.height > 0
      ? 0.5*(donor.slope[across] + receiver.slope[across])
      : donor.slope[across];

    double height = portion
    (
        grid,
        donor,
        receiver.base,
        receiver.surface(),
        slopeAcross,
        openingTop,
        dt
    );
    if (!(height > 0))
    {
        return;
    }

    filmFlow f{&donor, &receiver, 0, fromA ? bx : ax, fromA ? by : ay, -1};
    constexpr double full = voxelMaterial::full;
    if (opening > receiver.top + 1)
    {
        // Over an edge: into a voxel that three more may fill
        f.z = opening;
        const double room =
            grid.capacity(f.x, f.y, f.z) - grid.mass(f.x, f.y, f.z);
        height = std::min(height, 0.25*room/full);
    }
    f.mass = std::int64_t(height*full);
    if (f.mass > 0)
    {
        flows.push_back(f);
        openSegments::slot& slot = fromA ? slotB : slotA;
        #pragma omp atomic
        slot.receives |= openSegments::slot::bit(f.x, f.y);
        #pragma omp atomic
        receiver.wantedIn += f.mass;
        #pragma omp atomic
        donor.wantedOut += f.mass;
    }
}


void Foam::melt::filmFlows::flowOut
(
    const voxelGrid& grid,
    openSegment& donor,
    const double dt,
    std::vector<filmFlow>& flows
) const
{
    const double height =
        donor.height > 0
      ? portion(grid, donor, donor.base, donor.base, 0, donor.z1, dt)
      : 0;
    const auto mass = std::int64_t(height*voxelMaterial::full);
    if (mass > 0)
    {
        flows.push_back({&donor, nullptr, mass, 0, 0, -1});
        #pragma omp atomic
        donor.wantedOut += mass;
    }
}


void Foam::melt::filmFlows::findOfSlot
(
    const voxelGrid& grid,
    openSegments& segments,
    const int sloti,
    const double dt
)
{
    openSegments::slot& s = segments.slots()[sloti];
    const std::array<int, 3>& size = grid.n();
    std::vector<filmFlow>& flows = flows_[sloti];
    flows.clear();

    for (int column = 0; column < 64; ++column)
    {
        const int x = 8*s.bx + column/8, y = 8*s.by + column % 8;
        if (x >= size[0] || y >= size[1])
        {
            continue;
        }
        for (int direction = 0; direction < 2; ++direction)
        {
            const int x2 = x + (direction == 0), y2 = y + (direction == 1);
            if (x2 >= size[0] || y2 >= size[1])
            {
                continue;
            }
            openSegments::slot* other = segments.slotOfColumn(grid, x2, y2);
            const int column2 = (x2 & 7)*8 + (y2 & 7);
            if (!other || !(s.isWet(column) || other->isWet(column2)))
            {
                continue;
            }
            for (int i = s.start[column]; i < s.start[column + 1]; ++i)
            {
                for
                (
                    int j = other->start[column2];
                    j < other->start[column2 + 1];
                    ++j
                )
                {
                    flowBetween
                    (
                        grid, s, i, x, y, *other, j, x2, y2, dt, flows
                    );
                }
            }
        }

        const int nOut =
            (x == 0 && grid.open(0)) + (x == size[0] - 1 && grid.open(1))
          + (y == 0 && grid.open(2)) + (y == size[1] - 1 && grid.open(3));
        for (int out = 0; out < nOut; ++out)
        {
            for (int i = s.start[column]; i < s.start[column + 1]; ++i)
            {
                flowOut(grid, s.segments[i], dt, flows);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::filmFlows::find
(
    const voxelGrid& grid,
    openSegments& segments,
    const double dt
)
{
    const int n = int(segments.slots().size());
    flows_.resize(n);

    #pragma omp parallel for schedule(dynamic, 2)
    for (int sloti = 0; sloti < (film_.dependsOnStress() ? n : 0); ++sloti)
    {
        findSlopes(grid, segments, segments.slots()[sloti]);
    }

    #pragma omp parallel for schedule(dynamic, 2)
    for (int sloti = 0; sloti < n; ++sloti)
    {
        findOfSlot(grid, segments, sloti, dt);
    }
}

// ************************************************************************* //
