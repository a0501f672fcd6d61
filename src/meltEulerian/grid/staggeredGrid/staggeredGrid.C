/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "staggeredGrid.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::staggeredGrid::staggeredGrid
(
    const triple& n,
    const std::array<double, 3>& d,
    const std::array<bool, 3>& solved,
    const std::array<bool, 3>& periodic
)
:
    n_(n),
    d_(d),
    solved_(solved),
    periodic_(periodic)
{
    for (int a = 0; a < 3; ++a)
    {
        walls_[a].assign(nFaces(a), condition::noSlip);
    }
    setBlocked(std::vector<char>(nCells(), 0));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::staggeredGrid::setWall
(
    const int a,
    const int face,
    const condition c,
    const std::array<double, 3>& velocity
)
{
    walls_[a][face] = c;
    if (velocity != std::array<double, 3>{0, 0, 0})
    {
        if (wallVelocity_[a].empty())
        {
            wallVelocity_[a].assign(nFaces(a), {0, 0, 0});
        }
        wallVelocity_[a][face] = velocity;
    }
}


void Foam::melt::staggeredGrid::setBlocked(const std::vector<char>& blocked)
{
    blocked_ = blocked;
    faces_ = walls_;
    for (int a = 0; a < 3; ++a)
    {
        triple c;
        for (c[2] = 0; c[2] < n_[2]; ++c[2])
        {
            for (c[1] = 0; c[1] < n_[1]; ++c[1])
            {
                for (c[0] = 0; c[0] < n_[0]; ++c[0])
                {
                    triple lower(c);
                    --lower[a];
                    if
                    (
                        inside(lower)
                     && !blocked_[cell(c)]
                     && !blocked_[cell(lower)]
                    )
                    {
                        faces_[a][face(a, c)] = condition::interior;
                    }
                }
            }
        }
    }
}

// ************************************************************************* //
