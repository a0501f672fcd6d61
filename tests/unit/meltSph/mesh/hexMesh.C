/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hexMesh.H"
#include "cellModel.H"
#include "cellShape.H"
#include "meltUnitTests.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::polyMesh> Foam::melt::unitTest::hexMesh
(
    const labelVector& n,
    const std::function<point(const point&)>& map,
    const wordList& patchTypes,
    const std::function<bool(label, label, label)>& solid
)
{
    const auto vertex = [&](label i, label j, label k)
    {
        return i + (n.x() + 1)*(j + (n.y() + 1)*k);
    };

    // Points that no cell uses are allowed in a polyMesh, but not wanted
    labelList used((n.x() + 1)*(n.y() + 1)*(n.z() + 1), -1);
    DynamicList<point> points;
    DynamicList<cellShape> cells;
    List<DynamicList<face>> patches(6);

    for (label k = 0; k < n.z(); ++k)
    for (label j = 0; j < n.y(); ++j)
    for (label i = 0; i < n.x(); ++i)
    {
        if (solid(i, j, k))
        {
            continue;
        }

        labelList corners(8);
        label corner = 0;
        for (label dk : {0, 1})
        for (const labelPair& d :
            {
                labelPair(0, 0), labelPair(1, 0),
                labelPair(1, 1), labelPair(0, 1)
            })
        {
            const label a = i + d.first(), b = j + d.second(), c = k + dk;
            label& index = used[vertex(a, b, c)];
            if (index < 0)
            {
                index = points.size();
                points.append
                (
                    map
                    (
                        point
                        (
                            scalar(a)/n.x(), scalar(b)/n.y(), scalar(c)/n.z()
                        )
                    )
                );
            }
            corners[corner++] = index;
        }

        cells.append(cellShape(cellModel::ref(cellModel::HEX), corners));

        // Faces of a hexahedron come in the order xMin, xMax, yMin, ...
        const faceList faces(cells.last().faces());
        const bool onPatch[] =
        {
            i == 0, i == n.x() - 1,
            j == 0, j == n.y() - 1,
            k == 0, k == n.z() - 1
        };
        for (label patchi = 0; patchi < 6; ++patchi)
        {
            if (onPatch[patchi])
            {
                patches[patchi].append(faces[patchi]);
            }
        }
    }

    faceListList patchFaces(6);
    forAll(patches, patchi)
    {
        patchFaces[patchi] = patches[patchi];
    }

    const wordList names({"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"});
    PtrList<dictionary> boundary(6);
    forAll(names, patchi)
    {
        boundary.set(patchi, new dictionary());
        boundary[patchi].add("type", patchTypes[patchi]);
        if (patchTypes[patchi] == "cyclic")
        {
            boundary[patchi].add("neighbourPatch", names[patchi^1]);
        }
    }

    return autoPtr<polyMesh>::New
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime().constant(),
            runTime(),
            IOobject::NO_READ,
            IOobject::NO_WRITE
        ),
        pointField(points),
        cells,
        patchFaces,
        names,
        boundary,
        "inner",
        "wall"
    );
}


Foam::autoPtr<Foam::polyMesh> Foam::melt::unitTest::boxMesh
(
    const labelVector& n,
    const vector& size,
    const wordList& patchTypes
)
{
    return hexMesh
    (
        n,
        [&](const point& p) { return cmptMultiply(p, size); },
        patchTypes
    );
}


// ************************************************************************* //
