/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "domainMesh.H"
#include "blockMesh.H"
#include "emptyPolyPatch.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Pair.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::melt::domainMesh::makeIfMissing(Time& runTime)
{
    const fileName faces
    (
        runTime.constantPath()/polyMesh::meshSubDir/"faces"
    );

    if (isFile(faces))
    {
        return;
    }

    const IOobject dictIO
    (
        "blockMeshDict",
        runTime.system(),
        runTime,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (Pstream::parRun() || !isFile(dictIO.objectPath()))
    {
        FatalErrorInFunction
            << "The case has no mesh, " << faces << ", and "
            <<
            (
                Pstream::parRun()
              ? "it can only be made serially:"
                " run blockMesh and decomposePar first."
              : "no system/blockMeshDict to make it from."
            )
            << exit(FatalError);
    }

    const IOdictionary dict(dictIO);

    if (dict.lookupOrDefault("mergePatchPairs", List<Pair<word>>()).size())
    {
        FatalIOErrorInFunction(dict.lookup("mergePatchPairs"))
            << "Patches are merged by blockMesh only, run:" << nl
            << "    blockMesh -case " << runTime.globalPath()
            << exit(FatalIOError);
    }

    blockMesh blocks(dict, polyMesh::defaultRegion);

    polyMesh mesh
    (
        IOobject(polyMesh::defaultRegion, runTime.constant(), runTime),
        pointField(blocks.points()),
        blocks.cells(),
        blocks.patches(),
        blocks.patchNames(),
        blocks.patchDicts(),
        "defaultFaces",
        emptyPolyPatch::typeName
    );

    // As many digits as blockMesh
    const auto precision = IOstream::defaultPrecision(10);

    if (!mesh.write())
    {
        FatalErrorInFunction
            << "Cannot write " << faces.path() << exit(FatalError);
    }

    IOstream::defaultPrecision(precision);

    Info<< "Made the mesh of the domain: " << mesh.nCells() << " cells, "
        << mesh.bounds() << " m" << nl << endl;
}


// ************************************************************************* //
