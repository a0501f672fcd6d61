/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchPressure.H"
#include "fixedValueFvPatchFields.H"
#include "ofAllRanks.H"
#include "Time.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::patchPressure::patchPressure(const meltScene& scene)
{
    const fvMesh& mesh = scene.mesh();
    const Time& time = mesh.time();
    const IOobject io
    (
        "p_rgh",
        time.findInstance("", "p_rgh", IOobject::READ_IF_PRESENT),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!returnReduce(isFile(io.objectPath()), orOp<bool>()))
    {
        return;
    }
    p_rgh_.reset(new volScalarField(io, mesh));

    const dictionary& dict = localIOdictionary
    (
        io, volScalarField::typeName
    ).subDict("boundaryField");
    if (p_rgh_->dimensions() != dimPressure)
    {
        FatalIOErrorInFunction(dict.parent())
            << "p_rgh has the dimensions " << p_rgh_->dimensions() << nl
            << "Accepted: " << dimPressure << exit(FatalIOError);
    }
    forAll(p_rgh_->boundaryField(), patchi)
    {
        const fvPatchScalarField& p = p_rgh_->boundaryField()[patchi];
        const word& name = p.patch().name();
        const bool isWall = scene.walls()[patchi].isWall();
        const bool zeroGradient = isA<zeroGradientFvPatchScalarField>(p);
        if
        (
            !polyPatch::constraintType(p.patch().type())
         && !zeroGradient
         && (
                isWall
             || (p.type() != "fixedValue" && p.type() != "uniformFixedValue")
            )
        )
        {
            FatalIOErrorInFunction(dict)
                << "Condition " << p.type() << " of p_rgh on "
                << (isWall ? "wall " : "patch ") << name
                << " is not supported." << nl
                << "Accepted: "
                << (isWall ? "" : "fixedValue, uniformFixedValue, ")
                << "zeroGradient" << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::patchPressure::closes(const label patchi) const
{
    return
        p_rgh_.valid()
     && isA<zeroGradientFvPatchScalarField>(p_rgh_->boundaryField()[patchi]);
}


bool Foam::melt::patchPressure::gives(const label patchi) const
{
    return p_rgh_.valid() && p_rgh_->boundaryField()[patchi].fixesValue();
}


Foam::scalarField Foam::melt::patchPressure::p_rgh(const label patchi) const
{
    const fvPatchScalarField& p = p_rgh_->boundaryField()[patchi];

    // What varies with time
    const_cast<fvPatchScalarField&>(p).evaluate();
    return ofAllRanks<scalarField>(p);
}

// ************************************************************************* //
