/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "povScenery.H"
#include "OSspecific.H"
#include "povVector.H"
#include "triSurface.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::povScenery::povScenery
(
    const dictionary& dict,
    const fileName& caseDirectory
)
:
    file_(dict.lookupOrDefault<fileName>("scenery", fileName())),
    colour_(dict.lookupOrDefault<vector>("sceneryColour", {0.45, 0.42, 0.38}))
{
    if (!file_.empty())
    {
        if (!file_.isAbsolute())
        {
            file_ = caseDirectory/file_;
        }
        if (!isFile(file_))
        {
            FatalIOErrorInFunction(dict.lookup("scenery"))
                << "There is no file " << file_ << nl
                << "Accepted: a surface file of the case"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::povScenery::write
(
    Ostream& os,
    const point& origin,
    const scalar scale
) const
{
    if (file_.empty())
    {
        return;
    }
    const triSurface surface(file_);
    const pointField& points = surface.points();

    os  << "mesh2" << nl << '{' << nl
        << "vertex_vectors{" << points.size() << nl;
    for (const point& p : points)
    {
        os  << povVector((p - origin)*scale, 6) << nl;
    }
    os  << '}' << nl << "face_indices{" << surface.size() << nl;
    for (const labelledTri& t : surface)
    {
        os  << '<' << t[0] << ',' << t[1] << ',' << t[2] << '>' << nl;
    }
    os  << '}' << nl
        << "texture { pigment { srgb " << povVector(colour_)
        << " } finish { ambient 0 emission 0.12 diffuse 0.7 } }" << nl
        << '}' << nl << nl;
}


// ************************************************************************* //
