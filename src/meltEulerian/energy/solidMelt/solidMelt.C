/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidMelt.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::solidMelt::solidMelt(const dictionary& dict)
{
    const word name(dict.lookupOrDefault<word>("type", "constraint"));
    if (name == "constraint")
    {
        type_ = type::constraint;
        flowFraction_ = checkedEntry::getOrDefault
        (
            dict, "flowFraction", dimless, scalarMinMax(0, 1), 0.5
        );
    }
    else if (name == "sink")
    {
        type_ = type::sink;
        coefficient_ = checkedEntry::get
        (
            dict, "coefficient", dimDensity/dimTime, checkedEntry::notNegative()
        );
        small_ = checkedEntry::getOrDefault
        (
            dict, "small", dimless, checkedEntry::positive(), 1e-3
        );
    }
    else if (name == "none")
    {
        type_ = type::none;
    }
    else
    {
        FatalIOErrorInFunction(dict.lookup("type"))
            << "Unknown type of solid " << name << nl
            << "Valid types: 3(constraint none sink)" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::solidMelt::block
(
    const scalarField& alpha,
    const scalarField& liquidFraction,
    const scalar wetFrom,
    eulerianMesh& mesh
) const
{
    std::vector<char> blocked(mesh.missing());
    if (type_ == type::constraint)
    {
        scalarField solid(alpha.size());
        forAll(alpha, celli)
        {
            solid[celli] =
                alpha[celli] >= wetFrom && liquidFraction[celli] < flowFraction_;
        }
        const std::vector<double> onGrid(mesh.onGrid(solid));
        for (std::size_t cell = 0; cell < blocked.size(); ++cell)
        {
            blocked[cell] = blocked[cell] || onGrid[cell] > 0;
        }
    }
    mesh.grid().setBlocked(blocked);
}


Foam::label Foam::melt::solidMelt::nLoose
(
    const scalarField& alpha,
    const eulerianMesh& mesh
) const
{
    const staggeredGrid& grid = mesh.grid();
    const std::vector<double> melt(mesh.onGrid(alpha));
    const auto solid = [&](const int cell)
    {
        return grid.blocked(cell) && mesh.has(cell) && melt[cell] > 0;
    };

    // Solid cells at walls, then what hangs together with them
    std::vector<char> held(grid.nCells(), 0);
    std::vector<int> front;
    const auto hold = [&](const int cell)
    {
        if (!held[cell] && solid(cell))
        {
            held[cell] = 1;
            front.push_back(cell);
        }
    };
    grid.forAllFaces([&](int a, int face, int lower, int upper)
    {
        const bool isEnd =
            lower < 0 || upper < 0 || !mesh.has(lower) || !mesh.has(upper);
        if
        (
            isEnd && grid.solved(a)
         && grid.at(a, face) != staggeredGrid::condition::open
        )
        {
            for (const int cell : {lower, upper})
            {
                if (cell >= 0)
                {
                    hold(cell);
                }
            }
        }
    });
    while (front.size())
    {
        const staggeredGrid::triple at(grid.position(front.back()));
        front.pop_back();
        for (int a = 0; a < 3; ++a)
        {
            for (const int step : {-1, 1})
            {
                staggeredGrid::triple c(at);
                c[a] += step;
                if (grid.inside(c))
                {
                    hold(grid.cell(c));
                }
            }
        }
    }

    label n = 0;
    for (int cell = 0; cell < grid.nCells(); ++cell)
    {
        n += solid(cell) && !held[cell];
    }
    return n;
}


std::vector<double> Foam::melt::solidMelt::sink
(
    const scalarField& liquidFraction,
    const eulerianMesh& mesh
) const
{
    if (type_ != type::sink)
    {
        return std::vector<double>();
    }
    const scalarField& f = liquidFraction;
    return mesh.onGrid(coefficient_*sqr(1 - f)/(pow3(f) + small_));
}

// ************************************************************************* //
