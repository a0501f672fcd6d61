/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianFill.H"
#include "initialTemperature.H"
#include "shape.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

// Points along an edge of a cell at the surface, of plane and of other scenes
const label perEdgeInPlane = 8, perEdge = 4;

//- Share of each cell that is inside a shape
scalarField shares(const shape& body, const eulerianMesh& mesh)
{
    const fvMesh& fv = mesh.mesh();
    const pointField& centres = fv.cellCentres();
    const std::array<double, 3>& d = mesh.grid().d();
    boundBox bounds(body.bounds());
    bounds.inflate(SMALL);

    // Centres decide for cells far from the surface: all of 27 points that are
    // a cell apart are the same
    const boolList inside(body.inside(centres));
    scalarField share(centres.size());
    forAll(share, celli)
    {
        share[celli] = inside[celli];
    }
    const std::vector<double> onGrid(mesh.onGrid(share));
    labelList mixed;
    forAll(share, celli)
    {
        const vector half(0.5*d[0], 0.5*d[1], 0.5*d[2]);
        if (!bounds.overlaps(boundBox(centres[celli] - half, centres[celli] + half)))
        {
            continue;
        }
        bool same = true;
        const staggeredGrid::triple at
        (
            mesh.grid().position(mesh.gridCell(celli))
        );
        for (int i = 0; i < 27 && same; ++i)
        {
            const staggeredGrid::triple c
            {
                at[0] + i % 3 - 1, at[1] + i/3 % 3 - 1, at[2] + i/9 - 1
            };
            const int other = mesh.grid().inside(c) ? mesh.grid().cell(c) : -1;
            same =
                other < 0
             || !mesh.has(other)
             || (onGrid[other] > 0) == inside[celli];
        }
        // A cell at the border of the box of the shape is cut, too
        const bool within =
            bounds.contains(centres[celli] - half)
         && bounds.contains(centres[celli] + half);
        if (!same || !within)
        {
            mixed.append(celli);
        }
    }

    const bool inPlane = fv.nSolutionD() < 3;
    staggeredGrid::triple m;
    for (int a = 0; a < 3; ++a)
    {
        m[a] =
            !mesh.grid().solved(a) ? 1 : inPlane ? perEdgeInPlane : perEdge;
    }
    const label perCell = m[0]*m[1]*m[2];
    pointField points(mixed.size()*perCell);
    forAll(points, i)
    {
        const label j = i % perCell;
        const label index[3] = {j % m[0], (j/m[0]) % m[1], j/(m[0]*m[1])};
        points[i] = centres[mixed[i/perCell]];
        for (direction a = 0; a < 3; ++a)
        {
            points[i][a] += d[a]*((index[a] + 0.5)/m[a] - 0.5);
        }
    }
    const boolList in(body.inside(points));
    UIndirectList<scalar>(share, mixed) = 0;
    forAll(in, i)
    {
        share[mixed[i/perCell]] += scalar(in[i])/perCell;
    }
    return share;
}


//- Velocities of the faces of cells that a shape fills, in part or wholly
void setVelocities
(
    const shape& body,
    const eulerianMesh& mesh,
    const scalarField& share,
    faceVelocities& U
)
{
    const std::vector<double> onGrid(mesh.onGrid(share));
    DynamicList<point> points;
    DynamicList<labelPair> faces;
    mesh.grid().forAllFaces([&](int a, int face, int lower, int upper)
    {
        if
        (
            lower >= 0 && upper >= 0 && mesh.has(lower) && mesh.has(upper)
         && (onGrid[lower] > 0 || onGrid[upper] > 0)
        )
        {
            points.append(mesh.faceCentre(a, upper));
            faces.append(labelPair(a, face));
        }
    });
    const vectorField velocity(body.velocity(pointField(points)));
    forAll(faces, i)
    {
        const label a = faces[i].first();
        U[a][faces[i].second()] = velocity[i][a];
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::eulerianFill::fill
(
    const meltScene& scene,
    const eulerianMesh& mesh,
    scalarField& alpha,
    scalarField& alphaH,
    faceVelocities& U
)
{
    const dictionary& shapes = scene.dict().subDict("shapes");
    const enthalpyCurve& curve = scene.thermo().enthalpy();
    alpha = 0;
    alphaH = 0;
    for (const shape& body : scene.shapes())
    {
        const autoPtr<initialTemperature> T
        (
            initialTemperature::New
            (
                shapes.subDict(body.name()).subDict("T"), body
            )
        );
        const scalarField share(shares(body, mesh));
        const scalarField values(T->value(mesh.mesh().cellCentres()));
        setVelocities(body, mesh, share, U);
        forAll(share, celli)
        {
            const scalar part =
                mesh.has(mesh.gridCell(celli))
              ? min(share[celli], 1 - alpha[celli]) : 0;
            alpha[celli] += part;
            alphaH[celli] += part*curve.h(values[celli]);
        }
    }
    if (gSum(alpha) <= 0)
    {
        FatalIOErrorInFunction(shapes)
            << "The mesh is empty: no shape fills a cell of "
            << scene.resolution() << " m that terrain leaves free." << nl
            << "Accepted: a shape thicker than that" << exit(FatalIOError);
    }
}

// ************************************************************************* //
