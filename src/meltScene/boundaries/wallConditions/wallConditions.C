/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallConditions.H"
#include "cyclicPolyPatch.H"
#include "Function1.H"
#include "localIOdictionary.H"
#include "polyMesh.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "Time.H"
#include "wallPolyPatch.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using melt::wallCondition;


//- File of a field at the start time or, on a restart, an earlier one
localIOdictionary fieldFile
(
    const polyMesh& mesh,
    const word& name,
    const word& className
)
{
    const Time& time = mesh.time();

    IOobject io
    (
        name,
        time.findInstance("", name, IOobject::READ_IF_PRESENT),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!isFile(io.objectPath()))
    {
        FatalErrorInFunction
            << "Cannot find file " << time.path()/"0"/name << ":" << nl
            << "a case needs 0/U and 0/T for the conditions on its walls."
            << exit(FatalError);
    }

    return localIOdictionary(io, className);
}


//- Entry of a patch by its name, else by its groups, else by a pattern: the
//  order of OpenFOAM's own fields
const dictionary& patchDict(const dictionary& fieldDict, const polyPatch& patch)
{
    const dictionary& boundary = fieldDict.subDict("boundaryField");

    const dictionary* dict = boundary.findDict(patch.name(), keyType::LITERAL);

    forAllReverse(patch.inGroups(), i)
    {
        if (!dict)
        {
            dict = boundary.findDict(patch.inGroups()[i], keyType::LITERAL);
        }
    }

    if (!dict)
    {
        dict = boundary.findDict(patch.name(), keyType::REGEX);
    }

    if (!dict)
    {
        FatalIOErrorInFunction(boundary)
            << "No condition for wall " << patch.name() << nl
            << "Patches in this file: " << boundary.toc()
            << exit(FatalIOError);
    }

    return *dict;
}


//- Entry of a field, one value a face, all of them within range
scalarField faceValues
(
    const word& keyword,
    const dictionary& dict,
    const label n,
    const scalarMinMax& range
)
{
    scalarField values(keyword, dict, n);

    for (const scalar value : values)
    {
        melt::checkedEntry::check(dict, keyword, value, range);
    }

    return values;
}


void readVelocity
(
    wallCondition& wall,
    const dictionary& dict,
    const polyPatch& patch
)
{
    const word type(dict.get<word>("type"));

    wall.velocity = wallCondition::velocityType::noSlip;

    if (type == "slip")
    {
        wall.velocity = wallCondition::velocityType::slip;
    }
    else if (type == "fixedValue" || type == "movingWallVelocity")
    {
        wall.U = vectorField("value", dict, patch.size());

        for (const vector& U : wall.U)
        {
            melt::checkedEntry::check
            (
                dict, "value", mag(U), melt::checkedEntry::notNegative()
            );
        }
    }
    else if (type != "noSlip")
    {
        FatalIOErrorInFunction(dict.lookup("type"))
            << "Condition " << type << " of U on wall " << patch.name()
            << " is not supported." << nl
            << "Accepted: noSlip, fixedValue, movingWallVelocity, slip"
            << exit(FatalIOError);
    }
}


void readTemperature
(
    wallCondition& wall,
    const dictionary& dict,
    const polyPatch& patch
)
{
    const word type(dict.get<word>("type"));
    const label n = patch.size();

    if (type == "fixedValue")
    {
        wall.thermal = wallCondition::thermalType::fixedTemperature;
        wall.T =
            faceValues("value", dict, n, melt::checkedEntry::notNegative());
    }
    else if (type == "externalWallHeatFluxTemperature")
    {
        if (dict.get<word>("mode") != "coefficient")
        {
            FatalIOErrorInFunction(dict.lookup("mode"))
                << "Mode " << dict.get<word>("mode") << " of T on wall "
                << patch.name() << " is not supported." << nl
                << "Accepted: coefficient" << exit(FatalIOError);
        }

        const scalar Ta = Function1<scalar>::New("Ta", dict)->value(0);
        melt::checkedEntry::check
        (
            dict, "Ta", Ta, melt::checkedEntry::notNegative()
        );

        wall.thermal = wallCondition::thermalType::convective;
        wall.T = scalarField(n, Ta);
        wall.h = faceValues("h", dict, n, melt::checkedEntry::notNegative());
    }
    else if (type != "zeroGradient")
    {
        FatalIOErrorInFunction(dict.lookup("type"))
            << "Condition " << type << " of T on wall " << patch.name()
            << " is not supported." << nl
            << "Accepted: zeroGradient, fixedValue, "
            << "externalWallHeatFluxTemperature" << exit(FatalIOError);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::wallConditions::wallConditions(const polyMesh& mesh)
:
    conditions_(mesh.boundaryMesh().size())
{
    const localIOdictionary U(fieldFile(mesh, "U", "volVectorField"));
    const localIOdictionary T(fieldFile(mesh, "T", "volScalarField"));

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        wallCondition& wall = conditions_[patch.index()];

        wall.patchi = patch.index();
        wall.name = patch.name();
        wall.velocity = wallCondition::velocityType::open;
        wall.thermal = wallCondition::thermalType::adiabatic;
        wall.U = vectorField(patch.size(), Zero);

        if (isA<wallPolyPatch>(patch))
        {
            readVelocity(wall, patchDict(U, patch), patch);
            readTemperature(wall, patchDict(T, patch), patch);
        }
        else if
        (
            isA<symmetryPlanePolyPatch>(patch) || isA<symmetryPolyPatch>(patch)
        )
        {
            wall.velocity = wallCondition::velocityType::slip;
        }
        else if (isA<cyclicPolyPatch>(patch))
        {
            wall.velocity = wallCondition::velocityType::cyclic;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarMinMax Foam::melt::wallConditions::TRange() const
{
    scalarMinMax range;

    for (const wallCondition& wall : conditions_)
    {
        range.add(wall.T);
    }

    return returnReduce(range, sumOp<scalarMinMax>());
}


// ************************************************************************* //
