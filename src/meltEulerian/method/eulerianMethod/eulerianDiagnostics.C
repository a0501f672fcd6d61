/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::melt::eulerianMethod::mass() const
{
    return
        scene_.thermo().rho()
       *gSum(interface_.alpha().primitiveField()*region_.mesh().V());
}


Foam::scalar Foam::melt::eulerianMethod::enthalpy() const
{
    return scene_.thermo().rho()*gSum(alphaH_*region_.mesh().V());
}


Foam::point Foam::melt::eulerianMethod::centreOfMass() const
{
    const fvMesh& mesh = region_.mesh();
    const scalarField volume(interface_.alpha().primitiveField()*mesh.V());
    return
        gSum(volume*mesh.C().primitiveField())/max(gSum(volume), VSMALL);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::meltDiagnostics Foam::melt::eulerianMethod::diagnostics() const
{
    const fvMesh& mesh = region_.mesh();
    const staggeredGrid& grid = region_.grid();
    const scalarField& alpha = interface_.alpha();
    const scalar rho = scene_.thermo().rho();
    const vector& g = scene_.g();
    const vector up(mag(g) > 0 ? vector(-g/mag(g)) : vector(0, 0, 1));

    meltDiagnostics d;
    d.mass = mass();
    d.volume = d.mass/rho;
    d.centreOfMass = centreOfMass();
    d.thermalEnergy = enthalpy();
    d.potentialEnergy = -d.mass*(g & d.centreOfMass);
    d.workOfGravity = initialPotentialEnergy_ - d.potentialEnergy;
    d.heatIn = heatIn_;
    d.heatOut = heatOut_;

    // A cell reaches as far as it is filled, from the side of more melt
    const scalar seen = flow_.wetFrom();
    const tmp<scalarField> fraction(liquidFraction());
    const std::vector<double> onGrid(region_.onGrid(alpha));
    scalar liquid = 0;
    d.minT = GREAT;
    d.maxT = -GREAT;
    boundBox bounds(boundBox::invertedBox);
    forAll(alpha, celli)
    {
        const scalar mass = rho*alpha[celli]*mesh.V()[celli];
        liquid += mass*fraction()[celli];
        if (alpha[celli] < seen)
        {
            continue;
        }
        d.kineticEnergy += 0.5*mass*magSqr(interface_.U()[celli]);
        d.maxU = max(d.maxU, mag(interface_.U()[celli]));
        d.minT = min(d.minT, energy_.T()[celli]);
        d.maxT = max(d.maxT, energy_.T()[celli]);

        const staggeredGrid::triple c(grid.position(region_.gridCell(celli)));
        point low(mesh.C()[celli]), high(low);
        for (direction a = 0; a < 3; ++a)
        {
            const scalar half = 0.5*grid.d()[a];
            const auto beside = [&](const int step)
            {
                staggeredGrid::triple to(c);
                to[a] += step;
                return
                    grid.inside(to) && region_.has(grid.cell(to))
                  ? onGrid[grid.cell(to)] : alpha[celli];
            };
            const scalar below = beside(-1), above = beside(1);
            const scalar part = 2*half*(1 - min(alpha[celli], scalar(1)));
            low[a] -= half - (above > below ? part : 0);
            high[a] += half - (below > above ? part : 0);
        }
        bounds.add(low);
        bounds.add(high);

        const vector to(mesh.C()[celli] - initialCentre_);
        const scalar edge = cbrt(mesh.V()[celli]);
        d.frontRadius = max
        (
            d.frontRadius,
            mag(to - (to & up)*up)
          + (min(alpha[celli], scalar(1)) - 0.5)*edge
        );
    }
    reduce(liquid, sumOp<scalar>());
    reduce(d.kineticEnergy, sumOp<scalar>());
    reduce(d.maxU, maxOp<scalar>());
    reduce(d.minT, minOp<scalar>());
    reduce(d.maxT, maxOp<scalar>());
    reduce(d.frontRadius, maxOp<scalar>());
    bounds.reduce();
    if (d.mass > 0)
    {
        d.meltedFraction = liquid/d.mass;
    }
    if (bounds.valid())
    {
        d.bounds = bounds;
        d.height =
            cmptMag(up) & bounds.span();
    }
    else
    {
        d.minT = d.maxT = 0;
    }
    return d;
}


void Foam::melt::eulerianMethod::report(Ostream& os) const
{
    const scalar rho = scene_.thermo().rho();
    const scalar massError =
        mass() + rho*(interface_.lostVolume() - vents_.volume()) - initialMass_;
    const scalar energyError =
        enthalpy() + rho*(interface_.lostEnthalpy() - vents_.volumeH())
      - heatIn_ + heatOut_ - initialEnthalpy_;
    os  << "Momentum: " << flowRecord_.method.c_str() << ", sweeps "
        << flowRecord_.sweeps << ", change of U " << flowRecord_.change
        << ", iterations " << label(flowRecord_.iterations)
        << ", max |div U| " << flowRecord_.maxDivergence << " 1/s" << nl
        << "Interface: steps " << interfaceSteps_ << ", alpha "
        << gMin(interface_.alpha().primitiveField()) << " .. 1 + "
        << gMax(interface_.alpha().primitiveField()) - 1
        << ", given to neighbours " << interface_.redistributed() << " m3" << nl
        << "Energy: iterations " << energyRecord_.iterations << nl
        << "     mass error " << massError << " kg, energy error "
        << energyError << " J, escaped " << rho*interface_.lostVolume()
        << " kg, from vents " << rho*vents_.volume() << " kg" << nl
        << "Work of this run: " << nSystems_ << " momentum systems, "
        << nIterations_ << " iterations; " << nEnergyIterations_
        << " energy iterations" << nl;
    const label nLoose = solid_.nLoose(interface_.alpha(), region_);
    if (nLoose)
    {
        os  << "     Warning: " << nLoose << " cells of solid melt hang on no"
            << " wall and stand still; by solid { type none; } in"
            << " eulerianSolution they fall" << nl;
    }
}

// ************************************************************************* //
