/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidSolids.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(rigidSolids, 0);
    addToRunTimeSelectionTable(solidModel, rigidSolids, dictionary);
}
}


Foam::melt::rigidSolids::rigidSolids
(
    const dictionary& dict,
    sphSystem& system
)
:
    solidModel(dict, system),
    sticking_(dict.getOrDefault<bool>("sticking", false)),
    contact_
    (
        system,
        checkedEntry::getOrDefault
        (
            dict, "friction", dimless, checkedEntry::notNegative(), 0.5
        ),
        dict.getCheckOrDefault<label>
        (
            "contactSweeps", 100, labelMinMax::ge(1)
        )
    )
{}


void Foam::melt::rigidSolids::allocate()
{
    solidModel::allocate();
    if (sticking_)
    {
        particles& f = system_.fluid;
        f.anchored.resize(f.size(), -1);
    }
}


void Foam::melt::rigidSolids::anchor()
{
    particles& f = system_.fluid;
    const wallState& walls = system_.walls;
    const scalar reach = 0.75*system_.spacing;

    for (int i = 0; i < int(f.anchored.size()); ++i)
    {
        int& anchored = f.anchored[i];
        if (f.h[i] > 0)
        {
            anchored = 0;
        }
        if (anchored >= 0)
        {
            continue;
        }

        anchored = 0;
        const auto row = system_.near.walls().sourcesOf(i);
        for (int k = 0; k < row.size(); ++k)
        {
            const int j = row[k];
            const scalar distance =
                walls.nx[j]*f.x[i] + walls.ny[j]*f.y[i] + walls.nz[j]*f.z[i]
              - walls.offset[j];
            if (!walls.slip[j] && distance < reach)
            {
                anchored = 1;
            }
        }
    }
}


void Foam::melt::rigidSolids::update()
{
    anchor();
    solidModel::update();
}


bool Foam::melt::rigidSolids::fixed(const solidBody& body) const
{
    const std::vector<int>& anchored = system_.fluid.anchored;
    for (const int i : body.members)
    {
        if (!anchored.empty() && anchored[i])
        {
            return true;
        }
    }
    return false;
}


void Foam::melt::rigidSolids::touch(const scalar deltaT)
{
    contact_.push(bodies_, bodyOf_, deltaT);
}

// ************************************************************************* //
