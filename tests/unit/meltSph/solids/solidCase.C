/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidCase.H"

#include <set>

Foam::melt::unitTest::momenta::momenta
(
    const particles& f,
    const std::vector<double>& u,
    const std::vector<double>& v,
    const std::vector<double>& w
)
{
    for (int i = 0; i < f.size(); ++i)
    {
        const vector U(u[i], v[i], w[i]);
        linear += f.m[i]*U;
        angular += f.m[i]*(vector(f.x[i], f.y[i], f.z[i]) ^ U);
        energy += 0.5*f.m[i]*magSqr(U);
    }
}


Foam::melt::unitTest::solidCase::solidCase
(
    const particleCloud& cloud,
    const std::string& entries
)
:
    scheme(cloud, springAndDamper(1, 0)),
    system(scheme.system),
    f(system.fluid),
    model(solidModel::New(dictionary(IStringStream(entries)()), system))
{
    model->allocate();
}


void Foam::melt::unitTest::solidCase::setSolid
(
    const std::function<bool(double, double, double)>& solid
)
{
    for (int i = 0; i < f.size(); ++i)
    {
        f.h[i] = solid(f.x[i], f.y[i], f.z[i]) ? -1e3 : 1e3;
    }
}


int Foam::melt::unitTest::solidCase::nBodies() const
{
    std::set<int> bodies(f.body.begin(), f.body.end());
    bodies.erase(-1);
    return int(bodies.size());
}


Foam::melt::unitTest::particleCloud Foam::melt::unitTest::movingLump
(
    const unsigned seed,
    const std::array<int, 3>& n
)
{
    particleCloud cloud
    (
        lattice{n, 0.01, smoothingKernel::kernelType::wendlandC2, 1.3, 0.1},
        seed
    );
    cloud.randomiseDensity(0.05);
    cloud.randomiseVelocity(1);
    return cloud;
}

// ************************************************************************* //
