/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphMethod.H"
#include "addToRunTimeSelectionTable.H"
#include "apparentViscosity.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "divergence.H"
#include "effectTimes.H"
#include "fvMesh.H"
#include "shape.H"
#include "sphPeriods.H"
#include "Time.H"
#include "wallParticleGenerator.H"

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


void Foam::melt::sphMethod::makeWalls()
{
    const List<wallCondition>& conditions = scene_.walls().conditions();
    labelList patches;
    for (const wallCondition& condition : conditions)
    {
        if (condition.isWall())
        {
            patches.append(condition.patchi);
        }
    }

    wallState& walls = system_.walls;
    static_cast<wallParticles&>(walls) = wallParticleGenerator::generate
    (
        mesh_,
        patches,
        system_.spacing,
        system_.near.radius(),
        mesh_.bounds()
    );

    const label n = label(walls.size());
    for (label i = 0; i < n; ++i)
    {
        const wallCondition& condition = conditions[walls.patch[i]];
        const label facei = walls.face[i];
        const vector& U = condition.U[facei];
        const bool adiabatic =
            condition.thermal == wallCondition::thermalType::adiabatic;
        const bool convective =
            condition.thermal == wallCondition::thermalType::convective;

        walls.wallU.push_back(U.x());
        walls.wallV.push_back(U.y());
        walls.wallW.push_back(U.z());
        walls.slip.push_back
        (
            condition.velocity == wallCondition::velocityType::slip
        );
        walls.T.push_back(adiabatic ? 0 : condition.T[facei]);
        walls.heatTransfer.push_back
        (
            adiabatic ? 0
          : convective ? condition.h[facei]
          : std::numeric_limits<double>::infinity()
        );
    }
    walls.u = walls.wallU;
    walls.v = walls.wallV;
    walls.w = walls.wallW;
    walls.p.assign(n, 0);

    system_.near.setWalls(walls);
}


void Foam::melt::sphMethod::bindFields()
{
    particles& f = system_.fluid;

    cloud_.addLabel("origId", f.id);
    if (!f.body.empty())
    {
        cloud_.addLabel("body", f.body, false);
    }
    if (!f.anchored.empty())
    {
        cloud_.addLabel("anchored", f.anchored, false);
    }
    cloud_.addVector("U", f.u, f.v, f.w);
    cloud_.addScalar("T", f.T);
    cloud_.addScalar("h", f.h);
    cloud_.addScalar("rho", f.rho);
    cloud_.addScalar("m", f.m);
    cloud_.addScalar("p", f.p, false);
    cloud_.addVector("dUdt", f.ax, f.ay, f.az);
    cloud_.addScalar("dRhodt", f.dRho);
    if (!f.dH.empty())
    {
        cloud_.addScalar("dHdt", f.dH, false);
    }
    if (!f.du.empty())
    {
        cloud_.addVector("UXSPH", f.du, f.dv, f.dw, false);
    }
    if (!f.eta.empty())
    {
        cloud_.addScalar("eta", f.eta);
        cloud_.addDerivedScalar
        (
            "shearRate",
            [&](double* shearRate)
            {
                for (int i = 0; i < f.size(); ++i)
                {
                    shearRate[i] = shearRateOf(f, i);
                }
            }
        );
    }
    if (scene_.rheology().jumpNumber(scalarField(1, f.T[0]))().size())
    {
        cloud_.addDerivedScalar
        (
            "J",
            [&](double* J)
            {
                const scalarField T(UList<scalar>(f.T.data(), f.size()));
                const scalarField value(scene_.rheology().jumpNumber(T));
                std::copy(value.begin(), value.end(), J);
            }
        );
    }
}


void Foam::melt::sphMethod::fill()
{
    particles& f = system_.fluid;
    const meltThermo& thermo = scene_.thermo();

    label n = 0;
    forAll(scene_.shapes(), shapei)
    {
        n += scene_.points(shapei).size();
    }
    f.resize(n);

    label i = 0;
    forAll(scene_.shapes(), shapei)
    {
        const pointField& points = scene_.points(shapei);
        const scalarField& T = scene_.T(shapei);
        const vectorField U(scene_.shapes()[shapei].velocity(points));

        forAll(points, pointi)
        {
            f.x[i] = points[pointi].x();
            f.y[i] = points[pointi].y();
            f.z[i] = points[pointi].z();
            f.u[i] = U[pointi].x();
            f.v[i] = U[pointi].y();
            f.w[i] = U[pointi].z();
            f.rho[i] = thermo.rho();
            f.m[i] = thermo.rho()*scene_.pointVolume(shapei);
            f.T[i] = T[pointi];
            f.h[i] = thermo.enthalpy().h(T[pointi]);
            f.id[i] = i;
            ++i;
        }
    }
}


void Foam::melt::sphMethod::removeEscaped()
{
    particles& f = system_.fluid;
    const boundBox& domain = mesh_.bounds();

    // A particle may have gone through a cyclic patch since the lists were built
    const periodicBox& box = system_.near.box();
    const auto inside = [&](const double x, const int axis)
    {
        return box.period(axis) > 0 ? box.inside(x, axis) : x;
    };

    std::vector<int> staying;
    for (int i = 0; i < f.size(); ++i)
    {
        const point image
        (
            inside(f.x[i], 0), inside(f.y[i], 1), inside(f.z[i], 2)
        );
        if (domain.contains(image))
        {
            staying.push_back(i);
        }
        else
        {
            escapedMass_ += f.m[i];
        }
    }

    if (int(staying.size()) < f.size())
    {
        const List<wallCondition>& conditions = scene_.walls().conditions();
        const bool closed = std::all_of
        (
            conditions.begin(),
            conditions.end(),
            [](const wallCondition& c)
            {
                return c.velocity != wallCondition::velocityType::open;
            }
        );
        if (closed)
        {
            endDivergedRun
            (
                f,
                mesh_.time().value(),
                "a particle has left the domain, which has no open patch"
            );
        }
        f.permute(staying);
        system_.near.build(f, system_.walls);
    }
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
