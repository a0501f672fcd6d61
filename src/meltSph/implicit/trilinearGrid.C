/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "trilinearGrid.H"
#include "nestedDissection.H"
#include "particles.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using index = std::array<std::int64_t, 3>;

//- Sorted, each once
template<class Item>
void makeSet(std::vector<Item>& a)
{
    std::sort(a.begin(), a.end());
    a.erase(std::unique(a.begin(), a.end()), a.end());
}


template<class Item>
int find(const std::vector<Item>& sorted, const Item& item)
{
    return std::lower_bound(sorted.begin(), sorted.end(), item) - sorted.begin();
}


//- Starts of the rows in which the items of each key lie, and the items
void groupBy
(
    const std::vector<int>& keys,
    const int nKeys,
    std::vector<int>& starts,
    std::vector<int>& items
)
{
    starts.assign(nKeys + 1, 0);
    for (const int key : keys)
    {
        ++starts[key + 1];
    }
    for (int key = 0; key < nKeys; ++key)
    {
        starts[key + 1] += starts[key];
    }
    items.resize(keys.size());
    std::vector<int> next(starts.begin(), starts.end() - 1);
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
        items[next[keys[i]]++] = int(i);
    }
}


//- Functions of a cell's corners at a point, 0 to 1 along each side
inline std::array<double, Foam::melt::trilinearGrid::nCorners> cornerValues
(
    const std::array<double, 3>& s
)
{
    const double x[2] = {1 - s[0], s[0]};
    const double yz[4] =
    {
        (1 - s[1])*(1 - s[2]), s[1]*(1 - s[2]), (1 - s[1])*s[2], s[1]*s[2]
    };
    return
    {
        x[0]*yz[0], x[1]*yz[0], x[0]*yz[1], x[1]*yz[1],
        x[0]*yz[2], x[1]*yz[2], x[0]*yz[3], x[1]*yz[3]
    };
}

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Space>
inline std::array<double, 3> Foam::melt::trilinearGrid::local
(
    const particles& f,
    const int cell,
    const int i,
    const Space& space
) const
{
    const std::array<double, 3>& centre = centres_[cell];
    double dx = f.x[i] - centre[0];
    double dy = f.y[i] - centre[1];
    double dz = f.z[i] - centre[2];
    space.nearestImage(dx, dy, dz);
    return
    {
        0.5 + dx*perSize_[0], 0.5 + dy*perSize_[1], 0.5 + dz*perSize_[2]
    };
}


template<class Space, class Visit>
inline void Foam::melt::trilinearGrid::forValues
(
    const particles& f,
    const int cell,
    const Visit& visit,
    const Space& space
) const
{
    for (int k = startMembers_[cell]; k < startMembers_[cell + 1]; ++k)
    {
        const int i = members_[k];
        visit(i, cornerValues(local(f, cell, i, space)));
    }
}


template<class Visit>
inline void Foam::melt::trilinearGrid::forValues
(
    const particles& f,
    const int cell,
    const Visit& visit
) const
{
    if (box_.any())
    {
        forValues(f, cell, visit, box_);
    }
    else
    {
        forValues(f, cell, visit, openSpace());
    }
}


void Foam::melt::trilinearGrid::setSizes
(
    const periodicBox& box,
    const double cellSize
)
{
    box_ = box;
    for (int d = 0; d < 3; ++d)
    {
        const double period = box.period(d);
        nInPeriod_[d] = std::int64_t(std::ceil(period/cellSize));
        size_[d] = nInPeriod_[d] ? period/double(nInPeriod_[d]) : cellSize;
        perSize_[d] = 1/size_[d];
    }
}


std::array<std::int64_t, 3> Foam::melt::trilinearGrid::cellAt
(
    const particles& f,
    const int i
) const
{
    const double x[3] = {f.x[i], f.y[i], f.z[i]};
    index cell;
    for (int d = 0; d < 3; ++d)
    {
        cell[d] =
            nInPeriod_[d]
          ? std::min
            (
                std::int64_t((box_.inside(x[d], d) - box_.lowest(d))/size_[d]),
                nInPeriod_[d] - 1
            )
          : std::int64_t(std::floor(x[d]/size_[d]));
    }
    return cell;
}


void Foam::melt::trilinearGrid::setCorners(const std::vector<index>& cells)
{
    const auto corner = [&](index cell, const int c)
    {
        for (int d = 0; d < 3; ++d)
        {
            cell[d] += (c >> d) & 1;
            cell[d] -= nInPeriod_[d] && cell[d] == nInPeriod_[d] ? cell[d] : 0;
        }
        return cell;
    };

    std::vector<index> nodes;
    nodes.reserve(nCorners*cells.size());
    for (const index& cell : cells)
    {
        for (int c = 0; c < nCorners; ++c)
        {
            nodes.push_back(corner(cell, c));
        }
    }
    makeSet(nodes);
    const std::vector<int> place(nestedDissection(nodes, nInPeriod_));

    corners_.resize(cells.size());
    std::vector<int> nodeOf;
    nodeOf.reserve(nCorners*cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k)
    {
        for (int c = 0; c < nCorners; ++c)
        {
            corners_[k][c] = place[find(nodes, corner(cells[k], c))];
            nodeOf.push_back(corners_[k][c]);
        }
    }
    groupBy(nodeOf, int(nodes.size()), startAround_, around_);
}

// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::melt::trilinearGrid::build
(
    const particles& f,
    const double cellSize,
    const periodicBox& box
)
{
    const int n = f.size();
    setSizes(box, cellSize);

    std::vector<index> cells(n);
    for (int i = 0; i < n; ++i)
    {
        cells[i] = cellAt(f, i);
    }
    makeSet(cells);

    std::vector<int> cellOf(n);
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        cellOf[i] = find(cells, cellAt(f, i));
    }
    groupBy(cellOf, int(cells.size()), startMembers_, members_);

    centres_.resize(cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k)
    {
        for (int d = 0; d < 3; ++d)
        {
            const double lowest = nInPeriod_[d] ? box.lowest(d) : 0;
            centres_[k][d] = lowest + size_[d]*(double(cells[k][d]) + 0.5);
        }
    }
    setCorners(cells);
    cornerSums_.resize(cells.size());
}


Foam::melt::trilinearGrid::shape Foam::melt::trilinearGrid::at
(
    const particles& f,
    const int cell,
    const int i
) const
{
    const std::array<double, 3> s = local(f, cell, i, box_);
    const double part[3][2] =
    {
        {1 - s[0], s[0]},
        {1 - s[1], s[1]},
        {1 - s[2], s[2]}
    };

    const auto slope = [&](const int upper, const int axis)
    {
        return upper ? perSize_[axis] : -perSize_[axis];
    };

    shape result;
    result.N = cornerValues(s);
    for (int c = 0; c < nCorners; ++c)
    {
        const int a = c & 1, b = (c >> 1) & 1, d = (c >> 2) & 1;
        result.gradient[c] =
        {
            slope(a, 0)*part[1][b]*part[2][d],
            part[0][a]*slope(b, 1)*part[2][d],
            part[0][a]*part[1][b]*slope(d, 2)
        };
    }
    return result;
}


void Foam::melt::trilinearGrid::restrict
(
    const particles& f,
    const vectorArray& r,
    double* nodes
)
{
    #pragma omp parallel for schedule(dynamic, 4)
    for (int cell = 0; cell < nCells(); ++cell)
    {
        // By component: sums that stay in registers
        double x[nCorners] = {}, y[nCorners] = {}, z[nCorners] = {};
        forValues(f, cell, [&](const int i, const auto& N)
        {
            for (int c = 0; c < nCorners; ++c)
            {
                x[c] += N[c]*r.x[i];
                y[c] += N[c]*r.y[i];
                z[c] += N[c]*r.z[i];
            }
        });
        for (int c = 0; c < nCorners; ++c)
        {
            cornerSums_[cell][3*c] = x[c];
            cornerSums_[cell][3*c + 1] = y[c];
            cornerSums_[cell][3*c + 2] = z[c];
        }
    }

    #pragma omp parallel for schedule(static)
    for (int node = 0; node < nNodes(); ++node)
    {
        double sum[3] = {};
        for (int k = startAround_[node]; k < startAround_[node + 1]; ++k)
        {
            const int cell = around_[k]/nCorners, c = around_[k]%nCorners;
            for (int d = 0; d < 3; ++d)
            {
                sum[d] += cornerSums_[cell][3*c + d];
            }
        }
        std::copy(sum, sum + 3, nodes + 3*node);
    }
}


template<class Number>
void Foam::melt::trilinearGrid::addProlonged
(
    const particles& f,
    const double* nodes,
    vectorArrayOf<Number>& z
) const
{
    #pragma omp parallel for schedule(dynamic, 4)
    for (int cell = 0; cell < nCells(); ++cell)
    {
        double x[nCorners], y[nCorners], w[nCorners];
        for (int c = 0; c < nCorners; ++c)
        {
            const double* const node = nodes + 3*corners_[cell][c];
            x[c] = node[0];
            y[c] = node[1];
            w[c] = node[2];
        }
        forValues(f, cell, [&](const int i, const auto& N)
        {
            double sum[3] = {};
            for (int c = 0; c < nCorners; ++c)
            {
                sum[0] += N[c]*x[c];
                sum[1] += N[c]*y[c];
                sum[2] += N[c]*w[c];
            }
            z.x[i] += sum[0];
            z.y[i] += sum[1];
            z.z[i] += sum[2];
        });
    }
}


template void Foam::melt::trilinearGrid::addProlonged
(
    const particles&, const double*, vectorArrayOf<float>&
) const;

template void Foam::melt::trilinearGrid::addProlonged
(
    const particles&, const double*, vectorArrayOf<double>&
) const;


std::size_t Foam::melt::trilinearGrid::bytes() const
{
    return
        sizeof(int)
       *(
            around_.capacity() + startAround_.capacity() + members_.capacity()
          + startMembers_.capacity() + nCorners*corners_.capacity()
        )
      + 3*sizeof(double)
       *(centres_.capacity() + nCorners*cornerSums_.capacity());
}

// ************************************************************************* //
