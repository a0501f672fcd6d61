/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    cloudIOTest

Description
    Writes a cloud of random particles, or reads it again.

Usage
    \verbatim
    cloudIOTest -create 1000    write, at the start time
    cloudIOTest -restart        read at the start time, write one step later
    cloudIOTest                 print count and sums, as OpenFOAM reads them
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Cloud.H"
#include "IOField.H"
#include "passiveParticle.H"
#include "sphCloud.H"
#include "Time.H"

#include <algorithm>
#include <numeric>
#include <random>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

struct arrays
{
    std::vector<double> x, y, z, u, v, w, T;
    std::vector<int> id;

    void fill(const label n)
    {
        std::mt19937_64 generator(1);
        std::uniform_real_distribution<double> uniform(0, 1);

        for (std::vector<double>* a : {&x, &y, &z, &u, &v, &w, &T})
        {
            a->resize(n);
            std::generate
            (
                a->begin(), a->end(), [&] { return uniform(generator); }
            );
        }
        id.resize(n);
        std::iota(id.begin(), id.end(), 0);

        // Two outside of the domain
        z[0] = -0.1;
        x[1] = 1.2;
    }

    void bindTo(melt::sphCloud& cloud)
    {
        cloud.addVector("U", u, v, w);
        cloud.addScalar("T", T);
        cloud.addLabel("origId", id);
    }
};


template<class Type>
void printSum(const Cloud<passiveParticle>& cloud, const word& name)
{
    const IOField<Type> field
    (
        IOobject(name, cloud.time().timeName(), cloud, IOobject::MUST_READ)
    );
    Info<< name << ' ' << sum(field) << nl;
}


void printSums(const polyMesh& mesh)
{
    const Cloud<passiveParticle> cloud(mesh, "melt", false);

    label outsideCell = 0;
    vector position = Zero;
    for (const passiveParticle& p : cloud)
    {
        outsideCell += !mesh.pointInCell(p.position(), p.cell());
        position += p.position();
    }

    Info<< "count " << cloud.size() << nl
        << "outside " << outsideCell << nl
        << "position " << position << nl;
    printSum<vector>(cloud, "U");
    printSum<scalar>(cloud, "T");
    printSum<label>(cloud, "origId");
}


int main(int argc, char* argv[])
{
    argList::addOption("create", "count", "Write so many particles");
    argList::addBoolOption("restart", "Read, and write one step later");
    argList::noBanner();
    const argList args(argc, argv);
    Time runTime(Time::controlDictName, args);
    IOstream::defaultPrecision(17);
    Sout.precision(17);

    const polyMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime.constant(),
            runTime,
            IOobject::MUST_READ
        )
    );

    if (!args.found("create") && !args.found("restart"))
    {
        printSums(mesh);
        return 0;
    }

    arrays a;
    melt::sphCloud cloud(mesh, "melt", a.x, a.y, a.z);
    a.bindTo(cloud);

    if (args.found("create"))
    {
        a.fill(args.get<label>("create"));
        runTime.writeNow();
        Info<< "outside " << cloud.outside() << nl;
    }
    else
    {
        cloud.read();
        ++runTime;
        runTime.writeNow();
    }

    return 0;
}


// ************************************************************************* //
