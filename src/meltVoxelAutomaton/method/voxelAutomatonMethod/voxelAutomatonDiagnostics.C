/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelAutomatonMethod.H"
#include "meltExtent.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

//- Calls action(mass [units], energy [units], T, x, y, z) for all melt
template<class Action>
void forAllMelt(const voxelGrid& grid, const Action& action)
{
    const std::array<int, 3>& nb = grid.nBricks();
    for (int index = 0; index < nb[0]*nb[1]*nb[2]; ++index)
    {
        const voxelBrick& b = grid.brick(index);
        if (b.nLiquid + b.nSolid)
        {
            const std::array<int, 3> o = grid.origin(index);
            for (int i = 0; i < voxelBrick::size; ++i)
            {
                if (b.mass[i] > 0)
                {
                    action
                    (
                        b.mass[i],
                        b.energy[i],
                        b.T[i],
                        o[0] + (i >> 6),
                        o[1] + ((i >> 3) & 7),
                        o[2] + (i & 7)
                    );
                }
            }
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::melt::voxelAutomatonMethod::nVoxels
(
    const bool liquid,
    const bool solid
) const
{
    label n = 0;
    const std::array<int, 3>& nb = grid_.nBricks();
    for (int index = 0; index < nb[0]*nb[1]*nb[2]; ++index)
    {
        const voxelBrick& b = grid_.brick(index);
        n += (liquid ? b.nLiquid : 0) + (solid ? b.nSolid : 0);
    }
    return n;
}


Foam::label Foam::melt::voxelAutomatonMethod::nBricks() const
{
    label n = 0;
    const std::array<int, 3>& nb = grid_.nBricks();
    for (int index = 0; index < nb[0]*nb[1]*nb[2]; ++index)
    {
        n += grid_.allocated(index);
    }
    return n;
}


Foam::point Foam::melt::voxelAutomatonMethod::centreOfMass() const
{
    // In whole numbers of half voxels: exact in any order
    std::int64_t mass = 0;
    scalar sum[3] = {0, 0, 0};
    forAllMelt
    (
        grid_,
        [&](const std::int32_t m, std::int64_t, double, int x, int y, int z)
        {
            mass += m;
            sum[0] += m*(x + 0.5);
            sum[1] += m*(y + 0.5);
            sum[2] += m*(z + 0.5);
        }
    );
    const scalar total = max(scalar(mass), scalar(1));
    return frame_.position(sum[0]/total, sum[1]/total, sum[2]/total);
}


Foam::scalar Foam::melt::voxelAutomatonMethod::potentialEnergy() const
{
    return
       -grid_.totalMass()*grid_.material().massUnit
       *(scene_.g() & centreOfMass());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::meltDiagnostics
Foam::melt::voxelAutomatonMethod::diagnostics() const
{
    const voxelMaterial& material = grid_.material();
    meltDiagnostics d;

    d.mass = grid_.totalMass()*material.massUnit;
    d.volume = d.mass/material.rho;
    d.centreOfMass = centreOfMass();
    d.thermalEnergy = grid_.totalEnergy()*material.energyUnit;
    d.potentialEnergy = potentialEnergy();
    d.workOfGravity = initialPotentialEnergy_ - d.potentialEnergy;
    d.heatIn = heating_->account.in*material.energyUnit;
    d.heatOut = heating_->account.out*material.energyUnit;
    d.maxU = published_
      ? 0 : max(lubrication_.maxSpeed(), gravity_.maxSpeed());
    for (const looseSolids::falling& f : loose_.inFlight())
    {
        d.maxU = max(d.maxU, f.speed);
    }

    // A film is seen where it is thicker than 1/1000 voxel; that of a few
    // units of mass has a temperature of a few units of enthalpy
    constexpr scalar seen = 0.001;
    scalar liquid = 0;
    d.minT = GREAT;
    d.maxT = -GREAT;
    forAllMelt
    (
        grid_,
        [&]
        (
            const std::int32_t m,
            const std::int64_t energy,
            const double T,
            int,
            int,
            int
        )
        {
            liquid += m*material.curve.liquidFraction(material.h(m, energy));
            if (m >= seen*voxelMaterial::full)
            {
                d.minT = min(d.minT, T);
                d.maxT = max(d.maxT, T);
            }
        }
    );
    if (d.mass > 0)
    {
        d.meltedFraction = liquid*material.massUnit/d.mass;
    }
    const std::array<double, 3> centre = frame_.coordinates(initialCentre_);
    const meltExtent extent(grid_, {centre[0], centre[1]}, seen);
    const std::array<double, 3>& low = extent.low;
    const std::array<double, 3>& high = extent.high;
    if (high[2] > low[2])
    {
        d.bounds = boundBox
        (
            pointField
            ({
                frame_.position(low[0], low[1], low[2]),
                frame_.position(high[0], high[1], high[2])
            }),
            false
        );
        d.height = (high[2] - low[2])*frame_.dx();
        d.frontRadius = extent.radius*frame_.dx();
    }
    else
    {
        d.minT = d.maxT = 0;
    }
    return d;
}


void Foam::melt::voxelAutomatonMethod::report(Ostream& os) const
{
    const voxelMaterial& material = grid_.material();
    const std::int64_t massError =
        grid_.totalMass() + lostMass() - vents_.mass - initialMass_;
    const std::int64_t energyError =
        grid_.totalEnergy() + lostEnergy() - vents_.energy
      - heating_->account.in + heating_->account.out - initialEnergy_;

    os  << "Voxels: " << nVoxels(true, false) << " liquid, "
        << nVoxels(false, true) << " solid, pieces falling "
        << label(loose_.inFlight().size()) << ", "
        << grid_.bytes()/1e6 << " MB" << nl
        << "     mass error " << massError*material.massUnit
        << " kg, energy error " << energyError*material.energyUnit
        << " J, from vents " << vents_.mass*material.massUnit
        << " kg, escaped " << lostMass()*material.massUnit << " kg" << nl
        << "     ms a step:";
    for (std::size_t i = 0; i < times_.names.size(); ++i)
    {
        os  << ' ' << times_.names[i] << ' '
            << 1e3*times_.seconds[i]/max(nSteps_, 1);
    }
    os  << nl;
}

// ************************************************************************* //
