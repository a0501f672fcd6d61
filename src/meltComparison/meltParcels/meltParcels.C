/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltParcels.H"
#include "cloudSnapshot.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

const word cloudName("melt");
const word alphaName("alpha.melt");

IOobject fieldIO(const fvMesh& mesh, const word& name)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::melt::meltParcels::bounds() const
{
    boundBox all(boundBox::invertedBox);
    for (const boundBox& b : box)
    {
        all.add(b);
    }
    return all;
}


bool Foam::melt::meltParcels::found(const fvMesh& mesh)
{
    return
        cloudSnapshot::found(mesh, cloudName)
     || fieldIO(mesh, alphaName).typeHeaderOk<volScalarField>(true);
}


Foam::melt::meltParcels Foam::melt::meltParcels::read
(
    const fvMesh& mesh,
    const scalar resolution
)
{
    meltParcels parcels;

    if (cloudSnapshot::found(mesh, cloudName))
    {
        const cloudSnapshot cloud(mesh, cloudName);
        const scalarField V(cloud.volumes(dictionary()));
        const scalarField T(cloud.field("T"));
        parcels.origin = "cloud " + cloudName;

        forAll(V, i)
        {
            const vector half(0.5*max(cbrt(V[i]), resolution)*vector::one);
            const point& centre = cloud.positions()[i];
            parcels.append(boundBox(centre - half, centre + half), V[i], T[i]);
        }
        return parcels;
    }

    if (!fieldIO(mesh, alphaName).typeHeaderOk<volScalarField>(true))
    {
        FatalErrorInFunction
            << "No melt in " << mesh.time().timePath() << nl
            << "Expected: lagrangian/" << cloudName << " or " << alphaName
            << exit(FatalError);
    }

    const volScalarField alpha(fieldIO(mesh, alphaName), mesh);
    const volScalarField T(fieldIO(mesh, "T"), mesh);
    parcels.origin = "field " + alphaName;

    forAll(alpha, celli)
    {
        if (alpha[celli] > 0)
        {
            parcels.append
            (
                boundBox(mesh.points(), mesh.cellPoints()[celli], false),
                min(alpha[celli], scalar(1))*mesh.V()[celli],
                T[celli]
            );
        }
    }
    return parcels;
}


// ************************************************************************* //
