/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltMethod.H"
#include "meltScene.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"
#include "addToRunTimeSelectionTable.H"

using namespace Foam;
using namespace Foam::melt;
using unitTest::sceneCase;

namespace Foam
{
namespace melt
{

//- A method that does nothing
class restingMethod
:
    public meltMethod
{
public:

    TypeName("resting");

    using meltMethod::meltMethod;

    virtual scalar maxDeltaT() const { return scene_.resolution(); }

    virtual word deltaTLimit() const { return "resolution"; }

    virtual void advance(const scalar deltaT) {}

    virtual void write() {}

    virtual meltDiagnostics diagnostics() const { return meltDiagnostics(); }

    virtual void report(Ostream& os) const { os << "resting" << nl; }

    virtual label nParticles() const { return scene_.points(0).size(); }

    virtual scalar particleSteps() const { return 0; }
};

defineTypeNameAndDebug(restingMethod, 0);
addToRunTimeSelectionTable(meltMethod, restingMethod, scene);

} // End namespace melt
} // End namespace Foam


TEST(MeltMethod, isSelectedByName)
{
    sceneCase files;
    const meltScene scene(files.mesh(), 0.1);
    const auto method = meltMethod::New("resting", files.mesh(), scene);

    EXPECT_EQ(method->type(), "resting");
    EXPECT_EQ(method->maxDeltaT(), 0.1);
    EXPECT_EQ(method->nParticles(), 64);
}


TEST(MeltMethod, isLookedForInItsLibrary)
{
    EXPECT_EQ(meltMethod::library("sph"), "libmeltSph.so");
    EXPECT_EQ
    (
        meltMethod::library("voxelAutomaton"), "libmeltVoxelAutomaton.so"
    );
}


TEST(MeltMethod, unknownNameListsTheValidOnes)
{
    sceneCase files;
    const meltScene scene(files.mesh(), 0.1);

    for (const char* name : {"restless", ""})
    {
        try
        {
            meltMethod::New(name, files.mesh(), scene);
            FAIL() << "nothing thrown";
        }
        catch (const error& err)
        {
            const std::string message(err.message());
            EXPECT_NE(message.find("resting"), std::string::npos) << message;
        }
    }
}


// ************************************************************************* //
