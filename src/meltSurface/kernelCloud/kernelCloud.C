/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "kernelCloud.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace
{

double square(const double a)
{
    return a*a;
}

}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::kernelCloud::kernelCloud
(
    const std::size_t n,
    const double* position,
    const double* volume,
    const double radius
)
:
    radius_(radius),
    origin_{{0, 0, 0}},
    nCells_{{1, 1, 1}},
    cell_(n),
    index_(n),
    position_(n),
    volume_(n)
{
    if (!(radius > 0))
    {
        throw std::invalid_argument("kernelCloud: radius must be positive");
    }

    for (std::size_t d = 0; d < 3 && n; ++d)
    {
        double low = position[d];
        double high = low;
        for (std::size_t i = 1; i < n; ++i)
        {
            low = std::min(low, position[3*i + d]);
            high = std::max(high, position[3*i + d]);
        }
        origin_[d] = low;
        nCells_[d] = std::int64_t((high - low)/radius) + 1;
    }

    std::vector<std::int64_t> cell(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        std::array<std::int64_t, 3> c;
        for (std::size_t d = 0; d < 3; ++d)
        {
            c[d] = std::int64_t((position[3*i + d] - origin_[d])/radius);
        }
        cell[i] = c[0] + nCells_[0]*(c[1] + nCells_[1]*c[2]);
    }

    std::iota(index_.begin(), index_.end(), 0);
    std::stable_sort
    (
        index_.begin(),
        index_.end(),
        [&](const std::size_t a, const std::size_t b)
        {
            return cell[a] < cell[b];
        }
    );
    for (std::size_t s = 0; s < n; ++s)
    {
        const std::size_t i = index_[s];
        cell_[s] = cell[i];
        position_[s] =
            {{position[3*i], position[3*i + 1], position[3*i + 2]}};
        volume_[s] = volume[i];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::melt::kernelCloud::kernel(const double r, const double radius)
{
    const double q = r/radius;
    if (q >= 1)
    {
        return 0;
    }
    return 21/(2*M_PI*radius*radius*radius)*square(square(1 - q))*(1 + 4*q);
}


template<class Action>
void Foam::melt::kernelCloud::forNeighbours
(
    const double* x,
    const Action& action
) const
{
    std::array<std::int64_t, 3> low, high;
    for (std::size_t d = 0; d < 3; ++d)
    {
        const double c = std::floor((x[d] - origin_[d])/radius_);
        if (!(c >= -1 && c <= nCells_[d]))
        {
            return;
        }
        low[d] = std::max<std::int64_t>(std::int64_t(c) - 1, 0);
        high[d] = std::min<std::int64_t>(std::int64_t(c) + 1, nCells_[d] - 1);
    }

    for (std::int64_t k = low[2]; k <= high[2]; ++k)
    {
        for (std::int64_t j = low[1]; j <= high[1]; ++j)
        {
            const std::int64_t row = nCells_[0]*(j + nCells_[1]*k);
            auto s = std::lower_bound
            (
                cell_.begin(), cell_.end(), row + low[0]
            ) - cell_.begin();

            const auto n = std::ptrdiff_t(cell_.size());
            for (; s < n && cell_[s] <= row + high[0]; ++s)
            {
                const auto& p = position_[s];
                const double r = std::sqrt
                (
                    square(x[0] - p[0]) + square(x[1] - p[1])
                  + square(x[2] - p[2])
                );
                if (r < radius_)
                {
                    action(s, r);
                }
            }
        }
    }
}


std::vector<double> Foam::melt::kernelCloud::chi
(
    const std::size_t m,
    const double* point
) const
{
    std::vector<double> result(m);

    #pragma omp parallel for schedule(dynamic, 256)
    for (std::size_t i = 0; i < m; ++i)
    {
        double sum = 0;
        forNeighbours
        (
            &point[3*i],
            [&](const std::size_t s, const double r)
            {
                sum += volume_[s]*kernel(r, radius_);
            }
        );
        result[i] = sum;
    }
    return result;
}


std::vector<double> Foam::melt::kernelCloud::normals
(
    const std::size_t m,
    const double* point
) const
{
    std::vector<double> result(3*m);

    #pragma omp parallel for schedule(dynamic, 256)
    for (std::size_t i = 0; i < m; ++i)
    {
        const double* x = &point[3*i];
        std::array<double, 3> sum{{0, 0, 0}};
        forNeighbours
        (
            x,
            [&](const std::size_t s, const double r)
            {
                // -grad W is along x - x_s, proportional to (1 - r/R)^3
                const double q = 1 - r/radius_;
                const double w = volume_[s]*q*q*q;
                for (std::size_t d = 0; d < 3; ++d)
                {
                    sum[d] += w*(x[d] - position_[s][d]);
                }
            }
        );
        const double length = std::sqrt
        (
            square(sum[0]) + square(sum[1]) + square(sum[2])
        );
        if (length > 0)
        {
            for (std::size_t d = 0; d < 3; ++d)
            {
                result[3*i + d] = sum[d]/length;
            }
        }
    }
    return result;
}


std::vector<double> Foam::melt::kernelCloud::interpolate
(
    const std::size_t m,
    const double* point,
    const double* field
) const
{
    std::vector<double> result(m);

    #pragma omp parallel for schedule(dynamic, 256)
    for (std::size_t i = 0; i < m; ++i)
    {
        double sum = 0;
        double weight = 0;
        double low = std::numeric_limits<double>::max();
        double high = std::numeric_limits<double>::lowest();
        forNeighbours
        (
            &point[3*i],
            [&](const std::size_t s, const double r)
            {
                const double w = volume_[s]*kernel(r, radius_);
                const double f = field[index_[s]];
                sum += w*f;
                weight += w;
                low = std::min(low, f);
                high = std::max(high, f);
            }
        );

        // Round-off must not leave the particles' range
        result[i] =
            weight > 0 ? std::min(std::max(sum/weight, low), high) : 0;
    }
    return result;
}
