/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    benchmarkAutomaton

Description
    What a step of the voxel automaton costs: stage by stage for the scene of a
    case from its latest time on, or (-pools) for 1 to 100 pools that spread on
    the floor of one and the same grid. With -balance the steps are not
    measured, but ten times on the way mass and energy are balanced. With
    -published: how a drop spreads by the published rule.

    Times are CPU times, which other programs on the machine disturb least;
    with one thread they are those of the clock on a quiet machine.

    The traffic counted is what has to be moved at least: in spreading, falling
    and filtering each brick with something in it is read and written once.

Usage
    \b benchmarkAutomaton -case <dir> [-steps <n>] [-balance]
        | -pools | -published

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "densityField.H"
#include "fvMesh.H"
#include "memoryBandwidth.H"
#include "meltScene.H"
#include "publishedSpreading.H"
#include "sigFpe.H"
#include "Time.H"
#include "voxelAutomatonMethod.H"

#include <cmath>
#include <cstdio>
#include <functional>

using namespace Foam;
using namespace Foam::melt;

namespace
{

//- CPU time of an action [s]
double seconds(const std::function<void()>& action)
{
    const std::clock_t begin = std::clock();
    action();
    return double(std::clock() - begin)/CLOCKS_PER_SEC;
}


//- The scene's method at its latest time, given to an action
void atLatestTime
(
    Time& runTime,
    const std::function<void(voxelAutomatonMethod&)>& action
)
{
    const instantList times(runTime.times());
    runTime.setTime(times.last(), times.size() - 1);
    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );
    const meltScene scene(mesh);
    voxelAutomatonMethod method(mesh, scene);

    action(method);
}


void balance(voxelAutomatonMethod& method, const label nSteps)
{
    for (label step = 1; step <= nSteps; ++step)
    {
        method.advance(method.maxDeltaT());
        if (step % max(nSteps/10, 1) == 0)
        {
            Info<< "step " << step << ": ";
            method.report(Info.operator OSstream&());
            const meltDiagnostics d(method.diagnostics());
            Info<< "     mass " << d.mass << " kg, heat in " << d.heatIn
                << " J, out " << d.heatOut << " J" << endl;
        }
    }
}


void measure(voxelAutomatonMethod& method, Time& runTime, const label nSteps)
{
    // The first step is not like the others: all is new
    scalar slowest = 0, sum = 0, nFiltered = 0, nVoxels = 0, nBricks = 0;
    stageTimes before;
    for (label step = 0; step <= nSteps; ++step)
    {
        const double spent = seconds
        (
            [&]
            {
                method.advance(method.maxDeltaT());
            }
        );
        nFiltered += step ? method.updateDensity() : 0;
        if (step == 0)
        {
            method.updateDensity();
            before = method.times();
            continue;
        }
        slowest = max(slowest, spent);
        sum += spent;
        nVoxels += method.nVoxels(true, true);
        nBricks += method.nBricks();
    }

    const stageTimes& after = method.times();
    nVoxels /= nSteps;
    nBricks /= nSteps;
    std::printf
    (
        "%s, t = %s s: %.0f voxels, %d of them liquid, in %.0f bricks\n"
        "    a step: mean %.2f ms, longest %.2f ms, %.1f ns a voxel\n",
        runTime.caseName().c_str(),
        runTime.timeName().c_str(),
        nVoxels,
        int(method.nVoxels(true, false)),
        nBricks,
        1e3*sum/nSteps,
        1e3*slowest,
        1e9*sum/nSteps/nVoxels
    );
    const double bandwidth = memoryBandwidth();
    for (std::size_t i = 0; i < after.names.size(); ++i)
    {
        const double spent =
            max(after.seconds[i] - before.seconds[i], 1e-12)/nSteps;
        const double nMoved =
            i == stageTimes::DENSITY ? nFiltered/nSteps : nBricks;
        const double bytes = 2*sizeof(voxelBrick)*nMoved/spent;
        std::printf
        (
            "    %-9s %8.3f ms, %6.1f ns a voxel",
            after.names[i],
            1e3*spent,
            1e9*spent/nVoxels
        );
        if
        (
            i == stageTimes::SPREADING
         || i == stageTimes::FALLING
         || i == stageTimes::DENSITY
        )
        {
            std::printf
            (
                ", %5.2f GB/s, %.2f of the triad's %.1f",
                bytes/1e9,
                bytes/bandwidth,
                bandwidth/1e9
            );
        }
        std::printf("\n");
    }
}


//- Time of a step [s] for side^2 pools of 32 x 32 x 4 voxels on the floor of
//  one and the same grid
double poolStep(const int side, scalar& nVoxels)
{
    const int edge = 32, distance = 48;
    const double dx = 1e-3;
    const enthalpyCurve curve{1000, 1000, 300, 310, 2e5};
    voxelGrid grid
    (
        {480, 480, 32},
        dx,
        voxelMaterial(curve, 1000, 0.2, 0.2, 0.5, dx, 250, 400)
    );
    for (int x = 0; x < side*distance; ++x)
    {
        for (int y = 0; y < side*distance; ++y)
        {
            for (int z = 0; z < 4; ++z)
            {
                if (x % distance < edge && y % distance < edge)
                {
                    grid.fill(x, y, z, 1, 350);
                }
            }
        }
    }
    grid.refresh();
    const filmViscosity film
    (
        [](double, double) { return 10.0; }, false, 250, 400, 1, 1e5, 0
    );
    lubricationRule lubrication(film, 9810, 10, 10);
    gravityRule gravity(film, 9.81, 0.004);
    voxelConduction conduction(18);
    densityField density;

    const int nSteps = 20;
    double best = 1e30;
    for (int step = 0; step < nSteps; ++step)
    {
        best = min
        (
            best,
            seconds
            (
                [&]
                {
                    const double dt =
                        min(lubrication.prepare(grid), gravity.maxDeltaT(grid));
                    lubrication.spread(grid, dt);
                    gravity.fall(grid, dt);
                    conduction.conduct(grid, dt);
                    density.update(grid);
                }
            )
        );
    }
    nVoxels = 0;
    for (const int index : grid.list())
    {
        nVoxels += grid.brick(index).nLiquid;
    }
    std::printf
    (
        "    %8.0f voxels: %7.3f ms, %6.1f ns and %.0f bytes a voxel\n",
        nVoxels,
        1e3*best,
        1e9*best/nVoxels,
        grid.bytes()/nVoxels
    );
    return best;
}


void benchmarkPools()
{
    // Regression of log(time) on log(voxels)
    scalar n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    std::printf
    (
        "Pools in a grid of 480 x 480 x 32: spreading, falling, conduction and"
        " filter\n"
    );
    for (const int side : {1, 2, 3, 6, 10})
    {
        scalar nVoxels = 0;
        const double spent = poolStep(side, nVoxels);
        const scalar x = std::log(nVoxels), y = std::log(spent);
        n += 1;
        sx += x;
        sy += y;
        sxx += x*x;
        sxy += x*y;
    }
    std::printf
    (
        "    slope of log(time) against log(voxels): %.2f\n",
        (n*sxy - sx*sy)/(n*sxx - sx*sx)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::noParallel();
    argList::noBanner();
    argList::addOption("steps", "n", "Number of steps (default: 50)");
    argList::addBoolOption("balance", "Mass and energy instead of times");
    argList::addBoolOption("published", "A drop by the published rule");
    argList::addBoolOption("pools", "1 to 100 pools instead of a case");
    argList args(argc, argv);
    sigFpe::unset();

    if (args.found("pools"))
    {
        benchmarkPools();
    }
    else if (args.found("published"))
    {
        publishedSpreading();
    }
    else
    {
        Time runTime(Time::controlDictName, args);
        const label nSteps = args.opt<label>("steps", 50);
        atLatestTime
        (
            runTime,
            [&](voxelAutomatonMethod& method)
            {
                args.found("balance")
              ? balance(method, nSteps) : measure(method, runTime, nSteps);
            }
        );
    }
    return 0;
}

// ************************************************************************* //
