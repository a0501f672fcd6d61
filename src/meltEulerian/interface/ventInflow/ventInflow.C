/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ventInflow.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Direction that gravity is along most; z without gravity
label verticalAxis(const vector& g)
{
    return mag(g) > 0 ? findMax(cmptMag(g)) : vector::Z;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<Foam::melt::staggeredGrid::triple>
Foam::melt::ventInflow::columns(const vent& v) const
{
    if (!mesh_.box().contains(v.position()))
    {
        FatalIOErrorInFunction(v.dict())
            << "Vent " << v.name() << " at " << v.position()
            << " is not in the domain " << mesh_.box() << exit(FatalIOError);
    }

    // The column that the centre is in at least
    const staggeredGrid& grid = mesh_.grid();
    const staggeredGrid::triple centre
    (
        grid.position(mesh_.cellAt(v.position()))
    );
    std::vector<staggeredGrid::triple> result;
    const int b = (axis_ + 1) % 3, c = (axis_ + 2) % 3;
    staggeredGrid::triple at(centre);
    for (at[c] = 0; at[c] < grid.n()[c]; ++at[c])
    {
        for (at[b] = 0; at[b] < grid.n()[b]; ++at[b])
        {
            scalar distance = 0;
            for (const int k : {b, c})
            {
                distance +=
                    grid.solved(k)
                  ? sqr
                    (
                        mesh_.box().min()[k] + (at[k] + 0.5)*grid.d()[k]
                      - v.position()[k]
                    )
                  : 0;
            }
            if (distance <= sqr(v.radius()) || at == centre)
            {
                result.push_back(at);
            }
        }
    }
    return result;
}


Foam::scalar Foam::melt::ventInflow::put
(
    staggeredGrid::triple at,
    scalar volume,
    const scalar h,
    std::vector<double>& alpha,
    std::vector<double>& alphaH
)
{
    const staggeredGrid& grid = mesh_.grid();
    bool begun = false;
    for (; volume > 0 && grid.inside(at); at[axis_] += up_)
    {
        const int cell = grid.cell(at);
        if (!mesh_.has(cell))
        {
            if (begun)
            {
                break;
            }
            continue;
        }
        begun = true;
        const scalar part = min(volume, max(1 - alpha[cell], scalar(0)));
        alpha[cell] += part;
        alphaH[cell] += part*h;
        volume_ += part*grid.volume();
        volumeH_ += part*h*grid.volume();
        volume -= part;
    }
    return volume;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::ventInflow::ventInflow
(
    const eulerianMesh& mesh,
    const meltThermo& thermo,
    const vector& g,
    const dictionary& meltProperties
)
:
    mesh_(mesh),
    thermo_(thermo),
    axis_(verticalAxis(g)),
    up_(g[axis_] > 0 ? -1 : 1),
    vents_(meltProperties),
    waiting_(vents_.size(), 0)
{
    for (const vent& v : vents_)
    {
        columns(v);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::ventInflow::flow
(
    const scalar time,
    const scalar deltaT,
    scalarField& alpha,
    scalarField& alphaH
)
{
    if (vents_.update())
    {
        waiting_.resize(vents_.size(), 0);
    }
    if (!active())
    {
        return;
    }
    const scalar cellVolume = mesh_.grid().volume();
    std::vector<double> alphaOnGrid(mesh_.onGrid(alpha));
    std::vector<double> alphaHOnGrid(mesh_.onGrid(alphaH));
    forAll(vents_, venti)
    {
        const vent& v = vents_[venti];
        waiting_[venti] += v.rate(time)*deltaT/thermo_.rho();
        const std::vector<staggeredGrid::triple> from(columns(v));
        const scalar share = waiting_[venti]/(from.size()*cellVolume);
        scalar refused = 0;
        for (const staggeredGrid::triple& column : from)
        {
            refused += put
            (
                column,
                share,
                thermo_.enthalpy().h(v.T()),
                alphaOnGrid,
                alphaHOnGrid
            );
        }
        waiting_[venti] = refused*cellVolume;
    }
    alpha = mesh_.onMesh(alphaOnGrid);
    alphaH = mesh_.onMesh(alphaHOnGrid);
}


Foam::scalarList Foam::melt::ventInflow::state() const
{
    DynamicList<scalar> list;
    if (active() || volume_ > 0)
    {
        list.append(volume_);
        list.append(volumeH_);
        list.append(waiting_);
    }
    return scalarList(list);
}


void Foam::melt::ventInflow::setState(const UList<scalar>& state)
{
    // Vents may have changed since
    if (state.size() > 1)
    {
        volume_ = state[0];
        volumeH_ = state[1];
        for (label i = 0; i < min(waiting_.size(), state.size() - 2); ++i)
        {
            waiting_[i] = state[i + 2];
        }
    }
}

// ************************************************************************* //
