/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltFlow.H"
#include "faceAdvection.H"
#include "faceExtrapolation.H"
#include "stokesSystem.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Faster than half a cell a step nothing moves into the air
const int nLayers = 3;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<double> Foam::melt::meltFlow::viscosities
(
    const strainElements& elements,
    const double* u,
    const viscosity& viscosityOf
)
{
    const std::vector<double> rates(elements.shearRate(u));
    std::vector<double> shearRate, eta;
    std::vector<int> cell;
    for (std::size_t i = 0; i < rates.size(); ++i)
    {
        const strainElements::element& e = elements.elements()[i];
        for (int j = 0; j < e.nCells; ++j)
        {
            shearRate.push_back(rates[i]);
            cell.push_back(e.cells[j]);
        }
    }
    eta.resize(cell.size());
    viscosityOf(shearRate, cell, eta);

    std::vector<double> mean(rates.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < rates.size(); ++i)
    {
        const int n = elements.elements()[i].nCells;
        double sum = 0;
        for (int j = 0; j < n; ++j)
        {
            sum += 1/eta[next++];
        }
        mean[i] = n/sum;
    }
    return mean;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::meltFlow::meltFlow(const staggeredGrid& grid, const controls& c)
:
    grid_(grid),
    controls_(c),
    p_(grid.nCells(), 0)
{
    for (int a = 0; a < 3; ++a)
    {
        U_[a].assign(grid.nFaces(a), 0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::meltFlow::record Foam::melt::meltFlow::advance
(
    const std::vector<double>& alpha,
    const double rho,
    const double dt,
    const faceVelocities& acceleration,
    const std::vector<double>& sink,
    const viscosity& viscosityOf,
    const bool shearRateDependent
)
{
    const strainElements elements(grid_, alpha, controls_.wetFrom);
    stokesSystem system(elements);
    system.setInertia
    (
        rho,
        dt,
        faceAdvection::advected(elements, U_, dt),
        acceleration,
        sink
    );
    system.setPressure(p_);
    saddleSolver solver(controls_.solver);

    record r;
    saddleSolver::vector u(system.u());
    for (int a = 0; a < 3; ++a)
    {
        for (int face = 0; face < grid_.nFaces(a); ++face)
        {
            if (elements.velocity(a, face) >= 0)
            {
                u[elements.velocity(a, face)] = U_[a][face];
            }
        }
    }

    const saddleSolver::vector start(u);
    const saddleSolver::vector rest(saddleSolver::vector::Zero(u.size()));
    do
    {
        r.solved = system.solve
        (
            viscosities
            (
                elements,
                shearRateDependent ? u.data() : rest.data(),
                viscosityOf
            ),
            solver
        );
        r.residuals = solver.history();
        r.method = solver.method();
        r.iterations += long(r.residuals.size());
        if (!r.solved)
        {
            return r;
        }
        const double norm = system.u().norm();
        r.change = norm > 0 ? (system.u() - u).norm()/norm : 0;
        u = system.u();
        ++r.sweeps;
    }
    while
    (
        shearRateDependent
     && r.change > controls_.viscosityTolerance
     && r.sweeps < controls_.maxSweeps
    );

    system.get(U_, p_);
    faceExtrapolation::extrapolate(elements, nLayers, U_);
    r.maxDivergence = system.maxDivergence();
    r.acceleration = system.rms(u - start)/dt;
    return r;
}

// ************************************************************************* //
