/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "enthalpyEquation.H"
#include "checkedEntry.H"
#include "surfaceFields.H"
#include "Time.H"
#include "withOtherRanks.H"

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

Foam::scalarField Foam::melt::enthalpyEquation::conductivity
(
    const scalarField& h
) const
{
    const enthalpyCurve curve(thermo_.enthalpy());
    scalarField kappa(h.size());
    forAll(kappa, celli)
    {
        const scalar liquid = curve.liquidFraction(h[celli]);
        kappa[celli] =
            (1 - liquid)*thermo_.kappaSolid() + liquid*thermo_.kappaLiquid();
    }
    return kappa;
}


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

// ************************************************************************* //
