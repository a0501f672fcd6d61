/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeSymbol.H"

#include <cmath>

double Foam::melt::unitTest::latticeSum
(
    const lattice& points,
    const std::function<double(double, double, double, double, double)>& f
)
{
    const smoothingKernel kernel
    (
        points.kernel, points.h(), points.dimensions()
    );
    const double dx = points.spacing;
    const int n = int(kernel.support()/dx) + 1;
    const int nz = points.dimensions() == 2 ? 0 : n;

    double sum = 0;
    kernel.visit([&](const auto& W)
    {
        for (int k = -nz; k <= nz; ++k)
        {
            for (int j = -n; j <= n; ++j)
            {
                for (int i = -n; i <= n; ++i)
                {
                    const double r2 = dx*dx*(i*i + j*j + k*k);
                    if (r2 > 0)
                    {
                        sum += f
                        (
                            dx*i, dx*j, dx*k,
                            W.value(r2), W.gradientOverR(r2)
                        );
                    }
                }
            }
        }
    });
    return points.particleVolume()*sum;
}


double Foam::melt::unitTest::gradientGain(const lattice& points, const double k)
{
    return latticeSum
    (
        points,
        [=](double x, double, double, double, double F)
        {
            return -F*x*(k > 0 ? std::sin(k*x)/k : x);
        }
    );
}


double Foam::melt::unitTest::laplacianGain
(
    const lattice& points,
    const double k
)
{
    return latticeSum
    (
        points,
        [=](double x, double, double, double, double F)
        {
            return -2*F*(1 - std::cos(k*x))/(k*k);
        }
    );
}


double Foam::melt::unitTest::smoothingGain
(
    const lattice& points,
    const double k,
    const double epsilon
)
{
    return 1 - epsilon*latticeSum
    (
        points,
        [=](double x, double, double, double W, double)
        {
            return W*(1 - std::cos(k*x));
        }
    );
}


double Foam::melt::unitTest::waveNumber(const lattice& points, const int n)
{
    return 2*M_PI/(n*points.spacing);
}


double Foam::melt::unitTest::orderOf(const std::vector<double>& errors)
{
    const std::size_t n = errors.size();
    return std::log2(errors[n - 2]/errors[n - 1]);
}

// ************************************************************************* //
