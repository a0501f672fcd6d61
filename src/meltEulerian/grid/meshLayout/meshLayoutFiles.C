/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshLayout.H"
#include "faceIOList.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "pointIOField.H"
#include "polyBoundaryMesh.H"
#include "StringStream.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The header of a file that is not in the directory of this rank
IOobject ofWhole(const Time& time, const fileName& directory, const word& name)
{
    return IOobject
    (
        name,
        time.constant(),
        directory.path().name()/directory.name(),
        time,
        IOobject::NO_READ,
        IOobject::NO_WRITE,
        false
    );
}


template<class IOType, class Type>
void writeFile
(
    const Time& time,
    const fileName& directory,
    const word& name,
    const Type& content
)
{
    const IOType list(ofWhole(time, directory, name), content);
    OFstream os(directory/name, time.writeFormat());
    list.writeHeader(os);
    list.writeData(os);
    IOobject::writeEndDivider(os);
}


void writeAddress(const fvMesh& mesh, const word& name, const labelList& list)
{
    labelIOList
    (
        IOobject
        (
            name,
            mesh.time().constant(),
            polyMesh::meshSubDir,
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        list
    ).write();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::meshLayout::writeWhole
(
    const Time& time,
    const fileName& polyMesh,
    const polyBoundaryMesh& domainPatches
) const
{
    mkDir(polyMesh);
    writeFile<pointIOField>(time, polyMesh, "points", points);
    writeFile<faceIOList>(time, polyMesh, "faces", faces);
    writeFile<labelIOList>(time, polyMesh, "owner", owner);
    writeFile<labelIOList>(time, polyMesh, "neighbour", neighbour);

    OFstream os(polyMesh/"boundary");
    ofWhole(time, polyMesh, "boundary").writeHeader(os, "polyBoundaryMesh");
    os  << patchStart.size() << nl << token::BEGIN_LIST << nl << incrIndent;
    forAll(patchStart, patchi)
    {
        // The patch of the domain with the numbers of this mesh
        OStringStream text;
        domainPatches[patchi].write(text);
        dictionary dict(IStringStream(text.str())());
        dict.set("nFaces", patchSize[patchi]);
        dict.set("startFace", patchStart[patchi]);
        os  << indent << domainPatches[patchi].name() << dict;
    }
    os  << decrIndent << token::END_LIST << nl;
    IOobject::writeEndDivider(os);
}


void Foam::melt::meshLayout::writeAddressing(const fvMesh& mesh) const
{
    labelList patches(identity(patchStart.size()));
    for (label i = 1; i <= neighbourRank.size(); ++i)
    {
        patches[patches.size() - i] = -1;
    }
    writeAddress(mesh, "cellProcAddressing", cellInWhole);
    writeAddress(mesh, "faceProcAddressing", faceInWhole);
    writeAddress(mesh, "pointProcAddressing", pointInWhole);
    writeAddress(mesh, "boundaryProcAddressing", patches);
}

// ************************************************************************* //
