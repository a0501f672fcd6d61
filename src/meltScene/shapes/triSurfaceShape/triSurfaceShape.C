/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "triSurfaceShape.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "geometryFile.H"
#include "labelVector.H"
#include "mergePoints.H"
#include "surfaceDefects.H"
#include "triSurface.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(triSurfaceShape);
    addToRunTimeSelectionTable(shape, triSurfaceShape, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

//- The surface with equal points merged and without triangles that thereby
//  have less than three corners; files of many formats repeat points
static triSurface merged(const triSurface& surface)
{
    labelList newLabels;
    pointField points;
    mergePoints(surface.points(), 0, false, newLabels, points);

    DynamicList<labelledTri> triangles(surface.size());
    for (const labelledTri& t : surface)
    {
        const labelledTri u
        (
            newLabels[t[0]],
            newLabels[t[1]],
            newLabels[t[2]],
            t.region()
        );

        if (u[0] != u[1] && u[1] != u[2] && u[2] != u[0])
        {
            triangles.append(u);
        }
    }

    return triSurface(triangles, points);
}


//- The surface of a file. FatalIOError if it cannot be used
static triSurface readSurface(const fileName& file, const dictionary& dict)
{
    if (!triSurface::canRead(file))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file' is " << file << "; accepted extensions are "
            << flatOutput(triSurface::readTypes().sortedToc())
            << exit(FatalIOError);
    }

    const triSurface surface(merged(triSurface(file)));

    if (surface.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file': the surface in " << file << " has no triangles"
            << exit(FatalIOError);
    }

    for (const point& p : surface.points())
    {
        if (!std::isfinite(cmptSum(cmptMag(p))))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'file': the surface in " << file
                << " has the point " << p << exit(FatalIOError);
        }
    }

    return surface;
}


static windingNumber::vector toEigen(const point& p)
{
    return {p.x(), p.y(), p.z()};
}


static windingNumber windingNumberOf(const triSurface& surface)
{
    const pointField& points = surface.points();

    std::vector<windingNumber::triangle> triangles;
    triangles.reserve(surface.size());
    for (const labelledTri& t : surface)
    {
        triangles.push_back
        ({
            toEigen(points[t[0]]),
            toEigen(points[t[1]]),
            toEigen(points[t[2]])
        });
    }

    return windingNumber(std::move(triangles));
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::melt::triSurfaceShape::sampledVolume
(
    const label nAlongLongest
) const
{
    const boundBox box(points_, false);
    const scalar spacing = cmptMax(box.span())/nAlongLongest;
    const labelVector n
    (
        label(std::ceil(box.span().x()/spacing)),
        label(std::ceil(box.span().y()/spacing)),
        label(std::ceil(box.span().z()/spacing))
    );

    label nInside = 0;
    #pragma omp parallel for collapse(2) schedule(dynamic) \
        reduction(+:nInside)
    for (label k = 0; k < n.z(); ++k)
    {
        for (label j = 0; j < n.y(); ++j)
        {
            for (label i = 0; i < n.x(); ++i)
            {
                const vector steps(i + 0.5, j + 0.5, k + 0.5);
                nInside += contains(box.min() + spacing*steps);
            }
        }
    }

    return nInside*pow3(spacing);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::triSurfaceShape::triSurfaceShape
(
    const fileName& file,
    const word& name,
    const dictionary& dict
)
:
    shape(name, dict),
    points_(),
    winding_(),
    orientation_(1),
    volume_(0)
{
    const triSurface surface(readSurface(file, dict));
    points_ = surface.points();
    winding_.reset(new windingNumber(windingNumberOf(surface)));

    if (winding_->nDegenerate())
    {
        Info<< "Shape " << name << ": " << winding_->nDegenerate() << " of "
            << surface.size() << " triangles have no area and are left out"
            << endl;
    }

    volume_ = winding_->volume();
    if (volume_ < 0)
    {
        Info<< "Shape " << name << ": the triangles point inwards and are"
            << " turned" << endl;
        orientation_ = -1;
        volume_ *= -1;
    }

    const surfaceDefects defects(surface);
    if (!defects.closed())
    {
        volume_ = sampledVolume
        (
            label
            (
                checkedEntry::getOrDefault
                (
                    dict,
                    "nVolumeSamples",
                    dimless,
                    checkedEntry::positive(),
                    64
                )
            )
        );
        WarningInFunction
            << "Shape " << name << ": the surface in " << file << " has "
            << defects.nHoles() << " holes (" << defects.nOpenEdges()
            << " open edges) and " << defects.nTurnedEdges()
            << " edges where it turns inside out." << nl
            << "    It is filled where its winding number is above one half: "
            << volume_ << " m3 before scaling" << endl;
    }

    if (!(volume_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file': the surface in " << file
            << " encloses no volume" << exit(FatalIOError);
    }
}


Foam::melt::triSurfaceShape::triSurfaceShape
(
    const word& name,
    const dictionary& dict,
    const fileName& caseDirectory
)
:
    triSurfaceShape(geometryFile::find(dict, caseDirectory), name, dict)
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

bool Foam::melt::triSurfaceShape::contains(const point& x) const
{
    return orientation_*(*winding_)(toEigen(x)) > 0.5;
}


Foam::scalar Foam::melt::triSurfaceShape::support(const vector& n) const
{
    scalar greatest = -VGREAT;
    for (const point& p : points_)
    {
        greatest = max(greatest, n & p);
    }

    return greatest;
}


// ************************************************************************* //
