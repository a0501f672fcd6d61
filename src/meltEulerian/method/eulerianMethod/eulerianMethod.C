/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"
#include "addToRunTimeSelectionTable.H"
#include "domainFields.H"
#include "eulerianFill.H"
#include "surfaceTension.H"

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(eulerianMethod, 0);
    addToRunTimeSelectionTable(meltMethod, eulerianMethod, scene);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::eulerianMethod::eulerianMethod
(
    fvMesh& mesh,
    const meltScene& scene
)
:
    meltMethod(mesh, scene),
    dict_(scene.numerics("eulerianSolution", IOobject::READ_IF_PRESENT)),
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
    vents_(region_, scene.thermo(), scene.g(), scene.dict()),
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
    solid_(dict_.subOrEmptyDict("solid")),
    buoyancy_
    (
        dict_.subOrEmptyDict("buoyancy"), scene.effects()("buoyancy")
    ),
    surfaceTension_
    (
        scene.effects()("surfaceTension") ? scene.thermo().surfaceTension() : 0
    ),
    timeStep_
    (
        dict_.subOrEmptyDict("timeStep"),
        leastEdge(),
        mag(scene.g()),
        surfaceTension_ > 0
      ? surfaceTension::capillaryTime
        (
            region_.grid(), surfaceTension_, scene.thermo().rho()
        )
      : GREAT
    )
{
    scene.periods().refuse(typeName);

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
    solid_.block
    (
        interface_.alpha(), liquidFraction()(), flow_.wetFrom(), region_
    );
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

    const domainFields onDomain(mesh_, region_);
    onDomain.write("T", energy_.T().primitiveField());
    onDomain.write("U", interface_.U().primitiveField());
    onDomain.write("p_rgh", p_rgh_.primitiveField());
    writeState();
}


Foam::label Foam::melt::eulerianMethod::nParticles() const
{
    label n = 0;
    for (const scalar alpha : interface_.alpha().primitiveField())
    {
        n += alpha > 0;
    }
    return returnReduce(n, sumOp<label>());
}


Foam::scalar Foam::melt::eulerianMethod::particleSteps() const
{
    return cellSteps_;
}

// ************************************************************************* //
