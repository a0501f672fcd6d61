/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceHeat.H"
#include "surfaceFields.H"
#include "surfaceSlope.H"
#include "withOtherRanks.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;
using triple = staggeredGrid::triple;

triple cellAt(const eulerianMesh& mesh, const point& p)
{
    triple c;
    for (direction a = 0; a < 3; ++a)
    {
        c[a] = int
        (
            std::floor((p[a] - mesh.box().min()[a])/mesh.grid().d()[a])
        );
    }
    return c;
}


//- Cells at least half full, and terrain, are in the way
class shade
:
    public occlusion
{
    const eulerianMesh& mesh_;

    const std::vector<double>& alpha_;

    const labelList& cells_;

    bool fills(const triple& c) const
    {
        const staggeredGrid& grid = mesh_.grid();
        return
            grid.inside(c)
         && (
                alpha_[grid.cell(c)] >= 0.5
             || mesh_.isTerrain(grid.cell(c))
            );
    }

    //- Walks through the cells between the points, J. Amanatides, A. Woo,
    //  Eurographics 1987
    bool blocked(const point& from, const point& to, const label own) const
    {
        const staggeredGrid& grid = mesh_.grid();
        triple c(cellAt(mesh_, from));
        const vector ray(to - from);
        std::array<double, 3> next, width;
        for (direction a = 0; a < 3; ++a)
        {
            const double edge =
                mesh_.box().min()[a] + grid.d()[a]*(c[a] + (ray[a] > 0));
            next[a] =
                ray[a] == 0
              ? std::numeric_limits<double>::infinity()
              : (edge - from[a])/ray[a];
            width[a] = ray[a] == 0 ? 0 : grid.d()[a]/std::abs(ray[a]);
        }
        while (grid.inside(c))
        {
            if (grid.cell(c) != own && fills(c))
            {
                return true;
            }
            const int a =
                next[0] <= next[1]
              ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
            if (next[a] >= 1)
            {
                return false;
            }
            c[a] += ray[a] > 0 ? 1 : -1;
            next[a] += width[a];
        }
        return false;
    }

public:

    shade
    (
        const eulerianMesh& mesh,
        const std::vector<double>& alpha,
        const labelList& cells
    )
    :
        mesh_(mesh),
        alpha_(alpha),
        cells_(cells)
    {}

    virtual boolList blocked
    (
        const surfaceElements& elements,
        const labelList& set,
        const pointField& to
    ) const
    {
        boolList result(set.size());
        forAll(set, i)
        {
            result[i] =
                blocked
                (
                    elements.position[set[i]],
                    to[i],
                    mesh_.gridCell(cells_[set[i]])
                );
        }
        return result;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::melt::surfaceElements Foam::melt::surfaceHeat::elements
(
    const scalarField& alpha,
    const std::vector<double>& alphaOnGrid,
    const scalarField& T,
    const scalarField& kappa,
    labelList& cells
) const
{
    const fvMesh& mesh = mesh_.mesh();
    DynamicList<label> cell;
    DynamicList<vector> free;
    scalarField terrain(alpha.size());
    forAll(terrain, celli)
    {
        terrain[celli] = mesh_.isTerrain(mesh_.gridCell(celli));
    }
    const withOtherRanks alphaOf(mesh, alpha), terrainOf(mesh, terrain);
    mesh_.forAllInner([&](const label facei)
    {
        const label own = mesh.faceOwner()[facei];
        if (terrain[own] > 0 || terrainOf.beyond(facei) > 0)
        {
            return;
        }
        const scalar difference = alpha[own] - alphaOf.beyond(facei);
        const bool isOwn = difference > 0;
        if (difference != 0 && (isOwn || mesh.isInternalFace(facei)))
        {
            cell.append(isOwn ? own : mesh.neighbour()[facei]);
            free.append(difference*mesh.faceAreas()[facei]);
        }
    });

    vectorField sum(alpha.size(), Zero);
    forAll(cell, i)
    {
        sum[cell[i]] += free[i];
    }

    surfaceElements e;
    const label n = cell.size();
    e.position.setSize(n);
    e.normal.setSize(n);
    e.area.setSize(n);
    e.smoothArea.setSize(n);
    e.T.setSize(n);
    e.resistance.setSize(n, 0);
    e.free.setSize(n, true);
    forAll(cell, i)
    {
        const label c = cell[i];
        e.area[i] = mag(free[i]);
        e.normal[i] = free[i]/e.area[i];
        e.smoothArea[i] =
            sqr(e.area[i])
           /mag
            (
                surfaceSlope(mesh_.grid(), alphaOnGrid, mesh_.gridCell(c))
               .at(free[i], sum[c])
            );
        const std::array<double, 3>& d = mesh_.grid().d();
        const vector size(d[0], d[1], d[2]);
        const vector across(cmptMultiply(e.normal[i], size));
        e.position[i] = mesh.C()[c] + (alpha[c] - 0.5)*across;
        e.T[i] = T[c];

        // Heat comes to the centres of cells, half a cell behind the surface
        if (kappa[c] > 0)
        {
            e.resistance[i] = 0.5*mag(across)/(kappa[c]*e.area[i]);
        }
    }
    cells = cell;
    return e;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::surfaceHeat::surfaceHeat
(
    const eulerianMesh& mesh,
    const dictionary& meltProperties,
    const scalarField& alpha,
    const scalar time
)
:
    mesh_(mesh),
    sources_(meltProperties)
{
    const std::vector<double> alphaOnGrid(mesh_.onGrid(alpha));
    for (const heatSource& source : sources_)
    {
        for (const point& p : source.outside(time))
        {
            const triple c(cellAt(mesh_, p));
            if
            (
                time == 0
             && mesh_.grid().inside(c)
             && alphaOnGrid[mesh_.grid().cell(c)] >= 0.5
            )
            {
                FatalIOErrorInFunction(source.dict())
                    << "Heat source " << source.name() << " at " << p
                    << " is inside the melt." << nl
                    << "Accepted: a position in the open" << exit(FatalIOError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::enthalpyEquation::source Foam::melt::surfaceHeat::heat
(
    const scalar time,
    const scalarField& alpha,
    const scalarField& T,
    const scalarField& kappa
)
{
    sources_.update();
    enthalpyEquation::source result
    {
        scalarField(alpha.size(), 0), scalarField(alpha.size(), 0)
    };
    if (!active())
    {
        return result;
    }

    labelList cells;
    const std::vector<double> alphaOnGrid(mesh_.onGrid(alpha));
    const surfaceElements e(elements(alpha, alphaOnGrid, T, kappa, cells));
    const absorbedHeat absorbed
    (
        sources_.heatSurface(time, e, shade(mesh_, alphaOnGrid, cells))
    );
    forAll(cells, i)
    {
        result.power[cells[i]] += absorbed.power[i];
        result.slope[cells[i]] += absorbed.slope[i];
    }
    if (sources_.inVolume())
    {
        const fvMesh& mesh = mesh_.mesh();
        DynamicList<label> filled;
        forAll(alpha, celli)
        {
            if (alpha[celli] > 0)
            {
                filled.append(celli);
            }
        }
        const scalarField power
        (
            sources_.heatVolume
            (
                time,
                pointField(mesh.C(), filled),
                scalarField(alpha*mesh.V(), filled)
            )
        );
        forAll(filled, i)
        {
            result.power[filled[i]] += power[i];
        }
    }
    return result;
}

// ************************************************************************* //
