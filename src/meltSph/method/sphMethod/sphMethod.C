/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphMethod.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "divergence.H"
#include "effectTimes.H"
#include "fvMesh.H"
#include "sphPeriods.H"
#include "Time.H"

#include <limits>
#include <stdexcept>

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(sphMethod, 0);
    addToRunTimeSelectionTable(meltMethod, sphMethod, scene);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::melt::smoothingKernel Foam::melt::sphMethod::kernel
(
    const dictionary& dict,
    const meltScene& scene
)
{
    const dictionary& kernelDict = dict.subDict("kernel");
    const word type(kernelDict.get<word>("type"));

    const std::vector<std::string>& names = smoothingKernel::names();
    if (std::find(names.begin(), names.end(), type) == names.end())
    {
        wordList valid;
        for (const std::string& name : names)
        {
            valid.append(name);
        }
        FatalIOErrorInFunction(kernelDict)
            << "Unknown type " << type << " of kernel" << nl
            << "Valid types: " << valid << exit(FatalIOError);
    }

    const scalar ratio = checkedEntry::get
    (
        kernelDict, "smoothingRatio", dimless, checkedEntry::positive()
    );
    return smoothingKernel
    (
        smoothingKernel::typeOf(type),
        ratio*scene.resolution(),
        scene.mesh().nGeometricD(),
        depth(scene)
    );
}


Foam::scalar Foam::melt::sphMethod::depth(const meltScene& scene)
{
    const fvMesh& mesh = scene.mesh();
    if (mesh.nGeometricD() == 3)
    {
        return 1;
    }

    for (direction d = 0; d < vector::nComponents; ++d)
    {
        const scalar depth = mesh.bounds().span()[d];
        if (mesh.geometricD()[d] < 0 && mag(depth/scene.resolution() - 1) > 0.01)
        {
            FatalErrorInFunction
                << "The method sph takes a plane domain that is one particle"
                << " deep: the mesh is " << depth << " m deep in direction "
                << label(d) << ", the resolution is " << scene.resolution()
                << " m" << exit(FatalError);
        }
    }
    return scene.resolution();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::sphMethod::sphMethod(fvMesh& mesh, const meltScene& scene)
:
    meltMethod(mesh, scene),
    dict_(scene.numerics("sphSolution", IOobject::MUST_READ)),
    system_
    {
        scene.thermo(),
        scene.rheology(),
        {scene.g().x(), scene.g().y(), scene.g().z()},
        scene.resolution(),
        neighbourhood
        (
            kernel(dict_, scene),
            checkedEntry::get
            (
                dict_.subDict("neighbours"),
                "skin",
                dimless,
                checkedEntry::positiveUpTo(1)
            ),
            periodsOf(scene)
        ),
        particles(),
        wallState()
    },
    scheme_(sphScheme::New(dict_, scene.effects(), system_)),
    cloud_
    (
        mesh, "melt", system_.fluid.x, system_.fluid.y, system_.fluid.z
    ),
    sums_
    (
        IOobject
        (
            "meltSums",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        )
    )
{
    if (Pstream::parRun())
    {
        FatalErrorInFunction
            << "The method sph runs on the threads of one machine: start it"
            << " without mpirun, the number of threads is OMP_NUM_THREADS"
            << exit(FatalError);
    }

    scene.effects().warnNotSimulated("surfaceTension", typeName);
    if (scene.effects()("heatSources"))
    {
        heating_.reset(new surfaceHeating(scene.dict(), system_));
    }

    makeWalls();
    checkPeriods(scene, system_);
    fill();
    scheme_->allocate();
    bindFields();
    // Time 0 always starts from the shapes, which may have changed
    const bool restart = mesh.time().value() > 0 && cloud_.read();
    system_.near.build(system_.fluid, system_.walls);

    if (restart)
    {
        // Arrays that are no part of the written state
        scheme_->allocate();
        system_.fluid.require({&system_.fluid.V});
        readSums();
        scheme_->resume();
    }
    else
    {
        scheme_->start();
        initialCentre_ = centreOfMass();
        initialPotentialEnergy_ = potentialEnergy();
    }
}

// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::melt::sphMethod::maxDeltaT() const
{
    return const_cast<sphScheme&>(*scheme_).limits().deltaT();
}


Foam::word Foam::melt::sphMethod::deltaTLimit() const
{
    return const_cast<sphScheme&>(*scheme_).limits().ruling();
}


void Foam::melt::sphMethod::advance(const scalar deltaT)
{
    const std::uint64_t nBuilds = system_.near.nBuilds();

    if (heating_.valid())
    {
        const effectTimes::part timing("heatSources", "surfaceHeating");
        system_.heatReceived +=
            heating_->heat(mesh_.time().value(), deltaT);
    }
    try
    {
        scheme_->advance(deltaT);
    }
    catch (const std::runtime_error& e)
    {
        endDivergedRun(system_.fluid, mesh_.time().value(), e.what());
    }
    if (!densityIsPositive(system_.fluid))
    {
        endDivergedRun
        (
            system_.fluid,
            mesh_.time().value(),
            "the density of a particle is not positive"
        );
    }

    if (system_.near.nBuilds() != nBuilds)
    {
        removeEscaped();
    }

    (system_.heatReceived > 0 ? heatIn_ : heatOut_) +=
        mag(system_.heatReceived);
    system_.heatReceived = 0;
    particleSteps_ += system_.fluid.size();
}


void Foam::melt::sphMethod::write()
{
    particles& f = system_.fluid;
    const enthalpyCurve curve = scene_.thermo().enthalpy();

    // Lists are made anew, as a restart makes them, so that both go on alike
    try
    {
        system_.near.build(f, system_.walls);
    }
    catch (const std::runtime_error& e)
    {
        endDivergedRun(f, mesh_.time().value(), e.what());
    }

    for (int i = 0; i < f.size(); ++i)
    {
        f.T[i] = curve.T(f.h[i]);
    }
    scheme_->resume();
    writeSums();
}


Foam::label Foam::melt::sphMethod::nParticles() const
{
    return system_.fluid.size();
}


Foam::scalar Foam::melt::sphMethod::particleSteps() const
{
    return particleSteps_;
}


Foam::List<Foam::Tuple2<Foam::word, Foam::scalar>>
Foam::melt::sphMethod::operationCounts() const
{
    return
    {
        {"particleSteps", particleSteps_},
        {"pairVisits", scalar(system_.near.pairVisits())},
        {"listBuilds", scalar(system_.near.nBuilds())},
        {"solverIterations", scheme_->solverIterations()}
    };
}

// ************************************************************************* //
