/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carriedEnthalpy.H"
#include "convectionScheme.H"
#include "withOtherRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Liquid fraction that a full cell may lack [-]
const Foam::scalar surface = 1e-3;


//- The case's, or the default
Foam::ITstream scheme(const Foam::dictionary& schemes)
{
    const Foam::dictionary& div = schemes.subOrEmptyDict("divSchemes");
    const Foam::word name("div(phi,h)");
    return
        div.found(name)
      ? div.lookup(name) : Foam::ITstream("default", "Gauss vanLeer");
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::melt::carriedEnthalpy::surrounded
(
    const scalarField& alpha
) const
{
    const fvMesh& mesh = mesh_.mesh();
    scalarField flows(alpha.size());
    forAll(flows, celli)
    {
        flows[celli] =
            alpha[celli] > 1 - surface
         && !mesh_.grid().blocked(mesh_.gridCell(celli));
    }
    scalarField result(flows);
    const withOtherRanks flowsOf(mesh, flows);
    mesh_.forAllInner([&](const label facei)
    {
        const label own = mesh.faceOwner()[facei];
        result[own] = min(result[own], flowsOf.beyond(facei));
        if (mesh.isInternalFace(facei))
        {
            const label nei = mesh.neighbour()[facei];
            result[nei] = min(result[nei], flows[own]);
        }
    });
    return result;
}


Foam::scalarField Foam::melt::carriedEnthalpy::outflow
(
    const surfaceScalarField& volume
) const
{
    const fvMesh& mesh = mesh_.mesh();
    scalarField result(mesh.nCells(), 0);
    forAll(mesh.neighbour(), facei)
    {
        const label from =
            volume[facei] > 0
          ? mesh.owner()[facei] : mesh.neighbour()[facei];
        result[from] += mag(volume[facei]);
    }
    for (const fvsPatchScalarField& patch : volume.boundaryField())
    {
        forAll(patch, i)
        {
            result[patch.patch().faceCells()[i]] += max(patch[i], scalar(0));
        }
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::carriedEnthalpy::carriedEnthalpy(const eulerianMesh& mesh)
:
    mesh_(mesh),
    h_
    (
        IOobject("h", mesh.mesh().time().timeName(), mesh.mesh()),
        mesh.mesh(),
        dimensionedScalar(dimEnergy/dimMass, Zero),
        "zeroGradient"
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::melt::carriedEnthalpy::at
(
    const scalarField& alpha,
    const scalarField& h,
    const surfaceScalarField& volume,
    const scalar deltaT
)
{
    const fvMesh& mesh = mesh_.mesh();
    h_.primitiveFieldRef() = h;
    h_.correctBoundaryConditions();
    ITstream chosen(scheme(mesh.schemesDict()));
    tmp<surfaceScalarField> result
    (
        fv::convectionScheme<scalar>::New
        (
            mesh, volume, chosen
        )->interpolate(volume, h_)
    );

    const scalarField share
    (
        surrounded(alpha)
       *max(1 - deltaT*outflow(volume)/mesh.V(), scalar(0))
    );
    const withOtherRanks shareOf(mesh, share), hOf(mesh, h);
    const auto limit = [&](const label facei, const scalar flux, scalar& hFace)
    {
        const label own = mesh.faceOwner()[facei];
        const scalar from = flux > 0 ? h[own] : hOf.beyond(facei);
        hFace =
            from
          + (flux > 0 ? share[own] : shareOf.beyond(facei))*(hFace - from);
    };
    surfaceScalarField& hFaces = result.ref();
    forAll(mesh.neighbour(), facei)
    {
        limit(facei, volume[facei], hFaces[facei]);
    }
    forAll(hFaces.boundaryField(), patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            fvsPatchScalarField& patch = hFaces.boundaryFieldRef()[patchi];
            forAll(patch, i)
            {
                limit
                (
                    mesh.boundary()[patchi].start() + i,
                    volume.boundaryField()[patchi][i],
                    patch[i]
                );
            }
        }
    }
    return result;
}

// ************************************************************************* //
