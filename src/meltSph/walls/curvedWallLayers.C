/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "curvedWallLayer.H"
#include "wallLayers.H"
#include "symmTensor.H"
#include "tensor.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

namespace
{
    // Squarings of a matrix that leave its largest eigenvector alone
    constexpr int nSquarings = 10;


    // Direction in which the normals of the group vary least: the eigenvector
    // of the least eigenvalue of sum(n n). OpenFOAM's eigenVectors fail where
    // eigenvalues are equal, as those of a sphere
    vector axisOf(const wallSurface& surface, const wallSurface::group& g)
    {
        symmTensor normals(Zero);

        for (const label facei : g.faces)
        {
            const vector& area =
                surface.mesh().faceAreas()[surface.meshFace(facei)];
            normals += sqr(area)/max(mag(area), VSMALL);
        }

        tensor power(tr(normals)*symmTensor::I - normals);
        for (int i = 0; i < nSquarings; ++i)
        {
            power = (power & power)/magSqr(power);
        }

        vector axis(power.x());
        for (const vector& row : {power.y(), power.z()})
        {
            axis = magSqr(row) > magSqr(axis) ? row : axis;
        }

        return normalised(axis);
    }
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::addCurvedWallLayers
(
    wallParticleBuilder& builder,
    const label groupi
)
{
    const wallSurface& surface = builder.surface();
    const wallSurface::group& g = surface.groups()[groupi];
    const vector axis(axisOf(surface, g));

    scalar low = GREAT;
    scalar high = -GREAT;
    for (const label facei : g.faces)
    {
        for (const label pointi : surface.patch()[facei])
        {
            const scalar position = surface.patch().points()[pointi] & axis;
            low = min(low, position);
            high = max(high, position);
        }
    }

    const scalar step = (high - low)/builder.nFitting(high - low);

    for (label layer = 0; layer < builder.nLayers(); ++layer)
    {
        curvedWallLayer(builder, groupi, layer, axis, low, step).fill();
    }
}


// ************************************************************************* //
