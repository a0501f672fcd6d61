/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voxelFiles.H"
#include "IOField.H"
#include "passiveParticleCloud.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

IOobject stateIO
(
    const fvMesh& mesh,
    const word& name,
    const IOobject::readOption r
)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        "voxelAutomaton",
        mesh,
        r,
        IOobject::NO_WRITE,
        false
    );
}


template<class Type>
void writeState
(
    const fvMesh& mesh,
    const word& name,
    const Field<Type>& values
)
{
    IOField<Type>(stateIO(mesh, name, IOobject::NO_READ), values).writeObject
    (
        IOstream::BINARY,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}


template<class Type>
Field<Type> readState(const fvMesh& mesh, const word& name)
{
    return IOField<Type>(stateIO(mesh, name, IOobject::MUST_READ));
}


//- Calls action(brick, index in it, x, y, z) for each voxel with melt
template<class Action>
void forAllMelt(const voxelGrid& grid, const Action& action)
{
    const std::array<int, 3>& nb = grid.nBricks();
    for (int index = 0; index < nb[0]*nb[1]*nb[2]; ++index)
    {
        const voxelBrick& b = grid.brick(index);
        const std::array<int, 3> o = grid.origin(index);
        for (int i = 0; b.nLiquid + b.nSolid && i < voxelBrick::size; ++i)
        {
            if (b.mass[i] > 0)
            {
                action
                (
                    b,
                    i,
                    o[0] + (i >> 6),
                    o[1] + ((i >> 3) & 7),
                    o[2] + (i & 7)
                );
            }
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::voxelFiles::append
(
    scalarField& list,
    const std::int64_t value
)
{
    list.append(scalar(value >> 32));
    list.append(scalar(value & 0xffffffff));
}


std::int64_t Foam::melt::voxelFiles::take
(
    const scalarField& list,
    label& place
)
{
    const auto high = std::int64_t(list[place++]);
    const auto low = std::int64_t(list[place++]);
    return high*(std::int64_t(1) << 32) + low;
}


bool Foam::melt::voxelFiles::found(const fvMesh& mesh)
{
    return stateIO(mesh, "mass", IOobject::MUST_READ)
        .typeHeaderOk<IOField<scalar>>(true);
}


void Foam::melt::voxelFiles::write
(
    const fvMesh& mesh,
    const voxelGrid& grid,
    const scalarField& sums
)
{
    DynamicList<label> voxel;
    DynamicList<scalar> mass, energy;
    forAllMelt
    (
        grid,
        [&](const voxelBrick& b, const int i, int x, int y, int z)
        {
            voxel.append(x + grid.n()[0]*(y + grid.n()[1]*z));
            mass.append(b.mass[i]);
            // Below 2^53, so exact
            energy.append(scalar(b.energy[i]));
        }
    );
    writeState(mesh, "voxel", labelField(voxel));
    writeState(mesh, "mass", scalarField(mass));
    writeState(mesh, "energy", scalarField(energy));
    writeState(mesh, "sums", sums);
}


Foam::scalarField Foam::melt::voxelFiles::read
(
    const fvMesh& mesh,
    voxelGrid& grid
)
{
    const labelField voxel(readState<label>(mesh, "voxel"));
    const scalarField mass(readState<scalar>(mesh, "mass"));
    const scalarField energy(readState<scalar>(mesh, "energy"));

    forAll(voxel, i)
    {
        const int row = voxel[i]/grid.n()[0];
        const int x = voxel[i] % grid.n()[0];
        const int y = row % grid.n()[1];
        const int z = row/grid.n()[1];
        if (!grid.inside(x, y, z) || grid.capacity(x, y, z) < mass[i])
        {
            FatalErrorInFunction
                << "Voxel " << voxel[i] << " in "
                << stateIO(mesh, "voxel", IOobject::NO_READ).objectPath()
                << " has no place in the grid: domain, resolution or terrain"
                << " have changed" << exit(FatalError);
        }
        voxelBrick& b = grid.ownAt(x, y, z);
        const int j = voxelBrick::offset(x, y, z);
        b.mass[j] = std::int32_t(mass[i]);
        b.energy[j] = std::int64_t(energy[i]);
        b.changed = true;
    }
    grid.refresh();
    return readState<scalar>(mesh, "sums");
}


void Foam::melt::voxelFiles::writeEnergies
(
    const fvMesh& mesh,
    const std::vector<std::vector<std::int32_t>>& energy
)
{
    DynamicList<label> values;
    for (std::size_t brick = 0; brick < energy.size(); ++brick)
    {
        if (!energy[brick].empty())
        {
            values.append(label(brick));
            for (const std::int32_t value : energy[brick])
            {
                values.append(value);
            }
        }
    }
    writeState(mesh, "Energy", labelField(values));
}


void Foam::melt::voxelFiles::readEnergies
(
    const fvMesh& mesh,
    std::vector<std::vector<std::int32_t>>& energy
)
{
    const labelField values(readState<label>(mesh, "Energy"));
    for (label i = 0; i < values.size(); i += 1 + voxelBrick::size)
    {
        energy.resize(max(energy.size(), std::size_t(values[i] + 1)));
        energy[values[i]].assign
        (
            values.begin() + i + 1, values.begin() + i + 1 + voxelBrick::size
        );
    }
}


void Foam::melt::voxelFiles::writeDensity
(
    const fvMesh& mesh,
    const voxelFrame& frame,
    const voxelGrid& grid,
    const densityField& density
)
{
    const point a(frame.position(0.5, 0.5, 0.5));
    const point b
    (
        frame.position(grid.n()[0] - 0.5, grid.n()[1] - 0.5, grid.n()[2] - 0.5)
    );
    const point origin(min(a, b));

    DynamicList<label> voxels;
    DynamicList<scalar> values;
    const std::array<int, 3>& nb = grid.nBricks();
    for (int index = 0; index < nb[0]*nb[1]*nb[2]; ++index)
    {
        const densityField::values* brick = density.brick(index);
        const std::array<int, 3> o = grid.origin(index);
        for (int i = 0; brick && i < voxelBrick::size; ++i)
        {
            if ((*brick)[i] > 0)
            {
                const vector v
                (
                    frame.position
                    (
                        o[0] + (i >> 6) + 0.5,
                        o[1] + ((i >> 3) & 7) + 0.5,
                        o[2] + (i & 7) + 0.5
                    )
                  - origin
                );
                for (direction k = 0; k < 3; ++k)
                {
                    voxels.append(label(std::lround(v[k]/frame.dx())));
                }
                values.append((*brick)[i]);
            }
        }
    }
    writeState(mesh, "density", scalarField(values));
    writeState(mesh, "densityVoxels", labelField(voxels));
    writeState
    (
        mesh,
        "densityGrid",
        vectorField({origin, vector::uniform(frame.dx())})
    );
}


void Foam::melt::voxelFiles::writeCloud
(
    const fvMesh& mesh,
    const voxelFrame& frame,
    const voxelGrid& grid
)
{
    // Numbers of the particles that a restart makes alike
    particle::particleCount_ = 0;

    passiveParticleCloud cloud(mesh, "melt", IDLList<passiveParticle>());
    DynamicList<scalar> T, m, rho;
    DynamicList<label> phase;
    const voxelMaterial& material = grid.material();

    forAllMelt
    (
        grid,
        [&](const voxelBrick& b, const int i, int x, int y, int z)
        {
            // A voxel may stand out of the domain by less than its edge
            const point p
            (
                min
                (
                    max
                    (
                        frame.position(x + 0.5, y + 0.5, z + 0.5),
                        mesh.bounds().min()
                    ),
                    mesh.bounds().max()
                )
            );
            cloud.addParticle(new passiveParticle(mesh, p, -1));
            T.append(b.T[i]);
            m.append(b.mass[i]*material.massUnit);
            rho.append(material.rho);
            phase.append(b.phase[i]);
        }
    );

    const auto fieldIO = [&](const word& name)
    {
        return cloud.fieldIOobject(name, IOobject::NO_READ);
    };
    cloud.writeObject
    (
        mesh.time().writeFormat(),
        IOstream::currentVersion,
        mesh.time().writeCompression(),
        true
    );
    IOField<scalar>(fieldIO("T"), T).write();
    IOField<scalar>(fieldIO("m"), m).write();
    IOField<scalar>(fieldIO("rho"), rho).write();
    IOField<label>(fieldIO("phase"), phase).write();
}

// ************************************************************************* //
