/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "domainFields.H"
#include "localIOdictionary.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"
#include "volFields.H"

#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::melt::domainFields::sampled
(
    const scalarField& values
) const
{
    const std::vector<double> onGrid(region_.onGrid(values));
    scalarField result(domain_.nCells());
    forAll(result, celli)
    {
        result[celli] = onGrid[region_.cellAt(domain_.C()[celli])];
    }
    return result;
}


Foam::vectorField Foam::melt::domainFields::sampled
(
    const vectorField& values
) const
{
    vectorField result(domain_.nCells());
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        result.replace(k, sampled(scalarField(values.component(k))));
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::melt::domainFields::write
(
    const word& name,
    const Field<Type>& values
) const
{
    const Field<Type> inside(sampled(values));
    const Time& time = domain_.time();
    const IOobject io
    (
        name, time.timeName(), domain_, IOobject::NO_READ, IOobject::NO_WRITE,
        false
    );
    IOobject givenIO(io);
    givenIO.instance() =
        time.findInstance("", name, IOobject::READ_IF_PRESENT);
    if (isFile(io.objectPath()) || !isFile(givenIO.objectPath()))
    {
        return;
    }

    const word type(GeometricField<Type, fvPatchField, volMesh>::typeName);
    givenIO.readOpt() = IOobject::MUST_READ;
    const localIOdictionary given(givenIO, type);
    mkDir(io.path());

    // As text, exact: conditions are edited
    OFstream os(io.objectPath());
    os.precision(std::numeric_limits<scalar>::max_digits10);
    io.writeHeader(os, type);
    for (const entry& e : given)
    {
        if (e.keyword() == "internalField")
        {
            inside.writeEntry("internalField", os);
        }
        else
        {
            e.write(os);
        }
    }
    io.writeEndDivider(os);
    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << io.objectPath() << exit(FatalError);
    }
}


template void Foam::melt::domainFields::write
(
    const word& name,
    const scalarField& values
) const;

template void Foam::melt::domainFields::write
(
    const word& name,
    const vectorField& values
) const;

// ************************************************************************* //
