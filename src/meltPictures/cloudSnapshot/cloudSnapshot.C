/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudSnapshot.H"
#include "passiveParticleCloud.H"
#include "IOField.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::melt::cloudSnapshot::fieldIO(const word& fieldName) const
{
    return IOobject
    (
        fieldName,
        mesh_.time().timeName(),
        cloud::prefix/cloudName_,
        mesh_,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


Foam::word Foam::melt::cloudSnapshot::fieldType(const word& fieldName) const
{
    IOobject io(fieldIO(fieldName));
    return io.typeHeaderOk<IOField<scalar>>(false)
      ? io.headerClassName()
      : word();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::cloudSnapshot::cloudSnapshot
(
    const polyMesh& mesh,
    const word& cloudName
)
:
    mesh_(mesh),
    cloudName_(cloudName)
{
    const passiveParticleCloud particles(mesh, cloudName, false);
    positions_.resize(particles.size());
    label i = 0;
    for (const passiveParticle& p : particles)
    {
        positions_[i++] = p.position();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::cloudSnapshot::found
(
    const polyMesh& mesh,
    const word& cloudName
)
{
    const fileName dir
    (
        mesh.time().timePath()/mesh.dbDir()/cloud::prefix/cloudName
    );
    return isFile(dir/"positions") || isFile(dir/"coordinates");
}


Foam::tmp<Foam::scalarField>
Foam::melt::cloudSnapshot::field(const word& fieldName) const
{
    const word type(fieldType(fieldName));
    const IOobject io(fieldIO(fieldName));

    tmp<scalarField> tvalues(new scalarField());
    scalarField& values = tvalues.ref();
    if (type == IOField<scalar>::typeName)
    {
        values = IOField<scalar>(io);
    }
    else if (type == IOField<vector>::typeName)
    {
        values = mag(IOField<vector>(io));
    }
    else if (type == IOField<label>::typeName)
    {
        const IOField<label> labels(io);
        values.resize(labels.size());
        std::copy(labels.begin(), labels.end(), values.begin());
    }
    else
    {
        FatalErrorInFunction
            << "No scalar, vector or label field " << fieldName << " in "
            << io.path() << nl
            << "Files there: " << readDir(io.path(), fileName::FILE)
            << exit(FatalError);
    }

    if (values.size() != positions_.size())
    {
        FatalErrorInFunction
            << "Field " << io.objectPath() << " has " << values.size()
            << " values for " << positions_.size() << " particles"
            << exit(FatalError);
    }
    return tvalues;
}


Foam::word Foam::melt::cloudSnapshot::fieldTitle(const word& fieldName) const
{
    return fieldType(fieldName) == IOField<vector>::typeName
      ? word("mag(" + fieldName + ')')
      : fieldName;
}


Foam::tmp<Foam::scalarField>
Foam::melt::cloudSnapshot::volumes(const dictionary& dict) const
{
    const auto positive = [](const scalar length) { return length > 0; };

    scalar spacing = 0;
    if (!dict.readCheckIfPresent("spacing", spacing, positive))
    {
        if (!fieldType("m").empty() && !fieldType("rho").empty())
        {
            return field("m")/field("rho");
        }
        mesh_.time().controlDict().readCheckIfPresent
        (
            "resolution", spacing, positive
        );
    }
    if (!(spacing > 0))
    {
        FatalIOErrorInFunction(dict)
            << "The particles' volume is unknown: cloud " << cloudName_
            << " at time " << mesh_.time().timeName()
            << " has no fields m and rho, and system/controlDict no resolution"
            << nl << "Add entry spacing [m] to " << dict.name()
            << exit(FatalIOError);
    }
    return tmp<scalarField>::New(positions_.size(), pow3(spacing));
}


// ************************************************************************* //
