/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"
#include "IOField.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::melt::eulerianMethod::stateIO
(
    const IOobject::readOption r
) const
{
    return IOobject
    (
        "state",
        mesh_.time().timeName(),
        "uniform"/eulerianMesh::regionName,
        mesh_,
        r,
        IOobject::NO_WRITE,
        false
    );
}


void Foam::melt::eulerianMethod::writeState() const
{
    DynamicList<scalar> list;
    const auto append = [&](const auto& values)
    {
        for (const scalar value : values)
        {
            list.append(value);
        }
    };

    list.append(region_.grid().nCells());
    append(region_.onGrid(interface_.alpha()));
    append(region_.onGrid(alphaH_));
    for (const std::vector<double>& U : flow_.U())
    {
        append(U);
    }
    append(flow_.p());
    append
    (
        scalarList
        ({
            lastDeltaT_, lastAcceleration_, initialCentre_.x(), initialCentre_.y(),
            initialCentre_.z(), initialPotentialEnergy_, initialMass_,
            initialEnthalpy_, heatIn_, heatOut_, interface_.lostVolume(),
            interface_.lostEnthalpy()
        })
    );
    append(vents_.state());

    IOField<scalar>
    (
        stateIO(IOobject::NO_READ), scalarField(list)
    ).writeObject
    (
        IOstream::BINARY,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}


void Foam::melt::eulerianMethod::readState()
{
    const IOField<scalar> list(stateIO(IOobject::MUST_READ));
    const label nCells = region_.grid().nCells();
    label size = 1 + 3*nCells + 12;
    for (int a = 0; a < 3; ++a)
    {
        size += region_.grid().nFaces(a);
    }
    if (list.size() < size || label(list[0]) != nCells)
    {
        FatalErrorInFunction
            << "The state in " << list.objectPath() << " is not that of the"
            << " mesh: domain or resolution have changed. Accepted: a restart"
            << " with those of the start" << exit(FatalError);
    }

    label i = 1;
    const auto take = [&](auto& values)
    {
        for (auto& value : values)
        {
            value = list[i++];
        }
    };
    std::vector<double> ofCell(nCells);
    take(ofCell);
    interface_.alpha().primitiveFieldRef() = region_.onMesh(ofCell);
    interface_.alpha().correctBoundaryConditions();
    take(ofCell);
    alphaH_ = region_.onMesh(ofCell);
    faceVelocities U(flow_.U());
    for (std::vector<double>& component : U)
    {
        take(component);
    }
    std::vector<double> p(flow_.p());
    take(p);
    flow_.set(U, p);
    lastDeltaT_ = list[i++];
    lastAcceleration_ = list[i++];
    for (direction k = 0; k < 3; ++k)
    {
        initialCentre_[k] = list[i++];
    }
    initialPotentialEnergy_ = list[i++];
    initialMass_ = list[i++];
    initialEnthalpy_ = list[i++];
    heatIn_ = list[i++];
    heatOut_ = list[i++];
    interface_.lostVolume() = list[i++];
    interface_.lostEnthalpy() = list[i++];
    vents_.setState(SubList<scalar>(list, list.size() - i, i));
}

// ************************************************************************* //
