/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellGrid.H"

#include <algorithm>
#include <cmath>
#include <stdexcept>

int Foam::melt::cellGrid::coordinate
(
    const double position,
    const int axis
) const
{
    const int c =
        int(std::floor((position - origin_[axis])*inverseCell_[axis]));
    return periodic_[axis] ? (c%n_[axis] + n_[axis])%n_[axis] : c;
}


int Foam::melt::cellGrid::spansAround
(
    const int coordinate,
    const int axis,
    std::array<range, 2>& spans
) const
{
    const int last = n_[axis] - 1;
    spans[0] = {std::max(coordinate - 1, 0), std::min(coordinate + 1, last)};
    if (!periodic_[axis])
    {
        return spans[0].begin <= spans[0].end;
    }
    if (n_[axis] <= 3)
    {
        spans[0] = {0, last};
        return 1;
    }
    spans[1] = coordinate == 0 ? range{last, last} : range{0, 0};
    return coordinate == 0 || coordinate == last ? 2 : 1;
}


void Foam::melt::cellGrid::sort
(
    const double* x, const double* y, const double* z, const int n,
    const double cellSize, std::vector<int>& order,
    const periodicBox& box
)
{
    const std::array<const double*, 3> position{x, y, z};
    std::array<double, 3> high;

    double nCells = 1;
    for (int a = 0; a < 3; ++a)
    {
        origin_[a] = n ? *std::min_element(position[a], position[a] + n) : 0;
        high[a] = n ? *std::max_element(position[a], position[a] + n) : 0;
        inverseCell_[a] = 1/cellSize;
        double cells = std::floor((high[a] - origin_[a])*inverseCell_[a]) + 1;
        periodic_[a] = box.period(a) > 0;
        if (periodic_[a])
        {
            origin_[a] = box.lowest(a);
            cells = std::max(1.0, std::floor(box.period(a)/cellSize));
            inverseCell_[a] = cells/box.period(a);
        }
        nCells *= cells;
        if (!(nCells < 2e9))
        {
            throw std::runtime_error
            (
                "particles spread over too many cells: one of them has left"
                " the scene"
            );
        }
        n_[a] = int(cells);
    }

    axis_ = {0, 1, 2};
    std::stable_sort
    (
        axis_.begin(), axis_.end(),
        [&](const int a, const int b) { return n_[a] < n_[b]; }
    );

    const auto cellOf = [&](const int i)
    {
        const auto c = [&](const int k)
        {
            return coordinate(position[axis_[k]][i], axis_[k]);
        };
        return (c(2)*n_[axis_[1]] + c(1))*n_[axis_[0]] + c(0);
    };

    // Counting sort
    std::vector<int> cell(n);
    bool numbers = true;
    #pragma omp parallel for schedule(static) reduction(&&:numbers)
    for (int i = 0; i < n; ++i)
    {
        const bool number = !std::isnan(x[i] + y[i] + z[i]);
        numbers = numbers && number;
        cell[i] = number ? cellOf(i) : 0;
    }
    if (!numbers)
    {
        throw std::runtime_error("the position of a particle is not a number");
    }

    start_.assign(std::size_t(nCells) + 1, 0);
    for (int i = 0; i < n; ++i)
    {
        ++start_[cell[i] + 1];
    }
    for (std::size_t c = 1; c < start_.size(); ++c)
    {
        start_[c] += start_[c - 1];
    }

    order.resize(n);
    for (int i = 0; i < n; ++i)
    {
        order[start_[cell[i]]++] = i;
    }
    std::copy_backward(start_.begin(), start_.end() - 1, start_.end());
    start_[0] = 0;
}


int Foam::melt::cellGrid::neighbourRuns
(
    const double x, const double y, const double z,
    runs& found
) const
{
    const std::array<double, 3> position{x, y, z};
    std::array<std::array<range, 2>, 3> spans;
    std::array<int, 3> nSpans;
    for (int k = 0; k < 3; ++k)
    {
        const int a = axis_[k];
        nSpans[k] = spansAround(coordinate(position[a], a), a, spans[k]);
    }

    // Of each span along the two slower axes, every cell
    const auto forCells = [&](const int k, const auto& visit)
    {
        for (int s = 0; s < nSpans[k]; ++s)
        {
            for (int c = spans[k][s].begin; c <= spans[k][s].end; ++c)
            {
                visit(c);
            }
        }
    };

    int count = 0;
    forCells(2, [&](const int slow)
    {
        forCells(1, [&](const int middle)
        {
            const int row = (slow*n_[axis_[1]] + middle)*n_[axis_[0]];
            for (int s = 0; s < nSpans[0]; ++s)
            {
                const range& fast = spans[0][s];
                const range run
                {
                    start_[row + fast.begin], start_[row + fast.end + 1]
                };
                if (run.begin < run.end)
                {
                    found[count++] = run;
                }
            }
        });
    });
    return count;
}


int Foam::melt::cellGrid::reach() const
{
    // The 27 cells around a cell span at most this many cells of the sorted
    // order, before as behind
    const int span = (n_[axis_[1]] + 1)*n_[axis_[0]] + 1;
    const int nCells = int(start_.size()) - 1;

    int longest = 0;
    for (int c = 0; c < nCells; ++c)
    {
        const int last = std::min(c + span, nCells - 1);
        longest = std::max(longest, start_[last + 1] - start_[c]);
    }
    return longest;
}

// ************************************************************************* //
