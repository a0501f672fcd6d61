/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleSurface.H"
#include "characteristicSurface.H"
#include "voxelDensity.H"
#include "DynamicList.H"
#include "triFace.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- OpenFOAM's points and vectors are rows of three scalars
const scalar* data(const UList<vector>& list)
{
    return reinterpret_cast<const scalar*>(list.cdata());
}


vectorField toVectorField(const std::vector<double>& values)
{
    vectorField result(values.size()/3);
    forAll(result, i)
    {
        result[i] = vector(values[3*i], values[3*i + 1], values[3*i + 2]);
    }
    return result;
}


scalar readRadius(const dictionary& dict)
{
    return dict.getCheckOrDefault<scalar>
    (
        "radius", 2, [](const scalar r) { return r >= 1; }
    );
}


scalar readShading(const dictionary& dict)
{
    return dict.getCheckOrDefault<scalar>
    (
        "shading", 4, [](const scalar r) { return r >= 1; }
    );
}


scalar readVoxel(const dictionary& dict)
{
    return dict.getCheckOrDefault<scalar>
    (
        "voxel", 0.5, [](const scalar v) { return v > 0 && v <= 1; }
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::particleSurface::particleSurface
(
    const dictionary& dict,
    const pointField& positions,
    const scalarField& volumes
)
:
    spacing_(volumes.empty() ? 1 : Foam::cbrt(average(volumes))),
    radius_(readRadius(dict)*spacing_),
    cloud_(positions.size(), data(positions), volumes.cdata(), radius_),
    shading_
    (
        positions.size(),
        data(positions),
        volumes.cdata(),
        readShading(dict)*spacing_
    ),
    mesh_
    (
        characteristicSurface
        (
            positions.size(),
            data(positions),
            volumes.cdata(),
            radius_,
            readVoxel(dict)*spacing_,
            level(dict)
        )
    )
{
    const scalar level = particleSurface::level(dict);
    const auto chi = cloud_.chi(positions.size(), data(positions));
    scalarField enclosed(positions.size());
    forAll(positions, i)
    {
        enclosed[i] = chi[i] < level ? 0 : 1;
    }

    // A particle beside enclosed ones belongs to the surface, even if it
    // stands out a little
    const kernelCloud beside
    (
        positions.size(), data(positions), volumes.cdata(), 2*spacing_
    );
    const auto share = beside.interpolate
    (
        positions.size(), data(positions), enclosed.cdata()
    );
    DynamicList<label> lonely;
    forAll(positions, i)
    {
        if (share[i] == 0)
        {
            lonely.append(i);
        }
    }
    lonely_.transfer(lonely);
}


Foam::melt::particleSurface::particleSurface
(
    const dictionary& dict,
    const pointField& positions,
    const scalarField& volumes,
    const scalar edge,
    const triangleMesh& mesh
)
:
    spacing_(edge),
    radius_(readRadius(dict)*spacing_),
    cloud_(positions.size(), data(positions), volumes.cdata(), radius_),
    shading_
    (
        positions.size(),
        data(positions),
        volumes.cdata(),
        readShading(dict)*spacing_
    ),
    mesh_(mesh)
{}


Foam::autoPtr<Foam::melt::particleSurface> Foam::melt::particleSurface::New
(
    const dictionary& dict,
    const polyMesh& mesh,
    const pointField& positions,
    const scalarField& volumes
)
{
    if (!voxelDensity::found(mesh))
    {
        return autoPtr<particleSurface>::New(dict, positions, volumes);
    }
    const voxelDensity density(mesh);
    return autoPtr<particleSurface>::New
    (
        dict, positions, volumes, density.edge(), density.surface(level(dict))
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::particleSurface::level(const dictionary& dict)
{
    return dict.getCheckOrDefault<scalar>
    (
        "level", 0.45, [](const scalar l) { return l > 0 && l < 1; }
    );
}


Foam::pointField Foam::melt::particleSurface::points() const
{
    return toVectorField(mesh_.points);
}


Foam::faceList Foam::melt::particleSurface::faces() const
{
    faceList result(mesh_.nTriangles());
    forAll(result, i)
    {
        const int* t = &mesh_.triangles[3*i];
        result[i] = triFace(t[0], t[1], t[2]).triFaceFace();
    }
    return result;
}


Foam::vectorField Foam::melt::particleSurface::normals() const
{
    return toVectorField
    (
        shading_.normals(mesh_.nPoints(), mesh_.points.data())
    );
}


Foam::scalarField Foam::melt::particleSurface::interpolate
(
    const scalarField& field
) const
{
    const auto values = cloud_.interpolate
    (
        mesh_.nPoints(), mesh_.points.data(), field.cdata()
    );
    scalarField result(values.size());
    std::copy(values.begin(), values.end(), result.begin());
    return result;
}


// ************************************************************************* //
