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
    forAll(mesh_->boundaryMesh(), patchi)
    {
        const polyPatch& patch = mesh_->boundaryMesh()[patchi];
        const wallCondition& w = wall(patchi);
        const auto condition =
            w.velocity == wallCondition::velocityType::open
          ? staggeredGrid::condition::open
          : w.velocity == wallCondition::velocityType::slip
          ? staggeredGrid::condition::slip : staggeredGrid::condition::noSlip;
        forAll(patch, i)
        {
            const gridFace& g = gridFaces_[patch.start() + i];
            const vector U
            (
                w.isWall() ? w.U[domainFace_[patchi][i]] : vector(Zero)
            );
            if (mag(U[g.direction]) > SMALL*mag(U))
            {
                FatalErrorInFunction
                    << "Wall " << w.name << " moves along its normal: U is "
                    << U << " m/s at " << patch.faceCentres()[i] << nl
                    << "Accepted by the method eulerian: 0/U along the wall"
                    << exit(FatalError);
            }
            grid_->setWall
            (
                g.direction,
                g.face,
                isA<emptyPolyPatch>(patch)
              ? staggeredGrid::condition::slip : condition,
                {U.x(), U.y(), U.z()}
            );
        }
    }
    grid_->setBlocked(missing());
}

// ************************************************************************* //
