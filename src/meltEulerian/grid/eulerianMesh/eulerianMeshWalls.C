/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMesh.H"
#include "emptyPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::eulerianMesh::setWalls()
{
    forAll(patchFaces_, patchi)
    {
        const wallCondition& w = wall(patchi);
        const auto condition =
            isA<emptyPolyPatch>(mesh_->boundaryMesh()[patchi])
         || w.velocity == wallCondition::velocityType::slip
          ? staggeredGrid::condition::slip
          : w.velocity == wallCondition::velocityType::open
          ? staggeredGrid::condition::open : staggeredGrid::condition::noSlip;
        for (const patchFace& f : patchFaces_[patchi])
        {
            const vector U(w.isWall() ? w.U[f.domainFace] : vector(Zero));
            if (mag(U[f.onGrid.direction]) > SMALL*mag(U))
            {
                FatalErrorInFunction
                    << "Wall " << w.name << " moves along its normal: U is "
                    << U << " m/s at " << f.centre << nl
                    << "Accepted by the method eulerian: 0/U along the wall"
                    << exit(FatalError);
            }
            grid_->setWall
            (
                f.onGrid.direction,
                f.onGrid.face,
                condition,
                {U.x(), U.y(), U.z()}
            );
        }
    }
    grid_->setBlocked(missing());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::eulerianMesh::addPressure
(
    const scalar rho,
    const vector& g,
    faceVelocities& acceleration
) const
{
    forAll(patchFaces_, patchi)
    {
        if (!domain_.pressure().gives(patchi))
        {
            continue;
        }
        const scalarField p_rgh(domain_.pressure().p_rgh(patchi));
        for (const patchFace& f : patchFaces_[patchi])
        {
            const scalar p = p_rgh[f.domainFace] + rho*(g & f.centre);

            // On half a cell of melt
            const label a = f.onGrid.direction;
            acceleration[a][f.onGrid.face] -=
                f.onGrid.sign*2*p/(rho*grid_->d()[a]);
        }
    }
}

// ************************************************************************* //
