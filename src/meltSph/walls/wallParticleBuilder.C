/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallParticleBuilder.H"
#include "treeDataCell.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{
    // Lengths that are equal but for round-off are to give equal numbers
    constexpr double roundOff = 1e-6;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::size_t Foam::melt::wallParticleBuilder::cellOf
(
    const labelVector& cell
) const
{
    // Three large primes, after Teschner et al. 2003
    return
        std::size_t(cell.x())*73856093
      ^ std::size_t(cell.y())*19349663
      ^ std::size_t(cell.z())*83492791;
}


Foam::labelVector Foam::melt::wallParticleBuilder::cellOf(const point& p) const
{
    return labelVector
    (
        label(std::floor(p.x()/spacing_)),
        label(std::floor(p.y()/spacing_)),
        label(std::floor(p.z()/spacing_))
    );
}


bool Foam::melt::wallParticleBuilder::takenWithin
(
    const point& p,
    const scalar distance
) const
{
    const labelVector home(cellOf(p));

    for (label k = -1; k <= 1; ++k)
    for (label j = -1; j <= 1; ++j)
    for (label i = -1; i <= 1; ++i)
    {
        const auto range =
            grid_.equal_range(cellOf(home + labelVector(i, j, k)));

        for (auto iter = range.first; iter != range.second; ++iter)
        {
            const std::size_t q = iter->second;
            const point other(particles_.x[q], particles_.y[q], particles_.z[q]);
            if (mag(other - p) < distance)
            {
                return true;
            }
        }
    }

    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::wallParticleBuilder::wallParticleBuilder
(
    const wallSurface& surface,
    const scalar spacing,
    const scalar supportRadius,
    const boundBox& region
)
:
    surface_(surface),
    spacing_(spacing),
    supportRadius_(supportRadius),
    region_(region)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::melt::wallParticleBuilder::nLayers() const
{
    return label(std::ceil(supportRadius_/spacing_ - 0.5 - roundOff));
}


Foam::label Foam::melt::wallParticleBuilder::nFitting(const scalar length) const
{
    return max(label(1), label(std::floor(length/spacing_ + 0.5 - roundOff)));
}


bool Foam::melt::wallParticleBuilder::wanted(const point& p) const
{
    const point nearest(min(max(p, region_.min()), region_.max()));

    return mag(p - nearest) < supportRadius_;
}


bool Foam::melt::wallParticleBuilder::ownedAt
(
    const point& p,
    const scalar distance
) const
{
    return surface_.nearest(p).distance > distance - roundOff*spacing_;
}


bool Foam::melt::wallParticleBuilder::add(const site& s, const scalar distance)
{
    const point& p = s.position;

    if
    (
        !wanted(p)
     || takenWithin(p, distance)
     || surface_.mesh().cellTree().findInside(p) >= 0
    )
    {
        return false;
    }

    const polyBoundaryMesh& patches = surface_.mesh().boundaryMesh();
    const label meshFace = surface_.meshFace(s.face);
    const label patchi = patches.whichPatch(meshFace);
    const auto patchOf = [&](const label facei)
    {
        return
            facei < 0 ? -1 : patches.whichPatch(surface_.meshFace(facei));
    };

    grid_.insert({cellOf(cellOf(p)), particles_.size()});

    particles_.x.push_back(p.x());
    particles_.y.push_back(p.y());
    particles_.z.push_back(p.z());
    particles_.nx.push_back(s.normal.x());
    particles_.ny.push_back(s.normal.y());
    particles_.nz.push_back(s.normal.z());
    particles_.offset.push_back(s.offset);
    particles_.volume.push_back(s.volume);
    particles_.patch.push_back(patchi);
    particles_.face.push_back(patches[patchi].whichFace(meshFace));
    particles_.otherPatches.push_back
    (
        {patchOf(s.otherFaces[0]), patchOf(s.otherFaces[1])}
    );

    return true;
}


// ************************************************************************* //
