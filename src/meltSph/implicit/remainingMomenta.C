/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remainingMomenta.H"
#include "solidBody.H"

void Foam::melt::addRemainingMomenta
(
    const particles& f,
    const std::vector<float>& share,
    const vectorArray& r,
    const bool spin,
    vectorArray& v
)
{
    const int n = f.size();
    const auto position = [&](const int i)
    {
        return vector(f.x[i], f.y[i], f.z[i]);
    };

    double mass = 0;
    vector centre(Zero), momentum(Zero);
    for (int i = 0; i < n; ++i)
    {
        mass += share[i]*f.m[i];
        centre += share[i]*f.m[i]*position(i);
        momentum += vector(r.x[i], r.y[i], r.z[i]);
    }
    if (!(mass > 0))
    {
        return;
    }
    centre /= mass;

    vector angularMomentum(Zero);
    symmTensor inertia(Zero);
    for (int i = 0; spin && i < n; ++i)
    {
        const vector arm(position(i) - centre);
        angularMomentum += arm ^ vector(r.x[i], r.y[i], r.z[i]);
        inertia += share[i]*f.m[i]*(magSqr(arm)*symmTensor::I - sqr(arm));
    }
    const vector U(momentum/mass);
    const vector omega(solidBody::pseudoInverse(inertia) & angularMomentum);

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const vector added(share[i]*(U + (omega ^ (position(i) - centre))));
        v.x[i] += added.x();
        v.y[i] += added.y();
        v.z[i] += added.z();
    }
}

// ************************************************************************* //
