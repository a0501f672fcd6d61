/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelAutomatonMethod.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "fvMesh.H"
#include "profiling.H"
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
    c.share = number(dict, "share", scalarMinMax(0, 0.25), 0.1);
    c.beta = number(dict, "beta", share, 0.2);
    c.threshold = number(dict, "threshold", share, 0.1);
    c.initialEnergy = number(dict, "initialEnergy", share, 0.5);
    c.alphaLiquid = number(dict, "alphaLiquid", share, 0.98);
    c.alphaSolid = number(dict, "alphaSolid", share, 0.95);
    c.alphaFloor = number(dict, "alphaFloor", share, 0.9);
    c.random = dict.lookupOrDefault<bool>("random", false);
    c.seed = std::uint32_t(dict.lookupOrDefault<label>("seed", 0));
    return autoPtr<publishedRule>(new publishedRule(c));
}


Foam::scalar Foam::melt::voxelAutomatonMethod::conductionLimit() const
{
    return conduction_ ? conduction_->maxDeltaT(grid_) : GREAT;
}


Foam::scalar Foam::melt::voxelAutomatonMethod::heatLimit() const
{
    return min
    (
        heatInterval_*conductionLimit(),
        heatChange_/max(heating_->fastest, VSMALL)
    );
}


void Foam::melt::voxelAutomatonMethod::exchangeHeat()
{
    heating_->update();

    // What is written is up to date
    if (heatTime_ < heatLimit() && !mesh_.time().writeTime())
    {
        return;
    }
    const label n = max(label(std::ceil(heatTime_/conductionLimit())), 1);
    const scalar dt = heatTime_/n;
    const scalar start = mesh_.time().value() - heatTime_;
    for (label i = 0; i < n; ++i)
    {
        {
            addProfiling(sources, "heatSources");
            heating_->heat(grid_, start + (i + 0.5)*dt, dt);
        }
        if (conduction_)
        {
            addProfiling(conduction, "heatConduction");
            conduction_->conduct(grid_, dt);
        }
    }
    heatTime_ = 0;
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

    if (scene.effects()("heatConduction") || heating_->active())
    {
        conduction_.reset(new voxelConduction(neighbours));
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::voxelAutomatonMethod::maxDeltaT() const
{
    if (maxDeltaT_ > 0)
    {
        return maxDeltaT_;
    }

    if (published_)
    {
        maxDeltaT_ = stepTime_;
        limit_ = "stepTime";
        return maxDeltaT_;
    }

    maxDeltaT_ = GREAT;
    limit_ = "none";
    const auto limit = [&](const scalar deltaT, const word& name)
    {
        if (deltaT < maxDeltaT_)
        {
            maxDeltaT_ = deltaT;
            limit_ = name;
        }
    };

    times_.run
    (
        stageTimes::SPREADING,
        [&] { limit(lubrication_.prepare(grid_), "lubrication"); }
    );
    if
    (
        nVoxels(true, false) || !loose_.inFlight().empty() || vents_.active()
    )
    {
        limit(gravity_.maxDeltaT(grid_), "gravity");
    }
    else
    {
        limit
        (
            heating_->fastest < VGREAT
          ? heatLimit() : heatInterval_*conductionLimit(),
            "heat"
        );
    }
    return maxDeltaT_;
}


Foam::word Foam::melt::voxelAutomatonMethod::deltaTLimit() const
{
    maxDeltaT();
    return limit_;
}


void Foam::melt::voxelAutomatonMethod::advance(const scalar deltaT)
{
    maxDeltaT();
    particleSteps_ += nVoxels(true, true);
    ++nSteps_;

    times_.run
    (
        stageTimes::SPREADING,
        [&]
        {
            addProfiling(spreading, "spreading");
            published_
          ? published_->spread(grid_) : lubrication_.spread(grid_, deltaT);
        }
    );
    times_.run
    (
        stageTimes::FALLING,
        [&]
        {
            addProfiling(falling, "falling");
            published_
          ? published_->fall(grid_) : gravity_.fall(grid_, deltaT);
        }
    );
    if (scene_.effects()("rigidSolids"))
    {
        times_.run
        (
            stageTimes::SOLIDS,
            [&]
            {
                addProfiling(pieces, "looseSolids");
                loose_.fall(grid_, deltaT);
            }
        );
    }
    if (vents_.active())
    {
        times_.run
        (
            stageTimes::VENTS,
            [&] { vents_.flow(grid_, mesh_.time().value(), deltaT); }
        );
    }
    heatTime_ += deltaT;
    times_.run(stageTimes::HEAT, [&] { exchangeHeat(); });

    maxDeltaT_ = 0;
}


void Foam::melt::voxelAutomatonMethod::write()
{
    voxelFiles::write(mesh_, grid_, sums());
    if (published_)
    {
        voxelFiles::writeEnergies(mesh_, published_->energy());
    }
    voxelFiles::writeCloud(mesh_, frame_, grid_);
    updateDensity();
    voxelFiles::writeDensity(mesh_, frame_, grid_, density_);
}


Foam::label Foam::melt::voxelAutomatonMethod::updateDensity()
{
    label n = 0;
    times_.run(stageTimes::DENSITY, [&] { n = density_.update(grid_); });
    return n;
}


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
