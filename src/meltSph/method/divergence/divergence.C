/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "divergence.H"
#include "blockSum.H"
#include "error.H"
#include "vector.H"

#include <cmath>

bool Foam::melt::densityIsPositive(const particles& f)
{
    return blockSum
    (
        f.size(),
        [&](const int i) { return f.rho[i] > 0 ? 0.0 : 1.0; }
    ) == 0;
}


int Foam::melt::divergedParticle(const particles& f)
{
    const int n = f.size();
    double mean[3] = {0, 0, 0};

    for (int i = 0; i < n; ++i)
    {
        if
        (
            !std::isfinite(f.x[i] + f.y[i] + f.z[i])
         || !std::isfinite(f.u[i] + f.v[i] + f.w[i])
         || !(f.rho[i] > 0)
        )
        {
            return i;
        }
        mean[0] += f.x[i]/n;
        mean[1] += f.y[i]/n;
        mean[2] += f.z[i]/n;
    }

    int farthest = -1;
    double longest = -1;
    for (int i = 0; i < n; ++i)
    {
        const double way = std::hypot
        (
            f.x[i] - mean[0], f.y[i] - mean[1], f.z[i] - mean[2]
        );
        if (way > longest)
        {
            longest = way;
            farthest = i;
        }
    }
    return farthest;
}


void Foam::melt::endDivergedRun
(
    const particles& f,
    const scalar time,
    const std::string& reason,
    const int particlei
)
{
    FatalErrorInFunction
        << "The run has diverged at time " << time << " s: "
        << reason.c_str() << '.' << nl;

    const int i = particlei < 0 ? divergedParticle(f) : particlei;
    if (i >= 0)
    {
        FatalError
            << "Particle " << f.id[i] << ": position "
            << vector(f.x[i], f.y[i], f.z[i]) << " m, velocity "
            << vector(f.u[i], f.v[i], f.w[i]) << " m/s, density "
            << f.rho[i] << " kg/m3" << nl;
    }

    FatalError
        << "Results written before are as they were. Try smaller coefficients"
        << " in timeStep of system/sphSolution" << exit(FatalError);
}

// ************************************************************************* //
