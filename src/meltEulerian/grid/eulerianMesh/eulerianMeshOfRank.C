/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMesh.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::eulerianMesh::makeMesh()
{
    const fvMesh& domain = scene_.mesh();
    const Time& time = domain.time();
    List<gridFace> onGrid;
    meshLayout layout(whole(onGrid));
    const labelList startInWhole(layout.patchStart);
    if (Pstream::parRun())
    {
        if (Pstream::master())
        {
            layout.writeWhole
            (
                time,
                time.globalPath()/time.constant()/regionName
               /polyMesh::meshSubDir,
                domain.boundaryMesh()
            );
        }
        DynamicList<label> rank(layout.owner.size());
        for (const label r : cellRank_)
        {
            if (r >= 0)
            {
                rank.append(r);
            }
        }
        layout = layout.part(rank, Pstream::myProcNo());
    }

    gridFaces_.setSize(layout.faces.size());
    forAll(gridFaces_, facei)
    {
        const label inWhole =
            layout.faceInWhole.size() ? layout.faceInWhole[facei] : facei + 1;
        gridFaces_[facei] = onGrid[mag(inWhole) - 1];
        gridFaces_[facei].sign *= sign(inWhole);
    }
    domainFace_.setSize(layout.patchSize.size());
    forAll(domainFace_, patchi)
    {
        if (patchi >= patchFaces_.size())
        {
            continue;
        }
        domainFace_[patchi].setSize(layout.patchSize[patchi]);
        forAll(domainFace_[patchi], i)
        {
            const label facei = layout.patchStart[patchi] + i;
            const label inWhole =
                layout.faceInWhole.size()
              ? layout.faceInWhole[facei] - 1 : facei;
            domainFace_[patchi][i] =
                patchFaces_[patchi][inWhole - startInWhole[patchi]].domainFace;
        }
    }

    mesh_ = layout.mesh
    (
        IOobject
        (
            regionName,
            time.constant(),
            time,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        domain.boundaryMesh()
    );

    // What is made is not read; schemes and solvers are
    fvSchemes& schemes = *mesh_;
    schemes.readOpt() = IOobject::MUST_READ;
    schemes.read();
    fvSolution& solution = *mesh_;
    solution.readOpt() = IOobject::MUST_READ;
    solution.read();

    // Written once
    mesh_->polyMesh::write();
    if (Pstream::parRun())
    {
        layout.writeAddressing(*mesh_);
    }
    HashTable<regIOobject*> parts(mesh_->lookupClass<regIOobject>());
    forAllIters(parts, part)
    {
        part.val()->writeOpt() = IOobject::NO_WRITE;
    }
}

// ************************************************************************* //
