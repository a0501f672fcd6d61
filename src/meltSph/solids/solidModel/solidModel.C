/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidModel.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "solidGroups.H"

#include <map>

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(solidModel, 0);
    defineRunTimeSelectionTable(solidModel, dictionary);
}
}


Foam::autoPtr<Foam::melt::solidModel> Foam::melt::solidModel::New
(
    const dictionary& dict,
    sphSystem& system
)
{
    const word type(dict.get<word>("type"));
    if (type == "viscous")
    {
        return autoPtr<solidModel>();
    }

    const auto constructor = dictionaryConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        wordList valid(dictionaryConstructorTablePtr_->sortedToc());
        valid.append("viscous");
        FatalIOErrorInFunction(dict)
            << "Unknown type " << type << " of solids" << nl
            << "Valid types: " << valid << exit(FatalIOError);
    }
    return autoPtr<solidModel>(constructor()(dict, system));
}


Foam::melt::solidModel::solidModel(const dictionary& dict, sphSystem& system)
:
    bondingDistance_
    (
        checkedEntry::getOrDefault
        (
            dict, "bondingDistance", dimless, scalarMinMax(1, 2), 1.5
        )
       *system.spacing
    ),
    contactError_
    (
        checkedEntry::getOrDefault
        (
            dict, "contactError", dimless, checkedEntry::notNegative(), 1e-3
        )
       *system.spacing
    ),
    system_(system)
{}


void Foam::melt::solidModel::allocate()
{
    particles& f = system_.fluid;
    f.body.resize(f.size(), -1);
}


void Foam::melt::solidModel::setBodies()
{
    const particles& f = system_.fluid;
    const int n = f.size();

    bodies_.clear();
    bodyOf_.assign(n, -1);
    system_.solid.assign(n, 0);
    std::map<int, int> indexOf;
    for (int i = 0; i < n; ++i)
    {
        if (f.body[i] < 0)
        {
            continue;
        }
        const auto [place, isNew] =
            indexOf.insert({f.body[i], int(bodies_.size())});
        if (isNew)
        {
            bodies_.emplace_back();
        }
        bodyOf_[i] = place->second;
        system_.solid[i] = 1;
        bodies_[place->second].members.push_back(i);
    }
    for (solidBody& body : bodies_)
    {
        body.setGeometry(f);
        body.fixed = fixed(body);
    }
}


void Foam::melt::solidModel::update()
{
    neighbourhood& near = system_.near;
    const bool changed =
        groupSolids(near, bondingDistance_, system_.fluid);
    setBodies();
    if (changed || near.nBuilds() != nBuilds_)
    {
        near.setSolids(system_.fluid.body);
        nBuilds_ = near.nBuilds();
    }
    // Else rigid already: once more would add round-off, and a restart with it
    if (changed)
    {
        projectVelocities();
    }
}


void Foam::melt::solidModel::collide(const scalar deltaT)
{
    particles& f = system_.fluid;
    for (solidBody& body : bodies_)
    {
        body.setMotion(f, f.u, f.v, f.w);
    }
    touch(deltaT);
    for (const solidBody& body : bodies_)
    {
        body.setVelocities(f, f.u, f.v, f.w);
    }
}


bool Foam::melt::solidModel::hold
(
    const vectorArray& before,
    const vectorArray& now,
    const scalar deltaT
)
{
    bool any = false;
    for (solidBody& body : bodies_)
    {
        body.held = false;
        for (const int i : body.members)
        {
            const vector change
            (
                now.x[i] - before.x[i],
                now.y[i] - before.y[i],
                now.z[i] - before.z[i]
            );
            body.held = body.held || deltaT*mag(change) > contactError_;
        }
        any = any || body.held;
    }
    return any;
}


void Foam::melt::solidModel::release()
{
    for (solidBody& body : bodies_)
    {
        body.held = false;
    }
}


void Foam::melt::solidModel::move(const scalar deltaT)
{
    // Particles may have been sorted since the last time
    setBodies();

    particles& f = system_.fluid;
    for (solidBody& body : bodies_)
    {
        if (!body.fixed)
        {
            body.setMotion(f, f.u, f.v, f.w);
            body.move(f, deltaT);
            body.setVelocities(f, f.u, f.v, f.w);
        }
    }
}


void Foam::melt::solidModel::project(vectorArray& force) const
{
    const particles& f = system_.fluid;
    for (const solidBody& body : bodies_)
    {
        vector sum(Zero), torque(Zero);
        for (const int i : body.members)
        {
            const vector each(force.x[i], force.y[i], force.z[i]);
            sum += each;
            torque += body.arm(f, i) ^ each;
        }
        const vector A(sum/body.mass);
        const vector alpha(body.inverseInertia & torque);
        for (const int i : body.members)
        {
            const vector each
            (
                body.fixed || body.held
              ? vector(Zero)
              : vector(f.m[i]*(A + (alpha ^ body.arm(f, i))))
            );
            force.x[i] = each.x();
            force.y[i] = each.y();
            force.z[i] = each.z();
        }
    }
}


void Foam::melt::solidModel::projectVelocities()
{
    particles& f = system_.fluid;
    for (solidBody& body : bodies_)
    {
        body.setMotion(f, f.u, f.v, f.w);
        body.setVelocities(f, f.u, f.v, f.w);
    }
}


void Foam::melt::solidModel::setProperties()
{
    particles& f = system_.fluid;
    for (const solidBody& body : bodies_)
    {
        for (const int i : body.members)
        {
            f.p[i] = 0;
            if (!f.eta.empty())
            {
                f.eta[i] = VSMALL;
            }
            if (!f.shearRate.empty())
            {
                f.shearRate[i] = 0;
            }
        }
    }
}


void Foam::melt::solidModel::projectRates()
{
    particles& f = system_.fluid;
    for (solidBody& body : bodies_)
    {
        body.setMotion(f, f.ax, f.ay, f.az);
        body.setVelocities(f, f.ax, f.ay, f.az);
        for (const int i : body.members)
        {
            if (!f.du.empty())
            {
                f.du[i] = f.dv[i] = f.dw[i] = 0;
            }
        }
        body.setMotion(f, f.u, f.v, f.w);
    }
    holdDensity();
}


void Foam::melt::solidModel::holdDensity()
{
    for (const solidBody& body : bodies_)
    {
        for (const int i : body.members)
        {
            system_.fluid.dRho[i] = 0;
        }
    }
}


void Foam::melt::solidModel::report(Ostream& os) const
{
    label nParticles = 0, nFixed = 0;
    for (const solidBody& body : bodies_)
    {
        nParticles += label(body.members.size());
        nFixed += body.fixed;
    }
    os  << "     solids: " << nParticles << " particles in "
        << label(bodies_.size()) << " pieces, " << nFixed << " of them fixed"
        << nl;
}

// ************************************************************************* //
