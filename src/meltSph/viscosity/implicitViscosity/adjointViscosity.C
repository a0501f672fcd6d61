/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "adjointViscosity.H"
#include "addToRunTimeSelectionTable.H"
#include "adjointBlockLaw.H"
#include "adjointLaws.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "harmonicViscosity.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(adjointViscosity, 0);
    addToRunTimeSelectionTable(viscousOperator, adjointViscosity, dictionary);
}
}


Foam::melt::adjointViscosity::adjointViscosity
(
    const dictionary& dict,
    const sphSystem& system
)
:
    viscousOperator(system),
    centralShare_
    (
        checkedEntry::get(dict, "centralShare", dimless, scalarMinMax(0, 1))
    ),
    maxCondition_
    (
        checkedEntry::get
        (
            dict, "maxCondition", dimless, checkedEntry::positive()
        )
    ),
    central_(system, centralShare_)
{}


void Foam::melt::adjointViscosity::update(const double deltaT)
{
    const particles& f = system_.fluid;
    const wallState& walls = system_.walls;
    const int n = f.size();

    central_.update(deltaT);
    gradientCorrection(system_, maxCondition_, L_);
    harmonicViscosity(system_, eta_);
    for (double& eta : eta_)
    {
        eta *= 1 - centralShare_;
    }

    for (vectorArray& row : SL_)
    {
        row.resize(n);
    }

    const bool anyWalls = !system_.near.walls().empty();
    const auto moves = [](const double u) { return u != 0; };
    movingWalls_ =
        anyWalls
     && (
            std::any_of(walls.wallU.begin(), walls.wallU.end(), moves)
         || std::any_of(walls.wallV.begin(), walls.wallV.end(), moves)
         || std::any_of(walls.wallW.begin(), walls.wallW.end(), moves)
        );
    wallGradient_.resize(anyWalls ? n : 0);
    for (vectorArray& row : wallVelocityGradient_)
    {
        row.resize(movingWalls_ ? n : 0);
    }

    system_.near.visit([&](const auto& W, const auto& space)
    {
        #pragma omp parallel for schedule(dynamic, 256)
        for (int i = 0; i < wallGradient_.size(); ++i)
        {
            double bx = 0, by = 0, bz = 0;
            double g[3][3] = {};
            const auto row = system_.near.walls().sourcesOf(i);
            for (int k = 0; k < row.size(); ++k)
            {
                const int j = row[k];
                double dx = f.x[i] - walls.x[j];
                double dy = f.y[i] - walls.y[j];
                double dz = f.z[i] - walls.z[j];
                space.nearestImage(dx, dy, dz);
                const double c =
                    walls.volume[j]*wallDrag::factor(system_, i, j)
                   *W.gradientOverR(dx*dx + dy*dy + dz*dz);
                bx += c*dx;
                by += c*dy;
                bz += c*dz;

                const double u[3] =
                    {walls.wallU[j], walls.wallV[j], walls.wallW[j]};
                for (int a = 0; a < 3; ++a)
                {
                    g[a][0] += c*u[a]*dx;
                    g[a][1] += c*u[a]*dy;
                    g[a][2] += c*u[a]*dz;
                }
            }
            wallGradient_.x[i] = bx;
            wallGradient_.y[i] = by;
            wallGradient_.z[i] = bz;
            for (int a = 0; movingWalls_ && a < 3; ++a)
            {
                wallVelocityGradient_[a].x[i] = g[a][0];
                wallVelocityGradient_[a].y[i] = g[a][1];
                wallVelocityGradient_[a].z[i] = g[a][2];
            }
        }
    });
}


void Foam::melt::adjointViscosity::addForce
(
    const vectorArray& v,
    const double sources,
    vectorArray& force
)
{
    forcePass
    (
        system_.near, system_.walls, system_.fluid,
        stressOfVelocityLaw
        (
            system_, eta_, L_, wallGradient_,
            wallVelocityGradient_, movingWalls_ ? sources : 0, v, SL_
        )
    );
    forcePass
    (
        system_.near, system_.walls, system_.fluid,
        adjointForceLaw(system_, SL_, wallGradient_, force)
    );

    if (centralShare_ > 0)
    {
        central_.addForce(v, sources, force);
    }
}


void Foam::melt::adjointViscosity::addDiagonal(blocks& diagonal) const
{
    central_.addDiagonal(diagonal);
    pairPass
    (
        system_.near, system_.walls, system_.fluid,
        adjointBlockLaw(system_, eta_, L_, wallGradient_, diagonal)
    );
}


bool Foam::melt::adjointViscosity::describe(implicitParts& p) const
{
    p.L = &L_;
    p.eta = &eta_;
    p.viscousWall = &wallGradient_;
    return central_.describe(p);
}


std::size_t Foam::melt::adjointViscosity::bytes() const
{
    std::size_t n =
        central_.bytes() + wallGradient_.bytes()
      + sizeof(double)*(6*L_[0].capacity() + eta_.capacity());
    for (int a = 0; a < 3; ++a)
    {
        n += SL_[a].bytes() + wallVelocityGradient_[a].bytes();
    }
    return n;
}

// ************************************************************************* //
