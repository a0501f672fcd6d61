/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidGroups.H"

namespace
{

//- First of i's set; paths are halved on the way
int rootOf(std::vector<int>& parent, int i)
{
    while (parent[i] != i)
    {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

} // End anonymous namespace


bool Foam::melt::groupSolids
(
    const neighbourhood& near,
    const double distance,
    particles& f
)
{
    const int n = f.size();
    const double distance2 = distance*distance;

    bool changed = false;
    for (int i = 0; i < n; ++i)
    {
        changed = changed || (f.h[i] <= 0) != (f.body[i] >= 0);
    }
    if (!changed)
    {
        return false;
    }

    // Bonds to particles later in the order, each written by its own thread
    std::vector<std::vector<int>> bonds(n);
    near.fluid().forEach([&](const int i, const auto& row)
    {
        if (f.h[i] > 0)
        {
            return;
        }
        for (int k = 0; k < row.size(); ++k)
        {
            const int j = row[k];
            const double dx = f.x[i] - f.x[j];
            const double dy = f.y[i] - f.y[j];
            const double dz = f.z[i] - f.z[j];
            if
            (
                j > i && f.h[j] <= 0
             && dx*dx + dy*dy + dz*dz < distance2
             && (f.body[i] == f.body[j] || f.body[i] < 0 || f.body[j] < 0)
            )
            {
                bonds[i].push_back(j);
            }
        }
    });

    std::vector<int> parent(n);
    for (int i = 0; i < n; ++i)
    {
        parent[i] = i;
    }
    for (int i = 0; i < n; ++i)
    {
        for (const int j : bonds[i])
        {
            const int a = rootOf(parent, i);
            const int b = rootOf(parent, j);
            parent[std::max(a, b)] = std::min(a, b);
        }
    }

    std::vector<int> lowest(f.id);
    for (int i = 0; i < n; ++i)
    {
        int& name = lowest[rootOf(parent, i)];
        name = std::min(name, f.id[i]);
    }
    for (int i = 0; i < n; ++i)
    {
        f.body[i] = f.h[i] <= 0 ? lowest[rootOf(parent, i)] : -1;
    }
    return true;
}

// ************************************************************************* //
