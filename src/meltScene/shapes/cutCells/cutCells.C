/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutCells.H"

#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

// Parts of a column whose ends are looked at, halvings of those that differ
constexpr label nParts = 2, nHalvings = 8;

// Columns across a cell: those of 4 x 4 that are at the cell's sides but not at
// its edges, two in each row
constexpr label perCell = 8;
constexpr scalar across[perCell][2] =
{
    {-0.375, -0.125}, {-0.375, 0.125}, {0.375, -0.125}, {0.375, 0.125},
    {-0.125, -0.375}, {-0.125, 0.375}, {0.125, -0.375}, {0.125, 0.375}
};


//- The columns of cells
class columns
{
    const pointField& centres_;

    const labelList& axes_;

    const vector& edges_;

public:

    columns
    (
        const pointField& centres,
        const labelList& axes,
        const vector& edges
    )
    :
        centres_(centres),
        axes_(axes),
        edges_(edges)
    {}

    label size() const
    {
        return perCell*centres_.size();
    }

    //- Point of a column at a share in [0, 1] of its length
    point at(const label column, const scalar share) const
    {
        const label celli = column/perCell;
        const scalar* const place = across[column % perCell];
        const direction along = axes_[celli];
        const direction b = (along + 1) % 3, c = (along + 2) % 3;

        point p(centres_[celli]);
        p[along] += edges_[along]*(share - 0.5);
        p[b] += edges_[b]*place[0];
        p[c] += edges_[c]*place[1];
        return p;
    }

    //- Ends of the parts; those of the column are within the cell by less than
    //  counts, as what begins at its side is not in it
    static scalar part(const label i)
    {
        constexpr scalar within = 1e-6;
        return min(max(scalar(i)/nParts, within), 1 - within);
    }
};


//- A part of a column that the surface crosses
struct crossedPart
{
    label column;

    //- The end that is inside, and the nearest places known to be inside and
    //  outside
    scalar end, inside, outside;

    //- Which of the two was found last
    bool lastInside = false;

    crossedPart(const label columni, const scalar insideEnd, const scalar other)
    :
        column(columni),
        end(insideEnd),
        inside(insideEnd),
        outside(other)
    {}

    scalar middle() const
    {
        return 0.5*(inside + outside);
    }

    //- Length that is inside, to the place that was found earlier: to the
    //  surface if that was looked at
    scalar length() const
    {
        return mag((lastInside ? outside : inside) - end);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::melt::cutCells::shares
(
    const shape& body,
    const pointField& centres,
    const labelList& axes,
    const vector& edges
)
{
    const columns lines(centres, axes, edges);
    pointField points((nParts + 1)*lines.size());
    forAll(points, i)
    {
        points[i] = lines.at
        (
            i/(nParts + 1), columns::part(i % (nParts + 1))
        );
    }
    boolList in(body.inside(points));

    scalarField share(centres.size(), Zero);
    std::vector<crossedPart> crossed;
    for (label column = 0; column < lines.size(); ++column)
    {
        for (label i = 0; i < nParts; ++i)
        {
            const label first = column*(nParts + 1) + i;
            const scalar from = scalar(i)/nParts, to = scalar(i + 1)/nParts;
            if (in[first] && in[first + 1])
            {
                share[column/perCell] += (to - from)/perCell;
            }
            else if (in[first])
            {
                crossed.push_back({column, from, to});
            }
            else if (in[first + 1])
            {
                crossed.push_back({column, to, from});
            }
        }
    }

    points.setSize(label(crossed.size()));
    for (label halving = 0; halving < nHalvings; ++halving)
    {
        forAll(points, i)
        {
            points[i] = lines.at(crossed[i].column, crossed[i].middle());
        }
        in = body.inside(points);
        forAll(points, i)
        {
            crossedPart& c = crossed[i];
            (in[i] ? c.inside : c.outside) = c.middle();
            c.lastInside = in[i];
        }
    }
    for (const crossedPart& c : crossed)
    {
        share[c.column/perCell] += c.length()/perCell;
    }
    return share;
}


// ************************************************************************* //
