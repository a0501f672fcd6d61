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
