/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphCloud.H"
#include "sphCloudFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(sphCloud, 0);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::sphCloud::binds(const word& name) const
{
    const auto hasName = [&](const auto& entry) { return entry.name == name; };

    return
        std::any_of(scalars_.begin(), scalars_.end(), hasName)
     || std::any_of(vectors_.begin(), vectors_.end(), hasName)
     || std::any_of(labels_.begin(), labels_.end(), hasName);
}


void Foam::melt::sphCloud::checkName(const word& name) const
{
    const auto derives = [&](const auto& entry) { return entry.first == name; };

    if
    (
        binds(name)
     || std::any_of(derivedScalars_.begin(), derivedScalars_.end(), derives)
     || std::any_of(derivedVectors_.begin(), derivedVectors_.end(), derives)
     || geometryTypeNames.found(name)
    )
    {
        FatalErrorInFunction
            << "cloud " << this->name() << " has a field " << name
            << " already" << abort(FatalError);
    }
}


Foam::IOobject Foam::melt::sphCloud::fieldObject
(
    const word& name,
    const IOobject::readOption read
) const
{
    return IOobject
    (
        name,
        time().timeName(),
        *this,
        read,
        IOobject::NO_WRITE,
        false
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::sphCloud::sphCloud
(
    const polyMesh& mesh,
    const word& name,
    std::vector<double>& x,
    std::vector<double>& y,
    std::vector<double>& z
)
:
    cloud(mesh, name),
    mesh_(mesh),
    x_(x),
    y_(y),
    z_(z),
    outside_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::sphCloud::addScalar
(
    const word& name,
    std::vector<double>& values,
    const bool required
)
{
    checkName(name);
    scalars_.push_back({name, &values, required});
}


void Foam::melt::sphCloud::addVector
(
    const word& name,
    std::vector<double>& x,
    std::vector<double>& y,
    std::vector<double>& z,
    const bool required
)
{
    checkName(name);
    vectors_.push_back({name, &x, &y, &z, required});
}


void Foam::melt::sphCloud::addLabel
(
    const word& name,
    std::vector<int>& values,
    const bool required
)
{
    checkName(name);
    labels_.push_back({name, &values, required});
}


void Foam::melt::sphCloud::addDerivedScalar
(
    const word& name,
    const scalarFunction& function
)
{
    checkName(name);
    derivedScalars_.push_back({name, function});
}


void Foam::melt::sphCloud::addDerivedVector
(
    const word& name,
    const vectorFunction& function
)
{
    checkName(name);
    derivedVectors_.push_back({name, function});
}


void Foam::melt::sphCloud::writeObjects(objectRegistry& obr) const
{
    cloud::createIOField<point>("position", nParcels(), obr) = positions();

    forAllFields
    (
        [&](const word& name, const auto& field)
        {
            typedef typename std::decay_t<decltype(field)>::value_type Type;
            cloud::createIOField<Type>(name, nParcels(), obr) = field;
        }
    );
}


// ************************************************************************* //
