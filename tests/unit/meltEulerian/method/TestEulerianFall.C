/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"

using namespace Foam;
using namespace Foam::melt;
using unitTest::sceneCase;

namespace
{

//- A cube of liquid in the air
void setCube(sceneCase& files)
{
    files.setShapes
    (
        sceneCase::box
        (
            "cube", "(0.3 0.3 0.5)", "(0.7 0.7 0.9)",
            "{ type uniform; value 350; }"
        )
    );
}

} // End anonymous namespace


// Liquid melt in the air falls as stones do, to the first order of the step
TEST(EulerianMethod, liquidFalls)
{
    sceneCase files;
    setCube(files);
    const meltScene scene(files.mesh(), 0.1);
    eulerianMethod method(files.mesh(), scene);
    scalar time = 0;
    while (time < 0.2)
    {
        const scalar deltaT = min(method.maxDeltaT(), 0.005);
        method.advance(deltaT);
        time += deltaT;
    }
    const meltDiagnostics d(method.diagnostics());
    EXPECT_NEAR(d.centreOfMass.z(), 0.7 - 0.5*9.81*sqr(time), 0.01);
    EXPECT_NEAR(d.centreOfMass.x(), 0.5, 1e-9);
}


// In steps of its own choice: short by half the speed that a step gives, which
// the limit of the force keeps to 0.05 sqrt(g dx)
TEST(EulerianMethod, fallsInItsOwnSteps)
{
    const auto fall = [](const std::string& timeStep)
    {
        sceneCase files;
        files.set("system/eulerianSolution", "timeStep { " + timeStep + " }");
        setCube(files);
        const meltScene scene(files.mesh(), 0.1);
        eulerianMethod method(files.mesh(), scene);
        method.advance(0.2);
        return 0.7 - method.diagnostics().centreOfMass.z();
    };
    const scalar exact = 0.5*9.81*sqr(0.2);
    const scalar bound = 0.5*0.05*std::sqrt(9.81*0.1)*0.2;
    EXPECT_LE(mag(fall("") - exact), 1.02*bound);
    EXPECT_LE(mag(fall("force 0.025;") - exact), 0.51*bound);

    // Where the limit is not, one step is twice too far
    EXPECT_GT(fall("force 10; Courant 0.5;") - exact, 4*bound);
}

// ************************************************************************* //
