/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldDiagnostics.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::fieldDiagnostics::addExtents
(
    const scalarField& alpha,
    const point& initialCentre,
    meltDiagnostics& d
) const
{
    const vector up = mag(g_) > 0 ? vector(-g_/mag(g_)) : vector(0, 0, 1);
    const labelListList& cellPoints = mesh_.cellPoints();
    const Vector<label>& solved = mesh_.geometricD();

    boundBox bounds(boundBox::invertedBox);
    scalarMinMax heights;

    forAll(alpha, celli)
    {
        if (alpha[celli] >= seen_)
        {
            const boundBox cell(mesh_.points(), cellPoints[celli], false);
            scalar edge = GREAT;
            for (direction k = 0; k < 3; ++k)
            {
                if (solved[k] > 0)
                {
                    edge = min(edge, cell.span()[k]);
                }
            }

            bounds.add(cell);
            for (const label pointi : cellPoints[celli])
            {
                heights.add(mesh_.points()[pointi] & up);
            }
            const vector away(mesh_.C()[celli] - initialCentre);
            d.frontRadius =
                max(d.frontRadius, mag(away - (away & up)*up) + 0.5*edge);
        }
    }

    bounds.reduce();
    reduce(heights, minMaxOp<scalar>());
    reduce(d.frontRadius, maxOp<scalar>());
    if (heights.valid())
    {
        d.bounds = bounds;
        d.height = heights.mag();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::fieldDiagnostics::fieldDiagnostics
(
    const fvMesh& mesh,
    const meltThermo& thermo,
    const vector& g,
    const scalar seen
)
:
    mesh_(mesh),
    rho_(thermo.rho()),
    curve_(thermo.enthalpy()),
    g_(g),
    seen_(seen)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::melt::fieldDiagnostics::centreOfMass
(
    const scalarField& alpha
) const
{
    const scalarField& V = mesh_.V();

    return
        gSum(alpha*V*mesh_.C().primitiveField())
       /max(gSum(alpha*V), VSMALL);
}


Foam::melt::meltDiagnostics Foam::melt::fieldDiagnostics::calculate
(
    const scalarField& alpha,
    const vectorField& U,
    const scalarField& h,
    const point& initialCentre
) const
{
    meltDiagnostics d;

    const scalarField V(alpha*mesh_.V());
    d.volume = gSum(V);
    d.mass = rho_*d.volume;

    scalarField liquid(h.size());
    scalarMinMax T;
    forAll(h, celli)
    {
        liquid[celli] = curve_.liquidFraction(h[celli]);
        if (alpha[celli] >= seen_)
        {
            T.add(curve_.T(h[celli]));
            d.maxU = max(d.maxU, mag(U[celli]));
        }
    }
    reduce(T, minMaxOp<scalar>());
    reduce(d.maxU, maxOp<scalar>());
    if (T.valid())
    {
        d.minT = T.min();
        d.maxT = T.max();
    }

    d.meltedFraction = gSum(liquid*V)/max(d.volume, VSMALL);
    d.centreOfMass = centreOfMass(alpha);
    d.kineticEnergy = 0.5*rho_*gSum(V*magSqr(U));
    d.thermalEnergy = rho_*gSum(V*h);
    d.potentialEnergy = -d.mass*(g_ & d.centreOfMass);
    addExtents(alpha, initialCentre, d);

    return d;
}


// ************************************************************************* //
