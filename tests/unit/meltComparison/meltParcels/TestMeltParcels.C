/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltParcels.H"
#include "meltUnitTests.H"
#include "meltScene/scene/sceneCase.H"
#include "IOField.H"
#include "passiveParticleCloud.H"
#include "volFields.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

//- Write a field of time 0: values in the 8 cells of 0.5 m
void writeField
(
    const fvMesh& mesh,
    const word& name,
    const dimensionSet& dimensions,
    const scalarField& values
)
{
    volScalarField field
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(name, dimensions, 0)
    );
    field.primitiveFieldRef() = values;
    field.write();
}

} // End anonymous namespace


TEST(MeltParcels, cellsOfAField)
{
    unitTest::sceneCase scene;
    const fvMesh& mesh = scene.mesh();
    EXPECT_FALSE(meltParcels::found(mesh));
    EXPECT_THROW(meltParcels::read(mesh, 0.5), Foam::error);

    scalarField alpha(8, 0), T(8, 300);
    alpha[0] = 1;
    alpha[7] = 0.25;
    T[7] = 350;
    writeField(mesh, "alpha.melt", dimless, alpha);
    writeField(mesh, "T", dimTemperature, T);

    EXPECT_TRUE(meltParcels::found(mesh));
    const meltParcels parcels(meltParcels::read(mesh, 0.5));
    ASSERT_EQ(parcels.size(), 2);
    EXPECT_NEAR(parcels.volume[0], 0.125, 1e-12);
    EXPECT_NEAR(parcels.volume[1], 0.03125, 1e-12);
    EXPECT_EQ(parcels.T[1], 350);
    EXPECT_NEAR(mag(parcels.box[1].min() - point(0.5, 0.5, 0.5)), 0, 1e-12);
    EXPECT_NEAR(mag(parcels.bounds().max() - point::one), 0, 1e-12);
}


TEST(MeltParcels, particlesOfACloudComeFirst)
{
    unitTest::sceneCase scene;
    const fvMesh& mesh = scene.mesh();
    writeField(mesh, "alpha.melt", dimless, scalarField(8, 1));
    writeField(mesh, "T", dimTemperature, scalarField(8, 300));
    {
        passiveParticleCloud cloud(mesh, "melt", IDLList<passiveParticle>());
        cloud.addParticle(new passiveParticle(mesh, point(0.3, 0.4, 0.6), -1));
        cloud.write();
        const auto write = [&](const word& name, const scalar value)
        {
            IOField<scalar>
            (
                cloud.fieldIOobject(name, IOobject::NO_READ),
                scalarField(1, value)
            ).write();
        };
        write("m", 8);
        write("rho", 1000);
        write("T", 320);
    }

    // A full particle, and one that fills an eighth of its voxel
    for (const scalar resolution : {0.1, 0.4})
    {
        const meltParcels parcels(meltParcels::read(mesh, resolution));
        ASSERT_EQ(parcels.size(), 1);
        EXPECT_NEAR(parcels.volume[0], 0.008, 1e-12);
        EXPECT_EQ(parcels.T[0], 320);
        EXPECT_NEAR(parcels.box[0].span().x(), max(0.2, resolution), 1e-12);
        EXPECT_NEAR
        (
            mag(parcels.box[0].midpoint() - point(0.3, 0.4, 0.6)), 0, 1e-9
        );
    }
}


// ************************************************************************* //
