/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lubricationRule.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Portion of a difference that a column gives to one of four neighbours without
// overshoot
constexpr double maxPortion = 0.2;

// Longest step where there is no limit [s]
constexpr double unlimited = 1e30;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double Foam::melt::lubricationRule::portion
(
    const voxelGrid& grid,
    const openSegment& donor,
    const double receiverBase,
    const double receiverSurface,
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
    const double fluidity = film_.fluidity(donor.T, weight_*thick*dx*slope);
    const double cube = 0.25*(thick + thin)*(thick*thick + thin*thin);
    const double mobility = weight_*fluidity*dt*dx/3*cube;

    return std::min({mobility*slope, maxPortion*drop, maxPortion*h});
}


void Foam::melt::lubricationRule::flowBetween
(
    const voxelGrid& grid,
    openSegment& a, const int ax, const int ay,
    openSegment& b, const int bx, const int by,
    const double dt,
    std::vector<flow>& flows
) const
{
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

    double height = portion
    (
        grid, donor, receiver.base, receiver.surface(), openingTop, dt
    );
    if (!(height > 0))
    {
        return;
    }

    flow f{&donor, &receiver, 0, fromA ? bx : ax, fromA ? by : ay, -1};
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
        #pragma omp atomic
        receiver.in += f.mass;
        #pragma omp atomic
        donor.out += f.mass;
    }
}


void Foam::melt::lubricationRule::flowOut
(
    const voxelGrid& grid,
    openSegment& donor,
    const double dt,
    std::vector<flow>& flows
) const
{
    const double height =
        donor.height > 0
      ? portion(grid, donor, donor.base, donor.base, donor.z1, dt)
      : 0;
    const auto mass = std::int64_t(height*voxelMaterial::full);
    if (mass > 0)
    {
        flows.push_back({&donor, nullptr, mass, 0, 0, -1});
        #pragma omp atomic
        donor.out += mass;
    }
}


void Foam::melt::lubricationRule::findFlows(voxelGrid& grid, const double dt)
{
    std::vector<openSegments::slot>& slots = segments_.slots();
    const int n = int(slots.size());
    flows_.resize(n);
    const std::array<int, 3>& size = grid.n();

    #pragma omp parallel for schedule(dynamic, 2)
    for (int sloti = 0; sloti < n; ++sloti)
    {
        openSegments::slot& s = slots[sloti];
        std::vector<flow>& flows = flows_[sloti];
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
                openSegments::slot* other =
                    segments_.slotOfColumn(grid, x2, y2);
                if (!other)
                {
                    continue;
                }
                const int column2 = (x2 & 7)*8 + (y2 & 7);
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
                            grid,
                            s.segments[i], x, y,
                            other->segments[j], x2, y2,
                            dt,
                            flows
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
}


void Foam::melt::lubricationRule::take
(
    voxelGrid& grid,
    const int x,
    const int y,
    openSegment& s
)
{
    std::int64_t wanted = s.out;
    for (int z = s.top; wanted > 0; --z)
    {
        voxelBrick& b = grid.ownAt(x, y, z);
        const int i = voxelBrick::offset(x, y, z);
        const std::int64_t mass = std::min<std::int64_t>(wanted, b.mass[i]);
        const std::int64_t energy =
            mass == b.mass[i]
          ? b.energy[i]
          : voxelMaterial::share(b.energy[i], mass, b.mass[i]);
        b.mass[i] -= std::int32_t(mass);
        b.energy[i] -= energy;
        b.changed = true;
        s.outEnergy += energy;
        wanted -= mass;
        if (b.mass[i] == 0)
        {
            s.top = z - 1;
        }
    }
}


void Foam::melt::lubricationRule::deliver(voxelGrid& grid, flow& f)
{
    const std::int64_t energy =
        voxelMaterial::share(f.donor->outEnergy, f.mass, f.donor->out);

    // What the shares leave over stays with the donor
    #pragma omp atomic
    f.donor->inEnergy -= energy;

    if (!f.receiver)
    {
        #pragma omp atomic
        lostMass_ += f.mass;
        #pragma omp atomic
        lostEnergy_ += energy;
    }
    else if (f.z < 0)
    {
        #pragma omp atomic
        f.receiver->inEnergy += energy;
    }
    else
    {
        voxelBrick& b = grid.ownAt(f.x, f.y, f.z);
        const int i = voxelBrick::offset(f.x, f.y, f.z);
        #pragma omp atomic
        b.mass[i] += std::int32_t(f.mass);
        #pragma omp atomic
        b.energy[i] += energy;
        b.changed = true;
    }
}


void Foam::melt::lubricationRule::put
(
    voxelGrid& grid,
    const int x,
    const int y,
    openSegment& s
)
{
    // The excess of a voxel goes to the one above, and below the ceiling down
    std::int64_t mass = s.in;
    std::int64_t energy = s.inEnergy + s.outEnergy;
    const int start = std::max(s.top, s.z0);
    int z = start;
    int step = 1;
    while (mass > 0)
    {
        if (z > s.z1)
        {
            z = start - 1;
            step = -1;
        }
        voxelBrick& b = grid.ownAt(x, y, z);
        const int i = voxelBrick::offset(x, y, z);
        const std::int64_t moved =
            std::min<std::int64_t>(mass, b.capacity(i) - b.mass[i]);
        if (moved > 0)
        {
            const std::int64_t share =
                moved == mass
              ? energy : voxelMaterial::share(energy, moved, mass);
            b.mass[i] += std::int32_t(moved);
            b.energy[i] += share;
            b.changed = true;
            mass -= moved;
            energy -= share;
        }
        z += step;
    }
    if (energy)
    {
        voxelBrick& b = grid.ownAt(x, y, start);
        b.energy[voxelBrick::offset(x, y, start)] += energy;
        b.changed = true;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::lubricationRule::lubricationRule
(
    const filmViscosity& film,
    const double weight,
    const double thicknessLimit,
    const double waveSteps
)
:
    film_(film),
    weight_(weight),
    thicknessLimit_(thicknessLimit),
    waveSteps_(waveSteps)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::lubricationRule::spread(voxelGrid& grid, const double dt)
{
    findFlows(grid, dt);

    std::vector<openSegments::slot>& slots = segments_.slots();
    const int n = int(slots.size());
    double speed = 0;

    // A segment gives no more than it has and takes no more than it has room
    // for
    #pragma omp parallel for schedule(dynamic, 4) reduction(max:speed)
    for (int sloti = 0; sloti < n; ++sloti)
    {
        for (flow& f : flows_[sloti])
        {
            const openSegment& donor = *f.donor;
            const openSegment* receiver = f.receiver;
            std::int64_t mass = f.mass;
            if (donor.out > donor.mass)
            {
                mass = voxelMaterial::share(f.mass, donor.mass, donor.out);
            }
            if (receiver && receiver->in > receiver->room)
            {
                mass = std::min
                (
                    mass,
                    voxelMaterial::share
                    (
                        f.mass, receiver->room, receiver->in
                    )
                );
            }
            f.mass = mass;
            speed = std::max(speed, double(mass)/donor.mass);
        }
    }
    maxSpeed_ = speed*grid.dx()/dt;

    const auto forAllSegments = [&](auto&& action)
    {
        #pragma omp parallel for schedule(dynamic, 4)
        for (int sloti = 0; sloti < n; ++sloti)
        {
            openSegments::slot& s = slots[sloti];
            for (int column = 0; column < 64; ++column)
            {
                const int x = 8*s.bx + column/8, y = 8*s.by + column % 8;
                for (int i = s.start[column]; i < s.start[column + 1]; ++i)
                {
                    action(x, y, s.segments[i]);
                }
            }
        }
    };

    forAllSegments
    (
        [](const int, const int, openSegment& s)
        {
            s.in = 0;
            s.out = 0;
        }
    );

    #pragma omp parallel for schedule(dynamic, 4)
    for (int sloti = 0; sloti < n; ++sloti)
    {
        for (const flow& f : flows_[sloti])
        {
            #pragma omp atomic
            f.donor->out += f.mass;
            if (f.receiver && f.z < 0)
            {
                #pragma omp atomic
                f.receiver->in += f.mass;
            }
        }
    }

    forAllSegments
    (
        [&](const int x, const int y, openSegment& s)
        {
            if (s.out > 0)
            {
                take(grid, x, y, s);
            }
        }
    );

    #pragma omp parallel for schedule(dynamic, 4)
    for (int sloti = 0; sloti < n; ++sloti)
    {
        for (flow& f : flows_[sloti])
        {
            if (f.mass > 0)
            {
                deliver(grid, f);
            }
        }
    }

    forAllSegments
    (
        [&](const int x, const int y, openSegment& s)
        {
            if (s.in > 0 || s.inEnergy + s.outEnergy)
            {
                put(grid, x, y, s);
            }
        }
    );

    grid.refresh();
}


double Foam::melt::lubricationRule::prepare(voxelGrid& grid)
{
    segments_.build(grid);
    if (weight_ <= 0)
    {
        return unlimited;
    }
    const double dx = grid.dx();
    const double g = weight_/grid.material().rho;
    double fastest = 0;
    for (const openSegments::slot& s : segments_.slots())
    {
        for (const openSegment& segment : s.segments)
        {
            if (segment.height > 0)
            {
                const double h = std::min(segment.height, thicknessLimit_);
                const double viscous =
                    weight_*film_.fluidity(segment.T, weight_*h*dx)*h*h*h*dx
                   /(3*maxPortion);
                const double wave = waveSteps_*std::sqrt(g*h/dx);
                fastest = std::max(fastest, std::min(viscous, wave));
            }
        }
    }
    return fastest > 0 ? 1/fastest : unlimited;
}

// ************************************************************************* //
