/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "enthalpyEquation.H"
#include "checkedEntry.H"
#include "fvMatrix.H"
#include "quietLog.H"
#include "withOtherRanks.H"
#include "surfaceFields.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Cells with less than that have no temperature of their own [-]
const scalar leastMelt = 1e-12;

// Rounding of T, relative to the heat that a melt has
const scalar rounding = 1e-13;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::melt::enthalpyEquation::conductances
(
    const scalarField& alpha,
    const scalarField& kappa
) const
{
    const fvMesh& mesh = mesh_.mesh();
    const withOtherRanks alphaOf(mesh, alpha), kappaOf(mesh, kappa);
    scalarField K(mesh.nFaces(), 0);
    mesh_.forAllInner([&](const label facei)
    {
        const scalar own = alpha[mesh.faceOwner()[facei]];
        const scalar nei = alphaOf.beyond(facei);
        if (min(own, nei) > leastMelt)
        {
            const scalar kappaOwn = kappa[mesh.faceOwner()[facei]];
            const scalar kappaNei = kappaOf.beyond(facei);
            const label a = mesh_.onGrid(facei).direction;
            K[facei] =
                2*kappaOwn*kappaNei/(kappaOwn + kappaNei)*max(own, nei)
               *mesh_.grid().volume()/sqr(mesh_.grid().d()[a]);
        }
    });
    return K;
}


void Foam::melt::enthalpyEquation::addConduction
(
    const scalarField& K,
    const scalarField& T,
    scalarField& heat
) const
{
    const fvMesh& mesh = mesh_.mesh();
    const withOtherRanks TOf(mesh, T);
    mesh_.forAllInner([&](const label facei)
    {
        const label own = mesh.faceOwner()[facei];
        const scalar flux = K[facei]*(TOf.beyond(facei) - T[own]);
        heat[own] += flux;
        if (mesh.isInternalFace(facei))
        {
            heat[mesh.neighbour()[facei]] -= flux;
        }
    });
}


void Foam::melt::enthalpyEquation::setBetween
(
    const scalarField& K,
    fvScalarMatrix& equation
) const
{
    forAll(equation.internalCoeffs(), patchi)
    {
        const polyPatch& patch = mesh_.mesh().boundaryMesh()[patchi];
        if (patch.coupled())
        {
            // The diagonal has its part already
            equation.internalCoeffs()[patchi] = 0;
            equation.boundaryCoeffs()[patchi] = patch.patchSlice(K);
        }
    }
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
    const fvMesh& mesh = mesh_.mesh();
    scalarField known(alpha.size(), 0);
    scalarField& T = T_.primitiveFieldRef();
    forAll(T, celli)
    {
        known[celli] = alpha[celli] > leastMelt;
        T[celli] =
            known[celli]
          ? thermo_.enthalpy().T(alphaH[celli]/alpha[celli]) : 0;
    }

    // As far as cells that are drawn reach
    for (label layer = 0; layer < 2; ++layer)
    {
        const withOtherRanks knownOf(mesh, known), TOf(mesh, T);
        scalarField sum(T.size(), 0), n(T.size(), 0);
        mesh_.forAllInner([&](const label facei)
        {
            const label own = mesh.faceOwner()[facei];
            sum[own] += knownOf.beyond(facei)*TOf.beyond(facei);
            n[own] += knownOf.beyond(facei);
            if (mesh.isInternalFace(facei))
            {
                sum[mesh.neighbour()[facei]] += known[own]*T[own];
                n[mesh.neighbour()[facei]] += known[own];
            }
        });
        forAll(T, celli)
        {
            if (!known[celli] && n[celli] > 0)
            {
                T[celli] = sum[celli]/n[celli];
                known[celli] = 1;
            }
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
