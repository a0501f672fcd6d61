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

    wallGradient_.reset(system_.near);
    wallVelocityGradient_.reset(system_.near);
    const std::vector<int>& beside = system_.near.besideWalls();
    system_.near.visit([&](const auto& W, const auto& space)
    {
        #pragma omp parallel for schedule(dynamic, 64)
        for (int k = 0; k < int(beside.size()); ++k)
        {
            const int i = beside[k];
            vector b(Zero);
            tensor g(Zero);
            const auto row = system_.near.walls().sourcesOf(i);
            for (int n = 0; n < row.size(); ++n)
            {
                const int j = row[n];
                double dx = f.x[i] - walls.x[j];
                double dy = f.y[i] - walls.y[j];
                double dz = f.z[i] - walls.z[j];
                space.nearestImage(dx, dy, dz);
                const double c =
                    walls.volume[j]*wallDrag::factor(system_, i, j)
                   *W.gradientOverR(dx*dx + dy*dy + dz*dz);
                const vector u(walls.wallU[j], walls.wallV[j], walls.wallW[j]);
                const vector gradient(c*dx, c*dy, c*dz);
                b += gradient;
                g += u*gradient;
            }
            wallGradient_.ofWallIndex(k) = b;
            wallVelocityGradient_.ofWallIndex(k) = g;
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
            system_, eta_, L_, wallGradient_, wallVelocityGradient_, sources,
            v, SL_
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
    if (centralShare_ > 0)
    {
        central_.addDiagonal(diagonal);
    }
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
    return
        central_.bytes() + wallGradient_.bytes() + wallVelocityGradient_.bytes()
      + SL_[0].bytes() + SL_[1].bytes() + SL_[2].bytes()
      + sizeof(double)*(6*L_[0].capacity() + eta_.capacity());
}

// ************************************************************************* //
