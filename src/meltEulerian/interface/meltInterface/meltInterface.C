/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltInterface.H"
#include "quietLog.H"
#include "Time.H"
#include "vector2D.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

// Cells that are full or empty to this are not nudged, others by so much to
// twice as much [-]
const scalar surface = 1e-6, nudge = 1e-12;


//- Conditions of the patches: closed for a wall, else what an open one has
wordList conditions
(
    const eulerianMesh& mesh,
    const word& onWalls,
    const word& onOpen
)
{
    const polyBoundaryMesh& patches = mesh.mesh().boundaryMesh();
    wordList types(patches.size());
    forAll(patches, patchi)
    {
        types[patchi] =
            polyPatch::constraintType(patches[patchi].type())
          ? patches[patchi].type()
          : mesh.wall(patchi).isWall() ? onWalls : onOpen;
    }
    return types;
}


//- isoAdvection's step is that of Time
class subStep
{
    Time& time_;

    const scalar deltaT_;

public:

    subStep(const Time& time, const scalar deltaT)
    :
        time_(const_cast<Time&>(time)),
        deltaT_(time.deltaTValue())
    {
        time_.setDeltaT(deltaT, false);
    }

    ~subStep()
    {
        time_.setDeltaT(deltaT_, false);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::meltInterface::setVelocities(const faceVelocities& U)
{
    const fvMesh& mesh = mesh_.mesh();
    const auto flux = [&](const label facei)
    {
        const eulerianMesh::gridFace& g = mesh_.onGrid(facei);
        return
            g.sign*U[g.direction][g.face]
           *mesh_.grid().volume()/mesh_.grid().d()[g.direction];
    };
    forAll(phi_, facei)
    {
        phi_[facei] = flux(facei);
    }
    forAll(phi_.boundaryField(), patchi)
    {
        fvsPatchScalarField& phi = phi_.boundaryFieldRef()[patchi];
        forAll(phi, i)
        {
            phi[i] = flux(mesh.boundaryMesh()[patchi].start() + i);
        }
    }
    setCellVelocities(U);
}


Foam::scalarField Foam::melt::meltInterface::nudges() const
{
    const scalar golden = 0.5*(sqrt(scalar(5)) - 1);
    scalarField result(alpha_.size(), 0);
    forAll(result, celli)
    {
        if (alpha_[celli] > surface && alpha_[celli] < 1 - surface)
        {
            const scalar number = golden*mesh_.gridCell(celli);
            result[celli] = nudge*(1 + number - std::floor(number));
        }
    }
    return result;
}


void Foam::melt::meltInterface::moveEnthalpy
(
    const scalar deltaT,
    scalarField& alphaH
)
{
    const fvMesh& mesh = mesh_.mesh();
    const tmp<surfaceScalarField> volume
    (
        advection_.getRhoPhi
        (
            dimensionedScalar("rho", dimDensity, 1),
            dimensionedScalar("rho", dimDensity, 0)
        )
    );

    // What goes through a face from its owner
    const auto forAllFluxes =
        [&](const surfaceScalarField& flux, const auto& action)
    {
        forAll(mesh.neighbour(), facei)
        {
            action(facei, flux[facei]*deltaT);
        }
        for (const fvsPatchScalarField& patch : flux.boundaryField())
        {
            forAll(patch, i)
            {
                action(patch.patch().start() + i, patch[i]*deltaT);
            }
        }
    };
    const label firstBetween = mesh_.firstBetween();
    const auto leaves = [&](const label facei)
    {
        return !mesh.isInternalFace(facei) && facei < firstBetween;
    };

    // alpha is already that of the end
    vector2D lost(Zero);
    const scalarField& V = mesh.V();
    scalarField alphaStart(alpha_.primitiveField());
    forAllFluxes(volume(), [&](const label facei, const scalar dV)
    {
        alphaStart[mesh.faceOwner()[facei]] += dV/V[mesh.faceOwner()[facei]];
        if (mesh.isInternalFace(facei))
        {
            const label nei = mesh.neighbour()[facei];
            alphaStart[nei] -= dV/V[nei];
        }
        lost.x() += leaves(facei) ? dV : 0;
    });

    scalarField h(alphaH);
    forAll(h, celli)
    {
        h[celli] = alphaStart[celli] > VSMALL ? h[celli]/alphaStart[celli] : 0;
    }
    const tmp<surfaceScalarField> enthalpy
    (
        volume()*carried_.at(alphaStart, h, volume(), deltaT)
    );
    forAllFluxes(enthalpy(), [&](const label facei, const scalar dH)
    {
        const label own = mesh.faceOwner()[facei];
        alphaH[own] -= dH/V[own];
        if (mesh.isInternalFace(facei))
        {
            const label nei = mesh.neighbour()[facei];
            alphaH[nei] += dH/V[nei];
        }
        lost.y() += leaves(facei) ? dH : 0;
    });
    reduce(lost, sumOp<vector2D>());
    lostVolume_ += lost.x();
    lostEnthalpy_ += lost.y();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::meltInterface::meltInterface(eulerianMesh& mesh)
:
    mesh_(mesh),
    alpha_
    (
        IOobject
        (
            "alpha.melt",
            mesh.mesh().time().timeName(),
            mesh.mesh(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh.mesh(),
        dimensionedScalar(dimless, Zero),
        conditions(mesh, "zeroGradient", "inletOutlet")
    ),
    phi_
    (
        IOobject("phi", mesh.mesh().time().timeName(), mesh.mesh()),
        mesh.mesh(),
        dimensionedScalar(dimVolume/dimTime, Zero)
    ),
    U_
    (
        IOobject
        (
            "U",
            mesh.mesh().time().timeName(),
            mesh.mesh(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh.mesh(),
        dimensionedVector(dimVelocity, Zero),
        conditions(mesh, "fixedValue", "zeroGradient")
    ),
    advection_(alpha_, phi_, U_),
    carried_(mesh)
{
    forAll(U_.boundaryField(), patchi)
    {
        const wallCondition& w = mesh_.wall(patchi);
        fvPatchVectorField& U = U_.boundaryFieldRef()[patchi];
        if (w.isWall() && U.fixesValue())
        {
            forAll(U, i)
            {
                U[i] = w.U[mesh_.domainFace(patchi, i)];
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::meltInterface::Courant
(
    const faceVelocities& U,
    const scalar deltaT
) const
{
    const fvMesh& mesh = mesh_.mesh();
    const auto wet = [&](const label facei)
    {
        return
            alpha_[mesh.faceOwner()[facei]] > 0
         || (mesh.isInternalFace(facei) && alpha_[mesh.neighbour()[facei]] > 0);
    };
    scalar greatest = 0;
    mesh_.forAllInner([&](const label facei)
    {
        if (wet(facei))
        {
            const eulerianMesh::gridFace& g = mesh_.onGrid(facei);
            greatest = max
            (
                greatest,
                mag(U[g.direction][g.face])/mesh_.grid().d()[g.direction]
            );
        }
    });
    reduce(greatest, maxOp<scalar>());
    return greatest*deltaT;
}


Foam::label Foam::melt::meltInterface::advance
(
    const faceVelocities& U,
    const scalar deltaT,
    const scalar maxCourant,
    scalarField& alphaH
)
{
    setVelocities(U);
    const label n =
        max(label(1), label(std::ceil(Courant(U, deltaT)/maxCourant)));
    const subStep step(mesh_.mesh().time(), deltaT/n);
    const quietLog quiet;
    for (label i = 0; i < n; ++i)
    {
        const scalarField added(nudges());
        alpha_.primitiveFieldRef() += added;
        advection_.advect();
        alpha_.primitiveFieldRef() -= added;
        moveEnthalpy(deltaT/n, alphaH);
        bound(alphaH);
    }
    return n;
}


void Foam::melt::meltInterface::setCellVelocities(const faceVelocities& U)
{
    const staggeredGrid& grid = mesh_.grid();
    forAll(U_, celli)
    {
        const staggeredGrid::triple c(grid.position(mesh_.gridCell(celli)));
        for (direction a = 0; a < 3; ++a)
        {
            staggeredGrid::triple next(c);
            ++next[a];
            U_[celli][a] =
                grid.solved(a)
              ? 0.5*(U[a][grid.face(a, c)] + U[a][grid.face(a, next)]) : 0;
        }
    }
    U_.correctBoundaryConditions();
}

// ************************************************************************* //
