/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelAutomatonMethod.H"
#include "effectTimes.H"
#include "fvMesh.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::melt::voxelAutomatonMethod::conductionLimit() const
{
    return conduction_ ? conduction_->maxDeltaT(grid_) : GREAT;
}


Foam::scalar Foam::melt::voxelAutomatonMethod::heatLimit() const
{
    return min
    (
        heatInterval_*conductionLimit(),
        heatChange_/max(heating_->account.fastest, VSMALL)
    );
}


void Foam::melt::voxelAutomatonMethod::exchangeHeat()
{
    heating_->update();

    // What is written is up to date
    if (heatTime_ < heatLimit() && !mesh_.time().writeTime())
    {
        return;
    }
    const label n = max(label(std::ceil(heatTime_/conductionLimit())), 1);
    const scalar dt = heatTime_/n;
    const scalar start = mesh_.time().value() - heatTime_;
    for (label i = 0; i < n; ++i)
    {
        {
            const effectTimes::part timing("heatSources", "heatSources");
            heating_->heat(grid_, start + (i + 0.5)*dt, dt);
        }
        if (conduction_)
        {
            const effectTimes::part timing("heatConduction", "heatConduction");
            conduction_->conduct(grid_, dt);
        }
    }
    heatTime_ = 0;
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::voxelAutomatonMethod::maxDeltaT() const
{
    if (maxDeltaT_ > 0)
    {
        return maxDeltaT_;
    }

    if (published_)
    {
        maxDeltaT_ = stepTime_;
        limit_ = "stepTime";
        return maxDeltaT_;
    }

    maxDeltaT_ = GREAT;
    limit_ = "none";
    const auto limit = [&](const scalar deltaT, const word& name)
    {
        if (deltaT < maxDeltaT_)
        {
            maxDeltaT_ = deltaT;
            limit_ = name;
        }
    };

    times_.run
    (
        stageTimes::SPREADING,
        [&]
        {
            const effectTimes::part timing(effectTimes::flow, "spreading");
            limit(lubrication_.prepare(grid_), "lubrication");
        }
    );
    if
    (
        nVoxels(true, false) || !loose_.inFlight().empty() || vents_.active()
    )
    {
        limit(gravity_.maxDeltaT(grid_), "gravity");
    }
    else
    {
        limit
        (
            heating_->account.fastest < VGREAT
          ? heatLimit() : heatInterval_*conductionLimit(),
            "heat"
        );
    }
    return maxDeltaT_;
}


Foam::word Foam::melt::voxelAutomatonMethod::deltaTLimit() const
{
    maxDeltaT();
    return limit_;
}


void Foam::melt::voxelAutomatonMethod::advance(const scalar deltaT)
{
    maxDeltaT();
    particleSteps_ += nVoxels(true, true);
    ++nSteps_;

    times_.run
    (
        stageTimes::SPREADING,
        [&]
        {
            const effectTimes::part timing(effectTimes::flow, "spreading");
            published_
          ? published_->spread(grid_) : lubrication_.spread(grid_, deltaT);
        }
    );
    times_.run
    (
        stageTimes::FALLING,
        [&]
        {
            const effectTimes::part timing(effectTimes::flow, "falling");
            published_
          ? published_->fall(grid_) : gravity_.fall(grid_, deltaT);
        }
    );
    if (scene_.effects()("rigidSolids"))
    {
        times_.run
        (
            stageTimes::SOLIDS,
            [&]
            {
                const effectTimes::part timing("rigidSolids", "looseSolids");
                loose_.fall(grid_, deltaT);
            }
        );
    }
    if (vents_.active())
    {
        times_.run
        (
            stageTimes::VENTS,
            [&]
            {
                const effectTimes::part timing(effectTimes::flow, "vents");
                vents_.flow(grid_, mesh_.time().value(), deltaT);
            }
        );
    }
    heatTime_ += deltaT;
    times_.run(stageTimes::HEAT, [&] { exchangeHeat(); });

    maxDeltaT_ = 0;
}

// ************************************************************************* //
