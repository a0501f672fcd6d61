/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldDiagnostics.H"
#include "meltUnitTests.H"
#include "meltScene/scene/sceneCase.H"
#include "IStringStream.H"

using namespace Foam;
using namespace Foam::melt;

namespace
{

const meltThermo& thermo()
{
    static const meltThermo material
    (
        dictionary
        (
            IStringStream
            (
                "rho 1000; Cp 2000; kappa 0.2; solidus 330; liquidus 340;"
                " latentHeat 1e5; TMin 200; TMax 400;"
            )()
        )
    );
    return material;
}

} // End anonymous namespace


// 8 cells of 0.5 m; gravity is along -z
TEST(FieldDiagnostics, closedFormsOfACorner)
{
    unitTest::sceneCase scene;
    const fvMesh& mesh = scene.mesh();
    const fieldDiagnostics diagnostics
    (
        mesh, thermo(), vector(0, 0, -10), 0.5
    );

    // Full in the cell at the origin, a quarter above it, which is not seen
    scalarField alpha(mesh.nCells(), 0);
    vectorField U(mesh.nCells(), vector(100, 0, 0));
    scalarField h(mesh.nCells(), 0);
    alpha[0] = 1;
    alpha[4] = 0.25;
    U[0] = vector(0, 3, 4);
    U[4] = vector(6, 0, 0);
    h[0] = thermo().enthalpy().h(320);
    h[4] = thermo().enthalpy().h(350);

    const point corner(0, 0, 0);
    const meltDiagnostics d(diagnostics.calculate(alpha, U, h, corner));
    const scalar m0 = 125, m4 = 31.25;

    EXPECT_NEAR(d.mass, m0 + m4, 1e-9);
    EXPECT_NEAR(d.volume, 0.15625, 1e-12);
    EXPECT_NEAR(d.meltedFraction, 0.2, 1e-12);
    EXPECT_NEAR(d.solidFraction(), 0.8, 1e-12);
    EXPECT_NEAR(d.centreOfMass.x(), 0.25, 1e-12);
    EXPECT_NEAR(d.centreOfMass.z(), 0.8*0.25 + 0.2*0.75, 1e-12);
    EXPECT_NEAR(d.kineticEnergy, 0.5*(m0*25 + m4*36), 1e-9);
    EXPECT_NEAR(d.thermalEnergy, m0*h[0] + m4*h[4], 1e-6);
    EXPECT_NEAR(d.potentialEnergy, (m0 + m4)*10*d.centreOfMass.z(), 1e-9);

    // What is seen
    EXPECT_EQ(d.maxU, 5);
    EXPECT_NEAR(d.minT, 320, 1e-9);
    EXPECT_NEAR(d.maxT, 320, 1e-9);
    EXPECT_NEAR(d.height, 0.5, 1e-12);
    EXPECT_NEAR(mag(d.bounds.max() - point(0.5, 0.5, 0.5)), 0, 1e-12);
    EXPECT_NEAR(d.frontRadius, 0.25*std::sqrt(2.0) + 0.25, 1e-12);
    EXPECT_NEAR
    (
        mag(diagnostics.centreOfMass(alpha) - d.centreOfMass), 0, 1e-12
    );
}


TEST(FieldDiagnostics, noMeltIsNoFigures)
{
    unitTest::sceneCase scene;
    const label n = scene.mesh().nCells();
    const fieldDiagnostics diagnostics
    (
        scene.mesh(), thermo(), vector(0, 0, -10), 0.5
    );
    const meltDiagnostics d
    (
        diagnostics.calculate
        (
            scalarField(n, 0), vectorField(n, Zero), scalarField(n, 0), Zero
        )
    );

    EXPECT_TRUE(d.finite());
    EXPECT_EQ(d.mass, 0);
    EXPECT_EQ(d.height, 0);
    EXPECT_EQ(d.maxT, 0);
}


// ************************************************************************* //
