/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelAutomatonMethod.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "fvMesh.H"
#include "Time.H"
#include "voxelFiles.H"
#include "voxelFill.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(voxelAutomatonMethod, 0);
    addToRunTimeSelectionTable(meltMethod, voxelAutomatonMethod, scene);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

const scalarMinMax share(0, 1);

scalar number
(
    const dictionary& dict,
    const word& keyword,
    const scalarMinMax& accepted,
    const scalar defaultValue
)
{
    return checkedEntry::getOrDefault
    (
        dict, keyword, dimless, accepted, defaultValue
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::melt::voxelMaterial Foam::melt::voxelAutomatonMethod::material() const
{
    const meltThermo& thermo = scene_.thermo();
    return voxelMaterial
    (
        thermo.enthalpy(),
        thermo.rho(),
        thermo.kappaSolid(),
        thermo.kappaLiquid(),
        number
        (
            dict_.subOrEmptyDict("heat"),
            "flowFraction",
            checkedEntry::positiveUpTo(1),
            0.5
        ),
        scene_.resolution(),
        thermo.TMin(),
        thermo.TMax()
    );
}


Foam::melt::filmViscosity Foam::melt::voxelAutomatonMethod::film() const
{
    const rheologyModel& rheology = scene_.rheology();
    const meltThermo& thermo = scene_.thermo();

    // Stresses from a film of 1/1000 voxel to a column as high as the domain
    const scalar weight =
        max(thermo.rho()*mag(scene_.g()), VSMALL);
    return filmViscosity
    (
        [&](const double shearRate, const double T)
        {
            scalar eta;
            rheology.eta(1, &shearRate, &T, &eta);
            return eta;
        },
        rheology.shearRateDependent(),
        thermo.TMin(),
        thermo.TMax(),
        1e-3*weight*scene_.resolution(),
        weight*mesh_.bounds().mag(),
        checkedEntry::getOrDefault
        (
            dict_.subOrEmptyDict("spreading"),
            "yieldStress",
            dimPressure,
            checkedEntry::notNegative(),
            0
        )
    );
}


Foam::autoPtr<Foam::melt::publishedRule>
Foam::melt::voxelAutomatonMethod::readPublished()
{
    const dictionary dict(dict_.subOrEmptyDict("spreading"));
    const word rule(dict.lookupOrDefault<word>("rule", "lubrication"));
    if (rule == "lubrication")
    {
        return nullptr;
    }
    if (rule != "published")
    {
        FatalIOErrorInFunction(dict.lookup("rule"))
            << "Unknown rule " << rule << nl
            << "Valid rules: 2(lubrication published)" << exit(FatalIOError);
    }

    stepTime_ = checkedEntry::get
    (
        dict, "stepTime", dimTime, checkedEntry::positive()
    );
    publishedCoeffs c;
    c.factor = number(dict, "factor", share, 0.8);
    c.share = number(dict, "share", share, 0.1);
    c.beta = number(dict, "beta", share, 0.2);
    c.threshold = number(dict, "threshold", share, 0.1);
    c.initialEnergy = number(dict, "initialEnergy", share, 0.5);
    c.alphaLiquid = number(dict, "alphaLiquid", share, 0.98);
    c.alphaSolid = number(dict, "alphaSolid", share, 0.95);
    c.alphaFloor = number(dict, "alphaFloor", share, 0.9);
    if (4*c.share > 1)
    {
        FatalIOErrorInFunction(dict)
            << "Factors summing above 1: with share " << c.share
            << " the four neighbours of a voxel would get " << 4*c.share
            << " of its melt." << nl
            << "Accepted: share >= 0 and <= 0.25" << exit(FatalIOError);
    }
    c.random = dict.lookupOrDefault<bool>("random", false);
    c.seed = std::uint32_t(dict.lookupOrDefault<label>("seed", 0));
    return autoPtr<publishedRule>(new publishedRule(c));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::voxelAutomatonMethod::voxelAutomatonMethod
(
    fvMesh& mesh,
    const meltScene& scene
)
:
    meltMethod(mesh, scene),
    dict_(scene.numerics("voxelAutomatonSolution", IOobject::READ_IF_PRESENT)),
    frame_(mesh.bounds(), scene.g(), scene.resolution()),
    walls_(scene, frame_),
    grid_(frame_.n(), frame_.dx(), material(), walls_.open()),
    film_(film()),
    lubrication_
    (
        film_,
        scene.thermo().rho()*mag(scene.g()),
        number
        (
            dict_.subOrEmptyDict("spreading"),
            "thicknessLimit",
            checkedEntry::positive(),
            10
        ),
        number
        (
            dict_.subOrEmptyDict("spreading"),
            "waveSteps",
            checkedEntry::positive(),
            10
        )
    ),
    published_(readPublished()),
    gravity_
    (
        film_,
        mag(scene.g()),
        number(dict_.subOrEmptyDict("spreading"), "dregs", share, 0.004)
    ),
    loose_(mag(scene.g())),
    vents_(scene.dict(), frame_),
    heatInterval_
    (
        number
        (
            dict_.subOrEmptyDict("heat"),
            "interval",
            checkedEntry::positiveUpTo(1),
            0.5
        )
    ),
    heatChange_
    (
        number
        (
            dict_.subOrEmptyDict("heat"),
            "change",
            checkedEntry::positiveUpTo(1),
            0.005
        )
    )
{
    scene.periods().refuse(typeName);
    if (Pstream::parRun())
    {
        FatalErrorInFunction
            << "The method voxelAutomaton runs on the threads of one machine:"
            << " start it without mpirun, the number of threads is"
            << " OMP_NUM_THREADS" << exit(FatalError);
    }

    const dictionary heat(dict_.subOrEmptyDict("heat"));
    const label neighbours = heat.lookupOrDefault<label>("neighbours", 18);
    if (neighbours != 6 && neighbours != 18 && neighbours != 26)
    {
        FatalIOErrorInFunction(heat.lookup("neighbours"))
            << "Entry neighbours is " << neighbours
            << ". Accepted: 6, 18 or 26" << exit(FatalIOError);
    }

    const vector moved(frame_.size() - mesh.bounds().span());
    Info<< "Grid: " << frame_.n()[0] << " x " << frame_.n()[1] << " x "
        << frame_.n()[2] << " voxels of " << frame_.dx() << " m";
    if (cmptMax(cmptMag(moved)) > 1e-3*frame_.dx())
    {
        Info<< ", no whole number of voxels: the domain is " << moved
            << " m longer than its mesh";
    }
    Info<< nl << endl;

    voxelFill::fillTerrain(scene, frame_, grid_);

    // Time 0 always starts from the shapes, which may have changed
    if (mesh.time().value() > 0 && voxelFiles::found(mesh))
    {
        const scalarField list(voxelFiles::read(mesh, grid_));
        heating_.reset
        (
            new voxelHeating
            (
                scene.dict(), frame_, walls_, grid_, mesh.time().value()
            )
        );
        setSums(list);
        if (published_)
        {
            voxelFiles::readEnergies(mesh, published_->energy());
        }
    }
    else
    {
        voxelFill::fillMelt(scene, frame_, grid_);
        heating_.reset
        (
            new voxelHeating(scene.dict(), frame_, walls_, grid_, 0)
        );
        initialCentre_ = centreOfMass();
        initialPotentialEnergy_ = potentialEnergy();
        initialMass_ = grid_.totalMass();
        initialEnergy_ = grid_.totalEnergy();
    }

    scene.effects().warnNotSimulated("surfaceTension", typeName);
    if (scene.effects()("heatConduction") || heating_->active())
    {
        conduction_.reset(new voxelConduction(neighbours));
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::melt::voxelAutomatonMethod::nParticles() const
{
    return nVoxels(true, true);
}


Foam::scalar Foam::melt::voxelAutomatonMethod::particleSteps() const
{
    return particleSteps_;
}


Foam::List<Foam::Tuple2<Foam::word, Foam::scalar>>
Foam::melt::voxelAutomatonMethod::operationCounts() const
{
    return
    {
        {"particleSteps", particleSteps_},
        {"heatUpdates", conduction_ ? scalar(conduction_->updates()) : 0}
    };
}

// ************************************************************************* //
