/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stokesSystem.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::stokesSystem::setDivergence()
{
    const staggeredGrid& grid = elements_.grid();
    std::vector<Eigen::Triplet<double>> entries;
    volume_.setZero(elements_.nVelocities());
    system_.g.setZero(elements_.nPressures());
    grid.forAllFaces([&](int a, int face, int lower, int upper)
    {
        const int u = elements_.velocity(a, face);
        const double area = grid.volume()/grid.d()[a];
        for (const bool isLower : {true, false})
        {
            const int cell = isLower ? lower : upper;
            const int p = cell < 0 ? -1 : elements_.pressure(cell);
            const double out =
                (isLower ? area : -area)
               *(p < 0 ? 0 : elements_.alpha(cell));
            if (p >= 0 && u >= 0)
            {
                entries.emplace_back(p, u, out);
            }
            else if (p >= 0)
            {
                system_.g[p] += out*grid.wallVelocity(a, face, a);
            }
            if (cell >= 0 && u >= 0)
            {
                volume_[u] += 0.5*elements_.alpha(cell)*grid.volume();
            }
        }
    });
    system_.B.resize(elements_.nPressures(), elements_.nVelocities());
    system_.B.setFromTriplets(entries.begin(), entries.end());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::stokesSystem::stokesSystem(const strainElements& elements)
:
    elements_(elements),
    u_(saddleSolver::vector::Zero(elements.nVelocities())),
    p_(saddleSolver::vector::Zero(elements.nPressures()))
{
    setDivergence();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::stokesSystem::setInertia
(
    const double rho,
    const double dt,
    const faceVelocities& U,
    const faceVelocities& acceleration,
    const std::vector<double>& sink
)
{
    const staggeredGrid& grid = elements_.grid();
    system_.M = volume_*(rho/dt);
    drag_ = system_.M;
    force_.setZero(elements_.nVelocities());
    grid.forAllFaces([&](int a, int face, int lower, int upper)
    {
        const int u = elements_.velocity(a, face);
        if (u >= 0)
        {
            force_[u] =
                rho*volume_[u]*(U[a][face]/dt + acceleration[a][face]);
            u_[u] = U[a][face];
            for (const int cell : {lower, upper})
            {
                if (cell >= 0 && !sink.empty())
                {
                    drag_[u] +=
                        0.5*elements_.alpha(cell)*grid.volume()*sink[cell];
                }
            }
        }
    });
}


void Foam::melt::stokesSystem::setPressure(const std::vector<double>& p)
{
    for (int cell = 0; cell < elements_.grid().nCells(); ++cell)
    {
        if (elements_.pressure(cell) >= 0)
        {
            p_[elements_.pressure(cell)] = p[cell];
        }
    }
}


bool Foam::melt::stokesSystem::solve
(
    const std::vector<double>& eta,
    saddleSolver& solver
)
{
    system_.f = force_;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(drag_.size() + 12*elements_.elements().size());
    for (Eigen::Index i = 0; i < drag_.size(); ++i)
    {
        entries.emplace_back(i, i, drag_[i]);
    }
    system_.C.setZero(p_.size());
    for (std::size_t number = 0; number < eta.size(); ++number)
    {
        const strainElements::element& e = elements_.elements()[number];
        const double k = (e.shear() ? 1 : 2)*e.weight*eta[number];
        if (!e.shear() && elements_.pressure(e.cells[0]) >= 0)
        {
            system_.C[elements_.pressure(e.cells[0])] = e.weight/eta[number];
        }
        for (int i = 0; i < e.n; ++i)
        {
            for (int j = 0; j < e.n; ++j)
            {
                entries.emplace_back
                (
                    e.unknown[i], e.unknown[j], k*e.coeff[i]*e.coeff[j]
                );
            }
            system_.f[e.unknown[i]] -= k*e.coeff[i]*e.constant;
        }
    }
    system_.A.resize(drag_.size(), drag_.size());
    system_.A.setFromTriplets(entries.begin(), entries.end());

    return u_.size() == 0 || solver.solve(system_, u_, p_);
}


void Foam::melt::stokesSystem::get
(
    faceVelocities& U,
    std::vector<double>& p
) const
{
    const staggeredGrid& grid = elements_.grid();
    grid.forAllFaces([&](int a, int face, int, int)
    {
        const int u = elements_.velocity(a, face);
        const auto condition = grid.at(a, face);
        if (u >= 0)
        {
            U[a][face] = u_[u];
        }
        else if
        (
            condition == staggeredGrid::condition::noSlip
         || condition == staggeredGrid::condition::slip
        )
        {
            U[a][face] = grid.wallVelocity(a, face, a);
        }
    });
    for (int cell = 0; cell < grid.nCells(); ++cell)
    {
        const int i = elements_.pressure(cell);
        p[cell] = i < 0 ? 0 : p_[i];
    }
}


double Foam::melt::stokesSystem::rms(const saddleSolver::vector& u) const
{
    double liquid = 0;
    for (int cell = 0; cell < elements_.grid().nCells(); ++cell)
    {
        if (elements_.pressure(cell) >= 0)
        {
            liquid += elements_.alpha(cell)*elements_.grid().volume();
        }
    }
    return liquid > 0 ? std::sqrt(volume_.dot(u.cwiseAbs2())/liquid) : 0;
}


double Foam::melt::stokesSystem::maxDivergence() const
{
    double greatest = 0;
    const saddleSolver::vector div(system_.B*u_ + system_.g);
    for (int cell = 0; cell < elements_.grid().nCells(); ++cell)
    {
        const int p = elements_.pressure(cell);
        if (p >= 0)
        {
            const double weight =
                elements_.alpha(cell)*elements_.grid().volume();
            greatest = std::max(greatest, std::abs(div[p])/weight);
        }
    }
    return greatest;
}

// ************************************************************************* //
