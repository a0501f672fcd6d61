/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "eulerianFill.H"
#include "meltTime.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(eulerianMethod, 0);
    addToRunTimeSelectionTable(meltMethod, eulerianMethod, scene);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

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


//- What a scene may have that this method does not compute
const dictionary& supported(const dictionary& meltProperties)
{
    for (const word name : {"terrain", "vents"})
    {
        if (meltProperties.subOrEmptyDict(name).size())
        {
            FatalIOErrorInFunction(meltProperties.subDict(name))
                << "The method eulerian has no " << name << '.' << nl
                << "Accepted: a scene without, or another method"
                << exit(FatalIOError);
        }
    }
    return meltProperties;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::melt::meltFlow::controls Foam::melt::eulerianMethod::flowControls
(
    const dictionary& dict,
    const bool inPlane
)
{
    const scalarMinMax share(checkedEntry::positiveUpTo(1));
    const scalarMinMax atLeastOne(1, 1e9);
    meltFlow::controls c;
    c.solver.tolerance = number(dict, "tolerance", share, 1e-8);
    c.solver.maxIterations =
        int(number(dict, "maxIterations", atLeastOne, 1000));
    c.solver.directUnknowns =
        int
        (
            number
            (
                dict,
                "directUnknowns",
                scalarMinMax(0, 1e9),
                inPlane ? 8000 : 2000
            )
        );
    c.viscosityTolerance = number(dict, "viscosityTolerance", share, 1e-4);
    c.maxSweeps = int(number(dict, "maxSweeps", atLeastOne, 20));
    c.wetFrom = number(dict, "wetFrom", checkedEntry::positiveUpTo(0.5), 1e-3);
    return c;
}


void Foam::melt::eulerianMethod::readSolid()
{
    const dictionary dict(dict_.subOrEmptyDict("solid"));
    const word type(dict.lookupOrDefault<word>("type", "constraint"));
    if (type == "constraint")
    {
        solid_ = solidType::constraint;
        flowFraction_ = number(dict, "flowFraction", scalarMinMax(0, 1), 0.5);
    }
    else if (type == "sink")
    {
        solid_ = solidType::sink;
        sinkCoefficient_ = checkedEntry::get
        (
            dict, "coefficient", dimDensity/dimTime, checkedEntry::notNegative()
        );
        sinkSmall_ = number(dict, "small", checkedEntry::positive(), 1e-3);
    }
    else if (type == "none")
    {
        solid_ = solidType::none;
    }
    else
    {
        FatalIOErrorInFunction(dict.lookup("type"))
            << "Unknown type of solid " << type << nl
            << "Valid types: 3(constraint none sink)" << exit(FatalIOError);
    }
}


Foam::scalar Foam::melt::eulerianMethod::liquidFraction
(
    const label celli
) const
{
    const scalar alpha = interface_.alpha()[celli];
    return
        alpha > VSMALL
      ? scene_.thermo().enthalpy().liquidFraction(alphaH_[celli]/alpha) : 1;
}


void Foam::melt::eulerianMethod::setSolid()
{
    std::vector<char> blocked(region_.missing());
    if (solid_ == solidType::constraint)
    {
        const scalar wetFrom = flow_.wetFrom();
        forAll(alphaH_, celli)
        {
            if
            (
                interface_.alpha()[celli] >= wetFrom
             && liquidFraction(celli) < flowFraction_
            )
            {
                blocked[region_.gridCell(celli)] = 1;
            }
        }
    }
    region_.grid().setBlocked(blocked);
}


std::vector<double> Foam::melt::eulerianMethod::sink() const
{
    if (solid_ != solidType::sink)
    {
        return std::vector<double>();
    }
    scalarField k(alphaH_.size());
    forAll(k, celli)
    {
        const scalar f = liquidFraction(celli);
        k[celli] = sinkCoefficient_*sqr(1 - f)/(pow3(f) + sinkSmall_);
    }
    return region_.onGrid(k);
}


Foam::melt::faceVelocities Foam::melt::eulerianMethod::acceleration() const
{
    const staggeredGrid& grid = region_.grid();
    const fvMesh& mesh = region_.mesh();
    faceVelocities result;
    for (direction a = 0; a < 3; ++a)
    {
        result[a].assign(grid.nFaces(a), scene_.g()[a]);
    }
    if (beta_ != 0)
    {
        // Of melt on both sides, or on one
        const auto buoyant = [&](const label celli)
        {
            return
                interface_.alpha()[celli] > VSMALL
              ? 1 - beta_*(energy_.T()[celli] - TRef_) : -1;
        };
        forAll(mesh.neighbour(), facei)
        {
            const scalar own = buoyant(mesh.owner()[facei]);
            const scalar nei = buoyant(mesh.neighbour()[facei]);
            if (own >= 0 || nei >= 0)
            {
                const eulerianMesh::gridFace& g = region_.onGrid(facei);
                result[g.direction][g.face] *=
                    own < 0 ? nei : nei < 0 ? own : 0.5*(own + nei);
            }
        }
    }
    return result;
}


void Foam::melt::eulerianMethod::fail
(
    const scalar deltaT,
    const string& equation,
    const UList<scalar>& residuals,
    const string& advice
)
{
    Time& time = const_cast<Time&>(mesh_.time());
    time.setTime(time.value() - remaining_, time.timeIndex() - 1);
    if (isA<meltTime>(time))
    {
        refCast<meltTime>(time).writeChecked([&]() { write(); });
    }
    FatalErrorInFunction
        << "The " << equation.c_str() << " equation has no solution in the step"
        << " of " << deltaT << " s from time " << time.timeName() << " s." << nl
        << "Relative residuals: " << residuals << nl
        << advice.c_str() << nl
        << "The state before the step is written." << exit(FatalError);
}


void Foam::melt::eulerianMethod::flow(const scalar deltaT)
{
    setSolid();
    const meltThermo& thermo = scene_.thermo();
    const rheologyModel& rheology = scene_.rheology();

    std::vector<double> T(region_.onGrid(energy_.T()));
    for (double& value : T)
    {
        value = min(max(value, thermo.TMin()), thermo.TMax());
    }
    flowRecord_ = flow_.advance
    (
        region_.onGrid(interface_.alpha()),
        thermo.rho(),
        deltaT,
        acceleration(),
        sink(),
        [&]
        (
            const std::vector<double>& rate,
            const std::vector<int>& cell,
            std::vector<double>& eta
        )
        {
            std::vector<double> TOfCell(cell.size());
            for (std::size_t i = 0; i < cell.size(); ++i)
            {
                TOfCell[i] = T[cell[i]];
            }
            rheology.eta
            (
                label(eta.size()), rate.data(), TOfCell.data(), eta.data()
            );
        },
        scene_.effects()("generalisedNewtonian")
    );
    if (!flowRecord_.solved)
    {
        scalarList residuals(flowRecord_.residuals.size());
        std::copy
        (
            flowRecord_.residuals.begin(),
            flowRecord_.residuals.end(),
            residuals.begin()
        );
        fail
        (
            deltaT,
            "momentum",
            residuals,
            "Remedy: a smaller deltaT in controlDict, a larger tolerance of"
            " momentum in eulerianSolution, a rheology whose viscosity differs"
            " less"
        );
    }
}


void Foam::melt::eulerianMethod::exchangeHeat(const scalar deltaT)
{
    const scalarField& alpha = interface_.alpha();
    energy_.setT(alpha, alphaH_);
    if (!conducts_ && !heating_->active())
    {
        return;
    }
    const scalar time = mesh_.time().value() - remaining_ + 0.5*deltaT;
    energyRecord_ = energy_.advance
    (
        alpha,
        deltaT,
        heating_->heat(time, alpha, energy_.T()),
        alphaH_
    );
    if (!energyRecord_.converged)
    {
        fail
        (
            deltaT,
            "energy",
            energyRecord_.errors,
            "Remedy: a smaller deltaT in controlDict, or more maxIterations of"
            " energy in eulerianSolution"
        );
    }
    heatIn_ += energyRecord_.in;
    heatOut_ += energyRecord_.out;
    energy_.setT(alpha, alphaH_);
}


Foam::scalar Foam::melt::eulerianMethod::longestStep(word& limit) const
{
    // From rest: no faster than falling freely
    scalar dx = GREAT;
    for (int a = 0; a < 3; ++a)
    {
        if (region_.grid().solved(a))
        {
            dx = min(dx, region_.grid().d()[a]);
        }
    }
    scalar longest = sqrt(Courant_*dx/max(mag(scene_.g()), VSMALL));
    limit = "start";
    if (lastDeltaT_ > 0)
    {
        longest = growth_*lastDeltaT_;
        limit = "growth";
    }
    const scalar Courant = interface_.Courant(flow_.U(), 1);
    if (Courant*longest > Courant_)
    {
        longest = Courant_/Courant;
        limit = "Courant";
    }
    return longest;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::eulerianMethod::eulerianMethod
(
    fvMesh& mesh,
    const meltScene& scene
)
:
    meltMethod(mesh, scene),
    dict_
    (
        IOobject
        (
            "eulerianSolution",
            mesh.time().system(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        )
    ),
    region_(scene),
    flow_
    (
        region_.grid(),
        flowControls
        (
            dict_.subOrEmptyDict("momentum"), region_.mesh().nSolutionD() < 3
        )
    ),
    interface_(region_),
    alphaH_(region_.mesh().nCells(), 0),
    energy_(region_, scene.thermo(), dict_.subOrEmptyDict("energy")),
    p_rgh_
    (
        IOobject
        (
            "p_rgh",
            mesh.time().timeName(),
            region_.mesh(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        region_.mesh(),
        dimensionedScalar(dimPressure, Zero),
        "zeroGradient"
    ),
    conducts_(scene.effects()("heatConduction")),
    Courant_
    (
        number
        (
            dict_.subOrEmptyDict("timeStep"),
            "Courant",
            checkedEntry::positiveUpTo(0.5),
            0.4
        )
    ),
    growth_
    (
        number
        (
            dict_.subOrEmptyDict("timeStep"),
            "growth",
            scalarMinMax(1 + SMALL, GREAT),
            2
        )
    ),
    beta_
    (
        checkedEntry::getOrDefault
        (
            dict_.subOrEmptyDict("buoyancy"),
            "beta",
            dimless/dimTemperature,
            checkedEntry::any(),
            0
        )
    ),
    TRef_
    (
        beta_ == 0
      ? 0
      : checkedEntry::get
        (
            dict_.subDict("buoyancy"),
            "TRef",
            dimTemperature,
            checkedEntry::notNegative()
        )
    )
{
    supported(scene.dict());
    readSolid();

    // Time 0 always starts from the shapes, which may have changed
    if
    (
        mesh.time().value() > 0
     && stateIO(IOobject::MUST_READ).typeHeaderOk<IOField<scalar>>(true)
    )
    {
        readState();
    }
    else
    {
        faceVelocities U(flow_.U());
        eulerianFill::fill
        (
            scene, region_, interface_.alpha().primitiveFieldRef(), alphaH_, U
        );
        flow_.set(U, flow_.p());
        interface_.alpha().correctBoundaryConditions();
        initialCentre_ = centreOfMass();
        initialMass_ = mass();
        initialEnthalpy_ = enthalpy();
        initialPotentialEnergy_ = -initialMass_*(scene.g() & initialCentre_);
    }
    energy_.setT(interface_.alpha(), alphaH_);
    setSolid();
    interface_.setCellVelocities(flow_.U());
    heating_.reset
    (
        new surfaceHeat
        (
            region_,
            scene.dict(),
            interface_.alpha(),
            mesh.time().value()
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::eulerianMethod::maxDeltaT() const
{
    word limit;
    return longestStep(limit);
}


Foam::word Foam::melt::eulerianMethod::deltaTLimit() const
{
    word limit;
    longestStep(limit);
    return limit;
}


void Foam::melt::eulerianMethod::advance(const scalar deltaT)
{
    remaining_ = deltaT;
    scalar step = deltaT;
    while (remaining_ > 0)
    {
        const scalar part = step < (1 - SMALL)*remaining_ ? step : remaining_;
        const faceVelocities U(flow_.U());
        const std::vector<double> p(flow_.p());
        flow(part);

        // What has just melted may be faster than anything was before
        const scalar Courant = interface_.Courant(flow_.U(), part);
        if (Courant > 2*Courant_)
        {
            flow_.set(U, p);
            step = part*Courant_/Courant;
            continue;
        }
        interfaceSteps_ =
            interface_.advance(flow_.U(), part, Courant_, alphaH_);
        exchangeHeat(part);
        remaining_ = part < remaining_ ? remaining_ - part : 0;
        lastDeltaT_ = step;
        step *= growth_;
        cellSteps_ += nParticles();
    }
}


void Foam::melt::eulerianMethod::write()
{
    const fvMesh& mesh = region_.mesh();
    const scalarField p(region_.onMesh(flow_.p()));
    const scalar rho = scene_.thermo().rho();
    forAll(p, celli)
    {
        p_rgh_[celli] =
            interface_.alpha()[celli] > 0
          ? p[celli] - rho*(scene_.g() & mesh.C()[celli]) : 0;
    }
    p_rgh_.correctBoundaryConditions();
    writeState();
}


Foam::label Foam::melt::eulerianMethod::nParticles() const
{
    label n = 0;
    for (const scalar alpha : interface_.alpha().primitiveField())
    {
        n += alpha > 0;
    }
    return n;
}


Foam::scalar Foam::melt::eulerianMethod::particleSteps() const
{
    return cellSteps_;
}

// ************************************************************************* //
