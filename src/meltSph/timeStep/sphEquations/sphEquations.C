/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphEquations.H"
#include "blockSum.H"
#include "effectTimes.H"
#include "velocityGradient.H"
#include "wallExtrapolation.H"

Foam::melt::sphEquations::sphEquations
(
    const dictionary& dict,
    const effectSwitches& effects,
    sphSystem& system
)
:
    system_(system),
    control_(dict.subDict("timeStep")),
    solver_(dict.subOrEmptyDict("implicit"))
{
    const auto add = [&](const word& role, const word& effect)
    {
        terms_.append(rateTerm::New(dict.subDict(role), system_));
        effects_.append(effect);
    };

    system_.generalisedNewtonian = effects("generalisedNewtonian");
    heatSources_ = effects("heatSources");

    add("pressure", effectTimes::flow);
    add("viscosity", effectTimes::flow);
    if (effects("heatConduction"))
    {
        add("heat", "heatConduction");
    }
    for (const word& role : {"artificialViscosity", "XSPH"})
    {
        if (effects(role) && dict.found(role))
        {
            add(role, role);
        }
    }
    if (effects("particleShifting"))
    {
        if (system_.pairs.xsph)
        {
            FatalIOErrorInFunction(dict)
                << "XSPH and particleShifting both set the velocity by which"
                << " positions move. Accepted: one of them off, in the effects"
                << " of constant/meltProperties" << exit(FatalIOError);
        }
        add("shifting", "particleShifting");
    }
    else if (dict.found("shifting"))
    {
        Info<< "Warning: shifting of " << dict.name() << " is not used: the"
            << " effect particleShifting is off" << endl;
    }

    if (effects("particleCollision") && dict.found("collision"))
    {
        collision_.reset
        (
            new particleCollision(dict.subDict("collision"), system_)
        );
    }

    for (rateTerm& term : terms_)
    {
        if (implicitOperator* force = term.implicitForce())
        {
            solver_.add(*force);
        }
    }

    if (effects("rigidSolids") && dict.found("solids"))
    {
        solids_ = solidModel::New(dict.subDict("solids"), system_);
        if (solids_.valid() && (system_.pairs.pressure || system_.pairs.stress))
        {
            FatalIOErrorInFunction(dict.subDict("solids"))
                << "Solids of type " << solids_->type() << " take the forces"
                << " of liquid by the implicit terms alone: they need the"
                << " scheme incompressible, pressure { type"
                << " implicitPressure; } and viscosity { type"
                << " implicitViscosity; }; the explicit terms go with solids"
                << " of type viscous" << exit(FatalIOError);
        }
        if (solids_.valid() && system_.near.box().any())
        {
            FatalIOErrorInFunction(dict.subDict("solids"))
                << "Solids of type " << solids_->type() << " do not go with"
                << " cyclic patches." << nl << "Accepted: type viscous, or a"
                << " domain without" << exit(FatalIOError);
        }
        solver_.constrain(solids_.get());
    }
}


void Foam::melt::sphEquations::allocate()
{
    for (rateTerm& term : terms_)
    {
        term.allocate();
    }
    if (solids_.valid())
    {
        solids_->allocate();
    }
}


void Foam::melt::sphEquations::evaluate()
{
    particles& f = system_.fluid;
    const int n = f.size();
    const enthalpyCurve curve = system_.thermo.enthalpy();
    const bool heat = heatSources_ || !f.dH.empty();

    forSolids([](solidModel& solids) { solids.update(); });

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        f.V[i] = f.m[i]/f.rho[i];
        f.ax[i] = system_.g[0];
        f.ay[i] = system_.g[1];
        f.az[i] = system_.g[2];
        if (heat)
        {
            f.T[i] = curve.T(f.h[i]);
        }
    }

    forTerms([](rateTerm& term) { term.prepare(); });
    {
        const effectTimes::part timing(effectTimes::flow, "wallExtrapolation");
        wallExtrapolation(system_.near, f, system_.g, system_.walls);
    }
    {
        const effectTimes::part timing(effectTimes::flow, "velocityGradient");
        velocityGradient(system_.near, system_.walls, f, system_.deformation);
    }
    forTerms([](rateTerm& term) { term.addRates(); });
    forSolids([](solidModel& solids) { solids.setProperties(); });
    {
        const effectTimes::part timing(effectTimes::flow, pairRates::typeName);
        system_.heatFromWalls =
            system_.pairs.add(system_.near, system_.walls, f);
    }
    forSolids([](solidModel& solids) { solids.projectRates(); });
}


void Foam::melt::sphEquations::advanceHeat(const scalar deltaT)
{
    forTerms([deltaT](rateTerm& term) { term.advanceHeat(deltaT); });
}


bool Foam::melt::sphEquations::implicitUpdate(const scalar deltaT)
{
    const effectTimes::part timing(effectTimes::flow, "implicitForces");
    return solver_.solve(system_, deltaT);
}


void Foam::melt::sphEquations::addImplicitForces
(
    const vectorArray& v,
    const double sources,
    vectorArray& force
)
{
    for (rateTerm& term : terms_)
    {
        if (implicitOperator* o = term.implicitForce())
        {
            o->addForce(v, sources, force);
        }
    }
}


bool Foam::melt::sphEquations::couple(const label nSolved)
{
    bool coupled = true;
    forTerms([&](rateTerm& term) { coupled = term.couple(nSolved) && coupled; });
    if (!coupled)
    {
        forSolids([](solidModel& solids) { solids.setProperties(); });
    }
    return coupled;
}


void Foam::melt::sphEquations::setDensityRate()
{
    bool isSet = false;
    forTerms([&](rateTerm& term) { isSet = term.setDensityRate() || isSet; });
    if (!isSet)
    {
        const effectTimes::part timing(effectTimes::flow, "velocityGradient");
        velocityGradient(system_.near, system_.walls, system_.fluid, false);
    }
    forSolids([](solidModel& solids) { solids.holdDensity(); });
}


void Foam::melt::sphEquations::collide(const scalar deltaT)
{
    if (collision_.valid())
    {
        const effectTimes::part timing("particleCollision", "collision");
        collision_->collide(deltaT);
    }
}


void Foam::melt::sphEquations::divideTimes()
{
    effectTimes::divide
    (
        pairRates::typeName,
        system_.pairs.shares(system_.near, system_.walls, system_.fluid)
    );
}


Foam::scalar Foam::melt::sphEquations::solverIterations() const
{
    scalar iterations = solver_.iterations();
    for (const rateTerm& term : terms_)
    {
        iterations += term.solverIterations();
    }
    return iterations;
}


void Foam::melt::sphEquations::report(Ostream& os) const
{
    for (const rateTerm& term : terms_)
    {
        term.report(os);
    }
    solver_.report(os);
    if (collision_.valid())
    {
        collision_->report(os);
    }
    if (solids_.valid())
    {
        solids_->report(os);
    }
}


const Foam::melt::timeStepControl& Foam::melt::sphEquations::limits()
{
    const particles& f = system_.fluid;

    control_.reset();
    for (const rateTerm& term : terms_)
    {
        term.limit(control_);
    }

    const double maxA2 = parallelMax
    (
        f.size(),
        [&](const int i)
        {
            return f.ax[i]*f.ax[i] + f.ay[i]*f.ay[i] + f.az[i]*f.az[i];
        }
    );
    // Also if it is not a number, for the control to say so
    if (!(maxA2 <= 0))
    {
        control_.limit
        (
            "force",
            std::sqrt(system_.near.kernel().h()/std::sqrt(maxA2))
        );
    }
    return control_;
}

// ************************************************************************* //
