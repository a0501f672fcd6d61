/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "enthalpyEquation.H"
#include "fvMatrix.H"
#include "surfaceFields.H"
#include "withOtherRanks.H"

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

// ************************************************************************* //
