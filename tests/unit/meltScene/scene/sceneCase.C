/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sceneCase.H"
#include "meltUnitTests.H"
#include "meltSph/mesh/hexMesh.H"
#include "OFstream.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::unitTest::sceneCase::sceneCase(const wordList& patchTypes)
{
    set
    (
        "system/fvSchemes",
        "ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {}"
        " interpolationSchemes {} snGradSchemes {}"
    );
    set("system/fvSolution", "");
    set("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);");
    setBoundary("U", "\".*\" { type noSlip; }");
    setBoundary("T", "\".*\" { type zeroGradient; }");
    setShapes(box("cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)"));

    boxMesh(labelVector(2, 2, 2), vector::one, patchTypes)->write();

    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                fvMesh::defaultRegion,
                runTime().timeName(),
                runTime(),
                IOobject::MUST_READ
            )
        )
    );
}


Foam::melt::unitTest::sceneCase::~sceneCase()
{
    mesh_.clear();

    for (const word& directory : {word("0"), word("constant"), word("system")})
    {
        rmDir(runTime().path()/directory);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::unitTest::sceneCase::set
(
    const fileName& file,
    const std::string& entries
) const
{
    const fileName path(runTime().path()/file);
    mkDir(path.path());

    const bool field = file.path() == "0";
    const word className
    (
        file == "constant/g" ? "uniformDimensionedVectorField"
      : file.name() == "U" && field ? "volVectorField"
      : file.name() == "T" && field ? "volScalarField"
      : "dictionary"
    );

    OFstream os(path);
    os  << "FoamFile { version 2.0; format ascii; class " << className
        << "; object " << file.name() << "; }" << nl << entries.c_str() << nl;
}


void Foam::melt::unitTest::sceneCase::setBoundary
(
    const word& field,
    const std::string& patches
) const
{
    set("0"/field, "boundaryField\n{\n" + patches + "\n}");
}


void Foam::melt::unitTest::sceneCase::setShapes(const std::string& shapes) const
{
    set
    (
        "constant/meltProperties",
        "shapes\n{\n" + shapes + "\n}\n" + material()
    );
}


void Foam::melt::unitTest::sceneCase::setMaterial
(
    const std::string& entries
) const
{
    set
    (
        "constant/meltProperties",
        "shapes\n{\n" + box("cube", "(0.3 0.3 0)", "(0.7 0.7 0.4)") + "\n}\n"
      + entries
    );
}


std::string Foam::melt::unitTest::sceneCase::box
(
    const std::string& name,
    const std::string& a,
    const std::string& b,
    const std::string& T
)
{
    return
        name + " { type box; min " + a + "; max " + b + "; T " + T + " }\n";
}


std::string Foam::melt::unitTest::sceneCase::material(const std::string& thermo)
{
    return
        "material { thermo { rho 1000; Cp 2000; kappa 0.2; solidus 330;"
        " TMin 280; TMax 400; " + thermo + " }"
        " rheology { type Newtonian; eta 10; } }\n";
}


// ************************************************************************* //
