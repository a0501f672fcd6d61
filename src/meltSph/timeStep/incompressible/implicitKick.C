/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "implicitKick.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::implicitKick::setContact(const scalar dt)
{
    particles& f = system_.fluid;

    // As if forces were those of the step before
    contact_.assign(f.axOld, f.ayOld, f.azOld);
    contact_.scaleAndAdd(dt, before_);
    f.u = contact_.x;
    f.v = contact_.y;
    f.w = contact_.z;
    equations_.collideSolids(dt);

    const double theta = system_.implicitness;
    const int n = f.size();
    #pragma omp parallel for simd schedule(static)
    for (int i = 0; i < n; ++i)
    {
        contact_.x[i] = theta*(f.u[i] - contact_.x[i]);
        contact_.y[i] = theta*(f.v[i] - contact_.y[i]);
        contact_.z[i] = theta*(f.w[i] - contact_.z[i]);
    }
    f.u = before_.x;
    f.v = before_.y;
    f.w = before_.z;
}


Foam::vector Foam::melt::implicitKick::lead(const int i) const
{
    const particles& f = system_.fluid;
    vector lead(f.axOld[i], f.ayOld[i], f.azOld[i]);
    lead *= lead_*rhoBefore_[i]/f.rho[i];
    if (contact_.size())
    {
        lead +=
            contactLead_*vector(contact_.x[i], contact_.y[i], contact_.z[i]);
    }
    return lead;
}


Foam::vector Foam::melt::implicitKick::unforced(const int i) const
{
    vector v(before_.x[i], before_.y[i], before_.z[i]);
    if (contact_.size())
    {
        v += vector(contact_.x[i], contact_.y[i], contact_.z[i]);
    }
    return v - lead(i);
}


void Foam::melt::implicitKick::setLead(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const double theta = system_.implicitness;

    // As long as no velocity has a weight below zero
    lead_ = std::min((theta - 0.5)*dt, (1 - theta)*system_.stepBefore);
    contactLead_ = lead_/(theta*dt);
    if (lead_ == 0)
    {
        return;
    }

    // Pressure is that of the velocities at the end: what is solved for, plus
    // the lead, less the share of those at the start
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const vector ahead(lead(i)/(1 - theta));
        f.u[i] -= ahead.x();
        f.v[i] -= ahead.y();
        f.w[i] -= ahead.z();
    }
    equations_.setDensityRate();
}


void Foam::melt::implicitKick::predict
(
    const scalar share,
    const std::vector<double>& ax,
    const std::vector<double>& ay,
    const std::vector<double>& az,
    std::vector<double>& u,
    std::vector<double>& v,
    std::vector<double>& w
) const
{
    const int n = system_.fluid.size();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const vector start(unforced(i));
        u[i] = start.x() + share*ax[i];
        v[i] = start.y() + share*ay[i];
        w[i] = start.z() + share*az[i];
    }
}


void Foam::melt::implicitKick::setPredicted(const scalar share)
{
    particles& f = system_.fluid;
    predict(share, f.ax, f.ay, f.az, f.u, f.v, f.w);
}


void Foam::melt::implicitKick::setVelocities(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const double share = system_.implicitness*dt;

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        const vector v(unforced(i));
        f.ax[i] = (f.u[i] - v.x())/share;
        f.ay[i] = (f.v[i] - v.y())/share;
        f.az[i] = (f.w[i] - v.z())/share;
        f.u[i] = before_.x[i] + dt*f.ax[i];
        f.v[i] = before_.y[i] + dt*f.ay[i];
        f.w[i] = before_.z[i] + dt*f.az[i];
    }
    equations_.collideSolids(dt);
}


bool Foam::melt::implicitKick::endWithSolids(const scalar dt)
{
    particles& f = system_.fluid;
    const int n = f.size();
    const double theta = system_.implicitness;
    const double share = theta*dt;

    vectorArray solved, predicted, mean;
    solved.assign(f.u, f.v, f.w);
    setPredicted(share);
    predicted.assign(f.u, f.v, f.w);
    f.u = solved.x;
    f.v = solved.y;
    f.w = solved.z;

    setVelocities(dt);
    mean.assign(f.u, f.v, f.w);
    mean.add(-1, before_);
    mean.scaleAndAdd(theta, before_);
    for (int i = 0; i < n; ++i)
    {
        const vector ahead(lead(i));
        mean.x[i] -= ahead.x();
        mean.y[i] -= ahead.y();
        mean.z[i] -= ahead.z();
    }
    if (!equations_.holdSolids(solved, mean, dt/theta))
    {
        return true;
    }

    // Velocities before the implicit forces, or what these make of them
    const auto addForces = [&](const double sources, const bool held)
    {
        vectorArray force(n);
        equations_.addImplicitForces(mean, sources, force);
        for (int i = 0; i < n; ++i)
        {
            if (equations_.held(i) == held)
            {
                f.u[i] = predicted.x[i] + share*force.x[i]/f.m[i];
                f.v[i] = predicted.y[i] + share*force.y[i]/f.m[i];
                f.w[i] = predicted.z[i] + share*force.z[i]/f.m[i];
            }
        }
    };

    // To the others those that are held are walls that move. The solver has
    // them at rest
    for (int i = 0; i < n; ++i)
    {
        if (!equations_.held(i))
        {
            mean.x[i] = mean.y[i] = mean.z[i] = 0;
        }
    }
    addForces(0, false);
    equations_.guess() = solved;
    if (!equations_.implicitUpdate(share))
    {
        equations_.releaseSolids();
        return false;
    }

    // They take up the forces of that liquid, and contact anew
    for (int i = 0; i < n; ++i)
    {
        if (!equations_.held(i))
        {
            mean.x[i] = f.u[i];
            mean.y[i] = f.v[i];
            mean.z[i] = f.w[i];
        }
    }
    addForces(1, true);
    equations_.releaseSolids();
    setVelocities(dt);
    return true;
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::melt::implicitKick::begin()
{
    const particles& f = system_.fluid;
    before_.assign(f.u, f.v, f.w);
    rhoBefore_ = f.rho;
}


void Foam::melt::implicitKick::takeBack()
{
    particles& f = system_.fluid;
    f.u = before_.x;
    f.v = before_.y;
    f.w = before_.z;
    f.rho = rhoBefore_;
}


bool Foam::melt::implicitKick::solve(const scalar dt)
{
    const particles& f = system_.fluid;
    const bool solids = equations_.solids();
    if (solids)
    {
        setContact(dt);
    }
    setLead(dt);

    // Solved for the mean velocity less its lead, over the implicit share of the
    // step. The first guess goes on as the step before did
    const double share = system_.implicitness*dt;
    vectorArray& guess = equations_.guess();
    guess.resize(f.size());
    predict(share, f.axOld, f.ayOld, f.azOld, guess.x, guess.y, guess.z);
    for (label nSolved = 1; ; ++nSolved)
    {
        setPredicted(share);
        if (!equations_.implicitUpdate(share))
        {
            return false;
        }
        if (equations_.couple(nSolved))
        {
            break;
        }
    }

    if (solids)
    {
        return endWithSolids(dt);
    }
    setVelocities(dt);
    return true;
}

// ************************************************************************* //
