/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphMethod.H"
#include "apparentViscosity.H"
#include "divergence.H"
#include "fvMesh.H"
#include "shape.H"
#include "Time.H"
#include "wallParticleGenerator.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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

    const auto isAdiabatic = [&](const label patchi)
    {
        return
            conditions[patchi].thermal
         == wallCondition::thermalType::adiabatic;
    };

    const label n = label(walls.size());
    for (label i = 0; i < n; ++i)
    {
        const wallCondition& condition = conditions[walls.patch[i]];
        const label facei = walls.face[i];
        const vector& U = condition.U[facei];
        // Heat passes a wall where there is melt before it: behind an edge with
        // an adiabatic wall there is none
        bool adiabatic = isAdiabatic(walls.patch[i]);
        for (const int other : walls.otherPatches[i])
        {
            adiabatic |= other >= 0 && isAdiabatic(other);
        }
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
        cloud_.addVector
        (
            system_.pairs.xsph ? "UXSPH" : "UShift", f.du, f.dv, f.dw, false
        );
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
    int escaped = -1;
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
            escaped = i;
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
                "a particle has left the domain, which has no open patch",
                escaped
            );
        }
        f.permute(staying);
        system_.near.build(f, system_.walls);
    }
}

// ************************************************************************* //
