/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particles.H"

std::vector<Foam::melt::particles::array*> Foam::melt::particles::arrays()
{
    std::vector<array*> all
    {
        &x, &y, &z, &u, &v, &w, &rho, &h, &m,
        &ax, &ay, &az, &dRho, &dH, &du, &dv, &dw,
        &axOld, &ayOld, &azOld, &dRhoOld, &dHOld,
        &V, &T, &kappa, &conductionScale, &p, &eta,
        &shearRate
    };
    for (array& component : S)
    {
        all.push_back(&component);
    }
    return all;
}


void Foam::melt::particles::resize(const int n)
{
    for
    (
        array* a :
        {
            &x, &y, &z, &u, &v, &w, &rho, &h, &m,
            &ax, &ay, &az, &dRho, &V, &T, &p
        }
    )
    {
        a->resize(n);
    }
    id.resize(n);
}


std::size_t Foam::melt::particles::bytes() const
{
    std::size_t n = sizeof(int)
       *(id.capacity() + body.capacity() + anchored.capacity());
    for (const array* a : const_cast<particles*>(this)->arrays())
    {
        n += sizeof(double)*a->capacity();
    }
    return n;
}


void Foam::melt::particles::permute(const std::vector<int>& order)
{
    const int n = int(order.size());
    array sorted(n);

    for (array* a : arrays())
    {
        if (a->empty())
        {
            continue;
        }
        const double* const from = a->data();
        double* const to = sorted.data();

        #pragma omp parallel for schedule(static)
        for (int i = 0; i < n; ++i)
        {
            to[i] = from[order[i]];
        }
        a->swap(sorted);
        sorted.resize(n);
    }

    for (std::vector<int>* a : {&id, &body, &anchored})
    {
        if (a->empty())
        {
            continue;
        }
        std::vector<int> sortedLabels(n);
        for (int i = 0; i < n; ++i)
        {
            sortedLabels[i] = (*a)[order[i]];
        }
        a->swap(sortedLabels);
    }
}

// ************************************************************************* //
