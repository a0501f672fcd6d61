/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "occupancyGrid.H"
#include "voxelSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Empty cells around the melt: the filter reaches one, the surface another
constexpr Foam::label margin = 2;

//- 3.2 GB
constexpr Foam::scalar maxCells = 2e8;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::occupancyGrid::add
(
    const boundBox& box,
    const scalar volume,
    const scalar T
)
{
    // Overlap of the box with the cells it reaches, in each direction, as a
    // share of the box
    labelVector first;
    List<scalar> share[3];
    for (direction k = 0; k < 3; ++k)
    {
        const scalar low = (box.min()[k] - origin_[k])/spacing_;
        const scalar high = (box.max()[k] - origin_[k])/spacing_;
        first[k] = max(label(std::floor(low)), label(0));
        const label last = min(label(std::ceil(high)), n_[k]) - 1;

        for (label i = first[k]; i <= last; ++i)
        {
            share[k].append
            (
                max(min(high, scalar(i + 1)) - max(low, scalar(i)), scalar(0))
               /(high - low)
            );
        }
    }

    const scalar cells = volume/pow3(spacing_);
    forAll(share[2], k)
    {
        forAll(share[1], j)
        {
            const label row =
                first.x()
              + n_.x()*(first.y() + j + n_.y()*(first.z() + k));
            forAll(share[0], i)
            {
                const scalar part =
                    cells*share[0][i]*share[1][j]*share[2][k];
                fraction_[row + i] += part;
                T_[row + i] += part*T;
            }
        }
    }
}


void Foam::melt::occupancyGrid::filter()
{
    const label stride[3] = {1, n_.x(), n_.x()*n_.y()};

    for (direction k = 0; k < 3; ++k)
    {
        // The margin is empty: what is beyond it does not matter
        scalarField filtered(0.5*fraction_);
        for (label i = stride[k]; i < fraction_.size() - stride[k]; ++i)
        {
            filtered[i] +=
                0.25*(fraction_[i - stride[k]] + fraction_[i + stride[k]]);
        }
        fraction_.transfer(filtered);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::occupancyGrid::occupancyGrid
(
    const meltParcels& parcels,
    const boundBox& bounds,
    const scalar spacing
)
:
    origin_(bounds.min() - margin*spacing*vector::one),
    spacing_(spacing)
{
    scalar nCells = 1;
    for (direction k = 0; k < 3; ++k)
    {
        n_[k] = label(std::ceil(bounds.span()[k]/spacing)) + 2*margin;
        nCells *= n_[k];
    }
    if (!(nCells <= maxCells))
    {
        FatalErrorInFunction
            << "A grid of " << n_ << " cells of " << spacing
            << " m has more than " << maxCells << " cells." << nl
            << "Accepted: a greater gridSpacing" << exit(FatalError);
    }

    fraction_.resize(n_.x()*n_.y()*n_.z(), Zero);
    T_.resize(fraction_.size(), Zero);

    forAll(parcels.box, i)
    {
        add(parcels.box[i], parcels.volume[i], parcels.T[i]);
    }

    forAll(T_, celli)
    {
        if (fraction_[celli] > 0)
        {
            T_[celli] /= fraction_[celli];
        }
        fraction_[celli] = min(fraction_[celli], scalar(1));
    }
    filter();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::melt::occupancyGrid::nOccupied() const
{
    label n = 0;
    forAll(fraction_, celli)
    {
        n += occupied(celli);
    }
    return n;
}


Foam::scalar Foam::melt::occupancyGrid::occupiedVolume() const
{
    return nOccupied()*pow3(spacing_);
}


Foam::triSurface Foam::melt::occupancyGrid::surface() const
{
    List<float> values(fraction_.size());
    std::copy(fraction_.begin(), fraction_.end(), values.begin());

    const point first(origin_ + 0.5*spacing_*vector::one);
    const triangleMesh mesh
    (
        voxelSurface
        (
            {int(n_.x()), int(n_.y()), int(n_.z())},
            values.cdata(),
            {first.x(), first.y(), first.z()},
            spacing_,
            0.5
        )
    );

    pointField points(mesh.nPoints());
    forAll(points, i)
    {
        points[i] = point
        (
            mesh.points[3*i], mesh.points[3*i + 1], mesh.points[3*i + 2]
        );
    }
    List<labelledTri> triangles(mesh.nTriangles());
    forAll(triangles, i)
    {
        triangles[i] = labelledTri
        (
            mesh.triangles[3*i],
            mesh.triangles[3*i + 1],
            mesh.triangles[3*i + 2],
            0
        );
    }
    return triSurface(triangles, points);
}


Foam::scalar Foam::melt::occupancyGrid::intersectionOverUnion
(
    const occupancyGrid& a,
    const occupancyGrid& b
)
{
    scalar both = 0;
    scalar any = 0;
    forAll(a.fraction_, celli)
    {
        both += min(a.fraction_[celli], b.fraction_[celli]);
        any += max(a.fraction_[celli], b.fraction_[celli]);
    }
    return any > 0 ? both/any : 1;
}


Foam::Pair<Foam::scalar> Foam::melt::occupancyGrid::TDifference
(
    const occupancyGrid& a,
    const occupancyGrid& b
)
{
    scalar squares = 0;
    scalar greatest = 0;
    label n = 0;
    forAll(a.fraction_, celli)
    {
        // Filtering occupies cells without melt in gaps
        if
        (
            a.occupied(celli) && b.occupied(celli)
         && a.T_[celli] > 0 && b.T_[celli] > 0
        )
        {
            const scalar difference = mag(a.T_[celli] - b.T_[celli]);
            squares += sqr(difference);
            greatest = max(greatest, difference);
            ++n;
        }
    }
    return Pair<scalar>(n ? std::sqrt(squares/n) : 0, greatest);
}


// ************************************************************************* //
