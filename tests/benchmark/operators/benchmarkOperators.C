/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    benchmarkOperators

Description
    Pair visits per second of each SPH operator, beside a ceiling measured in
    the same run: a plain momentum-like pass over a compact neighbour list
    (pairCeiling.H). Wendland C2, support 2.4 spacings, jittered lattice, no
    walls, lists without skin.

    The figures of one machine drift; the ratios hold.

Usage
    benchmarkOperators [particles along a side, default 58]

\*---------------------------------------------------------------------------*/

#include "artificialViscosity.H"
#include "conductionScale.H"
#include "heatConduction.H"
#include "pairCeiling.H"
#include "pressureForce.H"
#include "stressDivergence.H"
#include "velocityGradient.H"
#include "xsphVelocity.H"

#include <omp.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>

using namespace Foam::melt;

namespace
{

//- Particles on a jittered lattice of spacing 1, with random fields
particles jitteredLattice(const int side)
{
    particles f;
    f.resize(side*side*side);
    f.require({&f.dH, &f.du, &f.dv, &f.dw, &f.eta});
    for (particles::array& s : f.S)
    {
        f.require({&s});
    }

    std::mt19937 generator(1);
    std::uniform_real_distribution<double> jitter(-0.2, 0.2);
    for (int i = 0; i < f.size(); ++i)
    {
        f.x[i] = i%side + jitter(generator);
        f.y[i] = (i/side)%side + jitter(generator);
        f.z[i] = i/(side*side) + jitter(generator);
        f.u[i] = jitter(generator);
        f.v[i] = jitter(generator);
        f.w[i] = jitter(generator);
        f.p[i] = jitter(generator);
        f.T[i] = 300 + jitter(generator);
        f.rho[i] = f.m[i] = f.V[i] = 1;
        f.id[i] = i;
    }
    return f;
}


//- Shortest time of a few runs [s]
double shortest(const std::function<void()>& run)
{
    double best = 1e30;
    for (int repeat = 0; repeat < 7; ++repeat)
    {
        const auto start = std::chrono::steady_clock::now();
        run();
        const std::chrono::duration<double> taken =
            std::chrono::steady_clock::now() - start;
        best = std::min(best, taken.count());
    }
    return best;
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    const int side = argc > 1 ? std::atoi(argv[1]) : 58;

    particles f = jitteredLattice(side);
    wallState walls;
    neighbourhood near
    (
        smoothingKernel(smoothingKernel::kernelType::wendlandC2, 1.2, 3),
        0
    );
    near.build(f, walls);
    conductionScale(near.kernel(), 1).update(near, walls, 1, f);

    const double nPairs = double(near.fluid().nPairs());
    std::printf
    (
        "%d particles, %.1f neighbours a particle, lists %.0f bytes a"
        " particle\n",
        f.size(), nPairs/f.size(), double(near.bytes())/f.size()
    );

    const std::vector<std::pair<const char*, std::function<void()>>> operators
    {
        {"velocityGradient", [&]{ velocityGradient(near, walls, f, true); }},
        {"pressureForce", [&]{ addPressureForce(near, walls, f); }},
        {"stressDivergence", [&]{ addStressDivergence(near, walls, f); }},
        {"artificialViscosity", [&]{ addArtificialViscosity(near, 0.1, 1, 20, f); }},
        {"xsphVelocity", [&]{ xsphVelocity(near, 0.5, f); }},
        {"heatConduction", [&]{ heatConduction(near, walls, 1, 1, f); }},
        {"conductionScale", [&]
            {
                conductionScale(near.kernel(), 1).update(near, walls, 1, f);
            }},
        {"list build", [&]{ near.build(f, walls); }}
    };

    for (const int threads : {1, 2})
    {
        omp_set_num_threads(threads);
        pairCeiling ceiling(side, 2.4);
        const double top = ceiling.nPairs()/shortest([&]{ ceiling.pass(); });

        std::printf
        (
            "\n%d thread%s   million pairs/s   of the ceiling\n"
            "%-20s %10.1f %15s\n",
            threads, threads == 1 ? " " : "s", "ceiling", top/1e6, "1"
        );
        for (const auto& o : operators)
        {
            const double rate = nPairs/shortest(o.second);
            std::printf
            (
                "%-20s %10.1f %15.2f\n", o.first, rate/1e6, rate/top
            );
        }
    }
    return 0;
}

// ************************************************************************* //
