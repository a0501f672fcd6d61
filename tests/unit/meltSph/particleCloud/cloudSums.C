/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudSums.H"

#include <cmath>

std::array<double, 3> Foam::melt::unitTest::massSum
(
    const particles& f,
    const particles::array& x,
    const particles::array& y,
    const particles::array& z
)
{
    std::array<double, 3> sum{0, 0, 0};
    for (int i = 0; i < f.size(); ++i)
    {
        sum[0] += f.m[i]*x[i];
        sum[1] += f.m[i]*y[i];
        sum[2] += f.m[i]*z[i];
    }
    return sum;
}


double Foam::melt::unitTest::massSumMag
(
    const particles& f,
    const particles::array& x,
    const particles::array& y,
    const particles::array& z
)
{
    double sum = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        sum += f.m[i]*std::hypot(x[i], y[i], z[i]);
    }
    return sum;
}


std::array<double, 3> Foam::melt::unitTest::torque(const particles& f)
{
    std::array<double, 3> sum{0, 0, 0};
    for (int i = 0; i < f.size(); ++i)
    {
        sum[0] += f.m[i]*(f.y[i]*f.az[i] - f.z[i]*f.ay[i]);
        sum[1] += f.m[i]*(f.z[i]*f.ax[i] - f.x[i]*f.az[i]);
        sum[2] += f.m[i]*(f.x[i]*f.ay[i] - f.y[i]*f.ax[i]);
    }
    return sum;
}


double Foam::melt::unitTest::power(const particles& f)
{
    double sum = 0;
    for (int i = 0; i < f.size(); ++i)
    {
        sum += f.m[i]*(f.u[i]*f.ax[i] + f.v[i]*f.ay[i] + f.w[i]*f.az[i]);
    }
    return sum;
}

// ************************************************************************* //
