/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "enthalpyEquation.H"
#include "checkedEntry.H"
#include "fvMatrix.H"
#include "quietLog.H"
#include "surfaceFields.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Cells with less than that have no temperature of their own [-]
const scalar leastMelt = 1e-12;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::melt::enthalpyEquation::conductances
(
    const scalarField& alpha,
    const scalarField& kappa
) const
{
    const fvMesh& mesh = mesh_.mesh();
    scalarField K(mesh.nInternalFaces(), 0);
    forAll(K, facei)
    {
        const label own = mesh.owner()[facei], nei = mesh.neighbour()[facei];
        if (min(alpha[own], alpha[nei]) > leastMelt)
        {
            const scalar harmonic =
                2*kappa[own]*kappa[nei]/(kappa[own] + kappa[nei]);
            K[facei] =
                harmonic*max(alpha[own], alpha[nei])
               *mesh.magSf()[facei]*mesh.deltaCoeffs()[facei];
        }
    }
    return K;
}


void Foam::melt::enthalpyEquation::addWalls
(
    const scalarField& alpha,
    const scalarField& kappa,
    source& walls
) const
{
    const fvMesh& mesh = mesh_.mesh();
    forAll(mesh.boundary(), patchi)
    {
        const wallCondition& w = mesh_.wall(patchi);
        const bool fixed =
            w.thermal == wallCondition::thermalType::fixedTemperature;
        if (w.thermal == wallCondition::thermalType::adiabatic)
        {
            continue;
        }
        forAll(mesh.boundary()[patchi], i)
        {
            const label celli = mesh.boundary()[patchi].faceCells()[i];
            const label domainFacei = mesh_.domainFace(patchi, i);
            const scalar inner =
                kappa[celli]*mesh.deltaCoeffs().boundaryField()[patchi][i];
            const scalar h =
                fixed ? inner
              : inner*w.h[domainFacei]/(inner + w.h[domainFacei]);
            const scalar K =
                h*alpha[celli]*mesh.magSf().boundaryField()[patchi][i];
            walls.slope[celli] += K;
            walls.power[celli] += K*w.T[domainFacei];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::enthalpyEquation::enthalpyEquation
(
    const eulerianMesh& mesh,
    const meltThermo& thermo,
    const dictionary& dict
)
:
    mesh_(mesh),
    thermo_(thermo),
    tolerance_
    (
        checkedEntry::getOrDefault
        (
            dict, "tolerance", dimless, checkedEntry::positiveUpTo(1), 1e-7
        )
    ),
    maxIterations_
    (
        label
        (
            checkedEntry::getOrDefault
            (
                dict, "maxIterations", dimless, scalarMinMax(1, labelMax), 100
            )
        )
    ),
    T_
    (
        IOobject
        (
            "T",
            mesh.mesh().time().timeName(),
            mesh.mesh(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh.mesh(),
        dimensionedScalar(dimTemperature, Zero),
        "zeroGradient"
    )
{
    forAll(T_.boundaryField(), patchi)
    {
        if (mesh.wall(patchi).thermal == wallCondition::thermalType::fixedTemperature)
        {
            T_.boundaryFieldRef().set
            (
                patchi,
                fvPatchScalarField::New
                (
                    "fixedValue", mesh.mesh().boundary()[patchi], T_()
                )
            );
            forAll(T_.boundaryField()[patchi], i)
            {
                T_.boundaryFieldRef()[patchi][i] =
                    mesh.wall(patchi).T[mesh.domainFace(patchi, i)];
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::enthalpyEquation::setT
(
    const scalarField& alpha,
    const scalarField& alphaH
)
{
    const labelListList& cellCells = mesh_.mesh().cellCells();
    boolList known(alpha.size(), false);
    scalarField& T = T_.primitiveFieldRef();
    forAll(T, celli)
    {
        if (alpha[celli] > leastMelt)
        {
            T[celli] = thermo_.enthalpy().T(alphaH[celli]/alpha[celli]);
            known[celli] = true;
        }
    }

    // As far as cells that are drawn reach
    for (label layer = 0; layer < 2; ++layer)
    {
        DynamicList<label> next;
        forAll(T, celli)
        {
            scalar sum = 0;
            label n = 0;
            for (const label neighbour : cellCells[celli])
            {
                if (!known[celli] && known[neighbour])
                {
                    sum += T[neighbour];
                    ++n;
                }
            }
            if (n)
            {
                T[celli] = sum/n;
                next.append(celli);
            }
        }
        for (const label celli : next)
        {
            known[celli] = true;
        }
    }
    T_.correctBoundaryConditions();
}


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
    scalarField kappa(h.size());
    do
    {
        forAll(kappa, celli)
        {
            const scalar liquid = curve.liquidFraction(h[celli]);
            kappa[celli] =
                (1 - liquid)*thermo_.kappaSolid()
              + liquid*thermo_.kappaLiquid();
        }
        const scalarField K(conductances(alpha, kappa));
        walls.power = 0;
        walls.slope = 0;
        addWalls(alpha, kappa, walls);

        fvScalarMatrix equation(change, dimPower);
        equation.upper() = -K;
        equation.diag() = 0;
        scalarField heat
        (
            walls.power - walls.slope*T
          + sources.power - sources.slope*(T - TStart)
          - mass*(h - hStart)/deltaT
        );
        scalarField slope(h.size());
        forAll(mesh.neighbour(), facei)
        {
            const label own = mesh.owner()[facei];
            const label nei = mesh.neighbour()[facei];
            const scalar flux = K[facei]*(T[nei] - T[own]);
            heat[own] += flux;
            heat[nei] -= flux;
            equation.diag()[own] += K[facei];
            equation.diag()[nei] += K[facei];
        }
        equation.diag() += walls.slope + sources.slope;
        const scalarField ownDiag(equation.diag());
        boolList changesPhase(h.size(), false);
        forAll(h, celli)
        {
            changesPhase[celli] =
                isothermal && h[celli] > 0 && h[celli] < curve.latentHeat;
            slope[celli] = curve.Cp(h[celli]);
            equation.diag()[celli] +=
                changesPhase[celli] || mass[celli] <= 0
              ? GREAT*max(ownDiag[celli], VSMALL)
              : mass[celli]*slope[celli]/deltaT;
            equation.source()[celli] = heat[celli];
        }
        change = dimensionedScalar(dimTemperature, Zero);
        {
            const quietLog quiet;
            equation.solve(mesh.solverDict("T"));
        }

        // What the change of temperature brings: h of a cell that changes its
        // phase, and of others by the slope, which is the same
        const scalarField& dT = change.primitiveField();
        heat -= (walls.slope + sources.slope)*dT;
        forAll(mesh.neighbour(), facei)
        {
            const scalar flux =
                K[facei]
               *(dT[mesh.neighbour()[facei]] - dT[mesh.owner()[facei]]);
            heat[mesh.owner()[facei]] += flux;
            heat[mesh.neighbour()[facei]] -= flux;
        }
        scalar wrong = 0, moved = 0;
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
            }
        }
        ++r.iterations;
        r.errors.append(wrong/max(moved, VSMALL));
    }
    while (r.errors.last() > tolerance_ && r.iterations < maxIterations_);

    r.converged = r.errors.last() <= tolerance_;
    if (r.converged)
    {
        alphaH = alpha*h;
    }
    return r;
}

// ************************************************************************* //
