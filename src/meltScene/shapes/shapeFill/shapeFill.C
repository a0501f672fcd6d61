/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shapeFill.H"
#include "checkedEntry.H"
#include "pointField.H"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
namespace shapeFill
{

//- Coordinates of the lattice's points in the three directions
typedef FixedList<scalarList, 3> latticeCoordinates;


//- n coordinates from the first on
static scalarList coordinates
(
    const scalar first,
    const scalar spacing,
    const label n
)
{
    scalarList x(n);
    forAll(x, i)
    {
        x[i] = first + i*spacing;
    }

    return x;
}


//- Lattice that covers the box
static latticeCoordinates covering
(
    const boundBox& box,
    const scalar spacing,
    const vector& g
)
{
    const vector span(box.span());
    const vector magG(cmptMag(g));

    latticeCoordinates lattice;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        const label n = max(label(1), label(std::lround(span[d]/spacing)));
        const scalar length = (n - 1)*spacing;

        scalar first = box.midpoint()[d] - 0.5*length;
        if (magG[d] > 0 && magG[d] == cmptMax(magG))
        {
            first =
                g[d] < 0
              ? box.min()[d] + 0.5*spacing
              : box.max()[d] - 0.5*spacing - length;
        }

        lattice[d] = coordinates(first, spacing, n);
    }

    return lattice;
}


//- Points of the lattice
static pointField pointsOf(const latticeCoordinates& lattice)
{
    pointField points
    (
        lattice[0].size()*lattice[1].size()*lattice[2].size()
    );
    label pointi = 0;
    for (const scalar z : lattice[2])
    {
        for (const scalar y : lattice[1])
        {
            for (const scalar x : lattice[0])
            {
                points[pointi++] = point(x, y, z);
            }
        }
    }

    return points;
}


//- Share of the cell around each point that is inside
static scalarField filling
(
    const shape& body,
    const pointField& points,
    const scalar spacing
)
{
    // Enough to tell faces, edges and corners of the filling apart
    constexpr label nAlongCell = 3;

    const latticeCoordinates offsets
    (
        coordinates
        (
            -0.5*spacing*(nAlongCell - 1)/nAlongCell,
            spacing/nAlongCell,
            nAlongCell
        )
    );

    scalarField share(points.size(), Zero);
    for (const point& offset : pointsOf(offsets))
    {
        const boolList inside(body.inside(points + offset));
        forAll(share, pointi)
        {
            share[pointi] += inside[pointi];
        }
    }

    return share/pow3(scalar(nAlongCell));
}


//- The n points whose cells are filled most. Of those that are filled alike,
//  the dropped ones are spread evenly, not taken from one side
static pointField fullest
(
    const shape& body,
    const pointField& points,
    const scalar spacing,
    const label n
)
{
    const scalarField share(filling(body, points, spacing));

    scalarField falling(share);
    std::sort(falling.begin(), falling.end(), std::greater<scalar>());
    const scalar least = falling[n - 1];

    const std::int64_t nAlike =
        std::count(share.begin(), share.end(), least);
    const std::int64_t nKept =
        n - (std::find(falling.begin(), falling.end(), least) - falling.begin());

    DynamicList<label> labels(n);
    std::int64_t alikei = 0;
    forAll(share, pointi)
    {
        if (share[pointi] > least)
        {
            labels.append(pointi);
        }
        else if (share[pointi] == least)
        {
            // As often as the quotient steps, that is nKept times
            if ((alikei + 1)*nKept/nAlike > alikei*nKept/nAlike)
            {
                labels.append(pointi);
            }
            ++alikei;
        }
    }

    return pointField(points, labels);
}

} // End namespace shapeFill
} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::melt::shapeFill::fill
(
    const shape& body,
    const scalar spacing,
    const vector& g
)
{
    if (!(spacing > 0))
    {
        FatalErrorInFunction
            << "Spacing " << spacing << " m to fill shape " << body.name()
            << " is not positive" << exit(FatalError);
    }

    const pointField points(pointsOf(covering(body.bounds(), spacing, g)));
    const boolList inside(body.inside(points));

    DynamicList<label> labels(points.size());
    forAll(points, pointi)
    {
        if (inside[pointi])
        {
            labels.append(pointi);
        }
    }

    return pointField(points, labels);
}


Foam::pointField Foam::melt::shapeFill::fillExactly
(
    const shape& body,
    const dictionary& dict,
    const vector& g,
    scalar& spacing
)
{
    const auto n = dict.get<label>("nParticles");
    if (n < 1)
    {
        FatalIOErrorInFunction(dict.lookup("nParticles"))
            << "Entry nParticles = " << n << " is not accepted: an integer"
            << " > 0 is expected." << exit(FatalIOError);
    }
    const scalar maxSurplus = checkedEntry::getOrDefault
    (
        dict,
        "maxSurplus",
        dimless,
        checkedEntry::notNegative(),
        0.05
    );

    pointField best;
    label nBelow = 0;
    const auto enough = [&](const scalar trial)
    {
        const pointField points(fill(body, trial, g));

        if (points.size() < n)
        {
            nBelow = max(nBelow, points.size());
            return false;
        }
        if (best.empty() || points.size() < best.size())
        {
            best = points;
            spacing = trial;
        }
        return true;
    };

    // Two spacings of which only the smaller gives enough points
    const scalar ratio = 1 + 1/std::cbrt(scalar(n));
    scalar smaller = std::cbrt(body.volume()/n);
    scalar larger = smaller;
    while (!enough(smaller))
    {
        larger = smaller;
        smaller /= ratio;
    }
    while (larger <= smaller || enough(larger))
    {
        larger *= ratio;
    }

    // Halve until less than one point should lie between the two
    while (best.size() > n && 3*n*(larger/smaller - 1) > 1)
    {
        const scalar middle = std::sqrt(smaller*larger);
        (enough(middle) ? smaller : larger) = middle;
    }

    if (best.size() > (1 + maxSurplus)*n)
    {
        FatalIOErrorInFunction(dict.lookup("nParticles"))
            << "Entry nParticles = " << n << " cannot be reached: the nearest"
            << " lattices in shape " << body.name() << " have " << nBelow
            << " and " << best.size() << " points, of which maxSurplus = "
            << maxSurplus << " times nParticles may be dropped."
            << exit(FatalIOError);
    }

    return best.size() > n ? fullest(body, best, spacing, n) : best;
}


bool Foam::melt::shapeFill::overlap
(
    const shape& a,
    const shape& b,
    const scalar spacing
)
{
    const boundBox boxA(a.bounds());
    const boundBox boxB(b.bounds());
    const boundBox both
    (
        max(boxA.min(), boxB.min()),
        min(boxA.max(), boxB.max())
    );
    const vector span(both.span());

    // Touching faces may overlap by round-off
    if (cmptMin(span) <= ROOTSMALL*spacing)
    {
        return false;
    }

    latticeCoordinates lattice;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        const label n = std::ceil(span[d]/spacing);
        lattice[d] = coordinates(both.min()[d] + 0.5*span[d]/n, span[d]/n, n);
    }

    const pointField points(pointsOf(lattice));
    const boolList insideA(a.inside(points));
    const boolList insideB(b.inside(points));
    forAll(points, pointi)
    {
        if (insideA[pointi] && insideB[pointi])
        {
            return true;
        }
    }

    return false;
}


Foam::labelList Foam::melt::shapeFill::outside
(
    const pointField& points,
    const boundBox& domain
)
{
    DynamicList<label> labels;
    forAll(points, pointi)
    {
        if (!domain.contains(points[pointi]))
        {
            labels.append(pointi);
        }
    }

    return labelList(std::move(labels));
}


// ************************************************************************* //
