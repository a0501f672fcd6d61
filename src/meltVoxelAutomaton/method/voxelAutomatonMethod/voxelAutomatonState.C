/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelAutomatonMethod.H"
#include "voxelFiles.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::int64_t Foam::melt::voxelAutomatonMethod::lostMass() const
{
    return
        earlierLostMass_ + lubrication_.lostMass() + gravity_.lostMass()
      + (published_ ? published_->lostMass() : 0);
}


std::int64_t Foam::melt::voxelAutomatonMethod::lostEnergy() const
{
    return
        earlierLostEnergy_ + lubrication_.lostEnergy() + gravity_.lostEnergy()
      + (published_ ? published_->lostEnergy() : 0);
}


Foam::scalarField Foam::melt::voxelAutomatonMethod::sums() const
{
    using voxelFiles::append;

    scalarField list;
    for
    (
        const std::int64_t value
      : {
            initialMass_,
            initialEnergy_,
            lostMass(),
            lostEnergy(),
            grid_.residual(),
            heating_->account.in,
            heating_->account.out,
            vents_.mass,
            vents_.energy,
            published_ ? published_->step() : 0
        }
    )
    {
        append(list, value);
    }
    for (direction k = 0; k < 3; ++k)
    {
        list.append(initialCentre_[k]);
    }
    list.append(initialPotentialEnergy_);
    list.append(heatTime_);
    list.append(heating_->account.fastest);
    list.append(loose_.waiting());
    list.append(loose_.loose() || grid_.solidsChanged());

    list.append(scalar(vents_.waiting.size()));
    list.append(vents_.waiting);

    for (const looseSolids::falling& f : loose_.inFlight())
    {
        list.append(f.x);
        list.append(f.y);
        list.append(f.z);
        list.append(f.speed);
        list.append(f.way);
    }
    return list;
}


void Foam::melt::voxelAutomatonMethod::setSums(const scalarField& list)
{
    using voxelFiles::take;

    label i = 0;
    initialMass_ = take(list, i);
    initialEnergy_ = take(list, i);
    earlierLostMass_ = take(list, i);
    earlierLostEnergy_ = take(list, i);
    grid_.setResidual(take(list, i));
    heating_->account.in = take(list, i);
    heating_->account.out = take(list, i);
    vents_.mass = take(list, i);
    vents_.energy = take(list, i);
    const std::int64_t step = take(list, i);
    if (published_)
    {
        published_->step() = step;
    }
    for (direction k = 0; k < 3; ++k)
    {
        initialCentre_[k] = list[i++];
    }
    initialPotentialEnergy_ = list[i++];
    heatTime_ = list[i++];
    heating_->account.fastest = list[i++];
    loose_.waiting() = list[i++];
    grid_.takeSolidsChanged();
    loose_.loose() = list[i++] > 0;

    const label nVents = label(list[i++]);
    vents_.waiting = scalarField::subField(list, nVents, i);
    i += nVents;

    for (; i < list.size(); i += 5)
    {
        loose_.inFlight().push_back
        ({
            int(list[i]),
            int(list[i + 1]),
            int(list[i + 2]),
            list[i + 3],
            list[i + 4]
        });
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::voxelAutomatonMethod::write()
{
    voxelFiles::write(mesh_, grid_, sums());
    if (published_)
    {
        voxelFiles::writeEnergies(mesh_, published_->energy());
    }
    voxelFiles::writeCloud(mesh_, frame_, grid_);
    updateDensity();
    voxelFiles::writeDensity(mesh_, frame_, grid_, density_);
}


Foam::label Foam::melt::voxelAutomatonMethod::updateDensity()
{
    label n = 0;
    times_.run(stageTimes::DENSITY, [&] { n = density_.update(grid_); });
    return n;
}

// ************************************************************************* //
