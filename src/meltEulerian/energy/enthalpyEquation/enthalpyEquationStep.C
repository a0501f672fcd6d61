/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "enthalpyEquation.H"
#include "fvMatrix.H"
#include "quietLog.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Rounding of T, relative to the heat that a melt has
const Foam::scalar rounding = 1e-13;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::enthalpyEquation::record Foam::melt::enthalpyEquation::advance
(
    const scalarField& alpha,
    const scalar deltaT,
    const source& sources,
    scalarField& alphaH
)
{
    const fvMesh& mesh = mesh_.mesh();
    const enthalpyCurve curve(thermo_.enthalpy());
    const bool isothermal = curve.solidus == curve.liquidus;
    const scalarField mass(thermo_.rho()*alpha*mesh.V());

    scalarField h(alpha.size(), 0), T(alpha.size(), curve.solidus);
    forAll(h, celli)
    {
        if (alpha[celli] > leastMelt)
        {
            h[celli] = alphaH[celli]/alpha[celli];
            T[celli] = curve.T(h[celli]);
        }
    }
    const scalarField hStart(h), TStart(T);

    record r;
    volScalarField change
    (
        IOobject("T", mesh.time().timeName(), mesh, IOobject::NO_READ,
            IOobject::NO_WRITE, false),
        mesh,
        dimensionedScalar(dimTemperature, Zero),
        "zeroGradient"
    );
    source walls{scalarField(h.size(), 0), scalarField(h.size(), 0)};
    do
    {
        const scalarField kappa(conductivity(h));
        const scalarField K(conductances(alpha, kappa));
        walls.power = 0;
        walls.slope = 0;
        addWalls(alpha, kappa, walls);

        fvScalarMatrix equation(change, dimPower);
        equation.upper() = -SubField<scalar>(K, mesh.nInternalFaces());
        equation.diag() = 0;
        scalarField heat
        (
            walls.power - walls.slope*T
          + sources.power - sources.slope*(T - TStart)
          - mass*(h - hStart)/deltaT
        );
        scalarField slope(h.size());
        addConduction(K, T, heat);
        scalarField diagonal(walls.slope + sources.slope);
        mesh_.forAllInner([&](const label facei)
        {
            diagonal[mesh.faceOwner()[facei]] += K[facei];
            if (mesh.isInternalFace(facei))
            {
                diagonal[mesh.neighbour()[facei]] += K[facei];
            }
        });
        boolList changesPhase(h.size(), false);
        forAll(h, celli)
        {
            changesPhase[celli] =
                isothermal && h[celli] > 0 && h[celli] < curve.latentHeat;
            slope[celli] = curve.Cp(h[celli]);
            equation.diag()[celli] =
                diagonal[celli]
              + (
                    changesPhase[celli] || mass[celli] <= 0
                  ? GREAT*max(diagonal[celli], VSMALL)
                  : mass[celli]*slope[celli]/deltaT
                );
            equation.source()[celli] = heat[celli];
        }
        setBetween(K, equation);
        change = dimensionedScalar(dimTemperature, Zero);
        {
            const quietLog quiet;
            equation.solve(mesh.solverDict("T"));
        }

        // What the change of temperature brings: h of a cell that changes its
        // phase, and of others by the slope, which is the same
        const scalarField& dT = change.primitiveField();
        heat -= (walls.slope + sources.slope)*dT;
        addConduction(K, dT, heat);
        scalar wrong = 0, moved = 0, stored = 0;
        r.in = r.out = 0;
        forAll(h, celli)
        {
            const scalar TNew = T[celli] + dT[celli];
            const scalar Q =
                deltaT
               *(
                    walls.power[celli] - walls.slope[celli]*TNew
                  + sources.power[celli]
                  - sources.slope[celli]*(TNew - TStart[celli])
                );
            (Q > 0 ? r.in : r.out) += mag(Q);
            if (mass[celli] > 0)
            {
                h[celli] +=
                    changesPhase[celli]
                  ? heat[celli]*deltaT/mass[celli] : slope[celli]*dT[celli];
                T[celli] = curve.T(h[celli]);
                wrong +=
                    mass[celli]
                   *min(curve.CpSolid, curve.CpLiquid)*mag(T[celli] - TNew);
                moved += mass[celli]*mag(h[celli] - hStart[celli]);
                stored +=
                    mass[celli]
                   *min(curve.CpSolid, curve.CpLiquid)*mag(T[celli]);
            }
        }
        reduce(wrong, sumOp<scalar>());
        reduce(moved, sumOp<scalar>());
        reduce(stored, sumOp<scalar>());
        ++r.iterations;
        r.errors.append
        (
            wrong/max(moved + rounding/tolerance_*stored, VSMALL)
        );
    }
    while (r.errors.last() > tolerance_ && r.iterations < maxIterations_);

    reduce(r.in, sumOp<scalar>());
    reduce(r.out, sumOp<scalar>());
    r.converged = r.errors.last() <= tolerance_;
    if (r.converged)
    {
        alphaH = alpha*h;
    }
    return r;
}

// ************************************************************************* //
