/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "schemeCase.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace melt
{
namespace unitTest
{
    defineTypeNameAndDebug(springTerm, 0);
}
    using unitTest::springTerm;
    addToRunTimeSelectionTable(rateTerm, springTerm, dictionary);
}
}


Foam::melt::unitTest::springTerm::springTerm
(
    const dictionary& dict,
    sphSystem& system
)
:
    rateTerm(system),
    omega_(dict.get<scalar>("omega")),
    damping_(dict.get<scalar>("damping"))
{}


void Foam::melt::unitTest::springTerm::addRates()
{
    particles& f = system_.fluid;
    for (int i = 0; i < f.size(); ++i)
    {
        f.ax[i] -= omega_*omega_*f.x[i] + damping_*f.u[i];
        f.ay[i] -= omega_*omega_*f.y[i] + damping_*f.v[i];
        f.az[i] -= omega_*omega_*f.z[i] + damping_*f.w[i];
    }
}



namespace
{

Foam::melt::meltScene* makeScene
(
    Foam::melt::unitTest::sceneCase& files,
    const std::string& effects
)
{
    using Foam::melt::unitTest::sceneCase;

    files.setMaterial
    (
        sceneCase::material()
      + "effects { heatConduction off; generalisedNewtonian off;"
        " artificialViscosity off; XSPH off; " + effects + " }"
    );
    return new Foam::melt::meltScene(files.mesh(), 0.1);
}

} // End anonymous namespace


Foam::melt::unitTest::schemeCase::schemeCase
(
    const particleCloud& cloud,
    const std::string& sphSolution,
    const std::string& effects
)
:
    scene_(makeScene(files_, effects)),
    system
    {
        scene_->thermo(),
        scene_->rheology(),
        {0, 0, 0},
        cloud.points().spacing,
        cloud.near,
        cloud.fluid,
        wallState()
    }
{
    particles& f = system.fluid;
    for
    (
        particles::array* a :
        {
            &f.dH, &f.du, &f.dv, &f.dw,
            &f.axOld, &f.ayOld, &f.azOld, &f.dRhoOld, &f.dHOld,
            &f.kappa, &f.eta,
            &f.S[0], &f.S[1], &f.S[2], &f.S[3], &f.S[4], &f.S[5]
        }
    )
    {
        a->clear();
    }
    for (int i = 0; i < f.size(); ++i)
    {
        f.h[i] = scene_->thermo().enthalpy().h(f.T[i]);
    }

    const dictionary dict
    (
        IStringStream
        (
            "scheme leapFrog; timeStep { acoustic 0.25; force 0.25;"
            " viscous 0.125; thermal 0.1; }" + sphSolution
        )()
    );
    scheme = sphScheme::New(dict, scene_->effects(), system);
    scheme->allocate();
    system.near.build(f, system.walls);
}


void Foam::melt::unitTest::schemeCase::run(const scalar time, const label n)
{
    scheme->start();
    for (label step = 0; step < n; ++step)
    {
        scheme->advance(time/n);
    }
}


int Foam::melt::unitTest::schemeCase::indexOf(const int id) const
{
    const std::vector<int>& ids = system.fluid.id;
    return int(std::find(ids.begin(), ids.end(), id) - ids.begin());
}


std::string Foam::melt::unitTest::springAndDamper
(
    const scalar omega,
    const scalar damping
)
{
    const auto term = [](const scalar w, const scalar c)
    {
        return
            "{ type unitTestSpring; omega " + std::to_string(w)
          + "; damping " + std::to_string(c) + "; }";
    };
    return "pressure " + term(omega, 0) + " viscosity " + term(0, damping);
}


std::string Foam::melt::unitTest::pressureAndViscosity()
{
    return
        "pressure { type linearEquationOfState; speedOfSound 10;"
        " tension yes; } viscosity { type explicitStress; }"
        " heat { type explicitConduction; }"
        " artificialViscosity { type monaghan; alpha 0.5; beta 1; }"
        " XSPH { type monaghanXSPH; epsilon 0.5; }";
}

// ************************************************************************* //
