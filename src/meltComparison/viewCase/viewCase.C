/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viewCase.H"
#include "IFstream.H"
#include "IOField.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "passiveParticleCloud.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::viewCase::writeCloud(const caseResults& results) const
{
    // A cloud is in the mesh of the domain; written there, then moved here
    const Time& time = results.mesh().time();
    autoPtr<polyMesh> domain;
    if (results.mesh().name() != polyMesh::defaultRegion)
    {
        domain.reset
        (
            new polyMesh
            (
                IOobject
                (
                    polyMesh::defaultRegion,
                    time.timeName(),
                    time,
                    IOobject::MUST_READ
                )
            )
        );
    }
    const polyMesh& mesh =
        domain.valid() ? *domain : static_cast<const polyMesh&>(results.mesh());
    const meltParcels parcels(results.parcels());
    const fileName cloudDir(time.timePath()/cloud::prefix/"melt");

    scalarField T, m;
    {
        passiveParticleCloud particles
        (
            mesh, "melt", IDLList<passiveParticle>()
        );
        forAll(parcels.box, i)
        {
            particles.addParticle
            (
                new passiveParticle(mesh, parcels.box[i].midpoint(), -1)
            );
            T.append(parcels.T[i]);
            m.append(parcels.volume[i]);
        }
        particles.write();
        const auto fieldIO = [&](const word& name)
        {
            return particles.fieldIOobject(name, IOobject::NO_READ);
        };
        IOField<scalar>(fieldIO("T"), T).write();

        // Of which m/rho is the volume
        IOField<scalar>(fieldIO("m"), m).write();
        IOField<scalar>(fieldIO("rho"), scalarField(m.size(), 1)).write();
    }

    const fileName target(dir_/time.timeName()/cloud::prefix/"melt");
    mkDir(target.path());
    mv(cloudDir, target);
    rmDir(cloudDir.path());
    rmDir(time.timePath()/"uniform"/cloud::prefix);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::viewCase::viewCase
(
    const fileName& directory,
    caseResults& results,
    const scalarList& times,
    const dictionary& pictures,
    const boundBox& box,
    const scalarMinMax& range
)
:
    dir_(directory),
    field_(pictures.lookupOrDefault<word>("field", "T")),
    representation_
    (
        pictures.lookupOrDefault<word>("representation", "surface")
    )
{
    if (isDir(dir_))
    {
        rmDir(dir_);
    }
    mkDir(dir_/"system");
    ln(results.dir()/"constant", dir_/"constant");
    cp(results.dir()/"system"/"controlDict", dir_/"system"/"controlDict");

    dictionary look;
    const fileName file(results.dir()/"system"/"meltToPovDict");
    if (isFile(file))
    {
        look = dictionary(IFstream(file)());
    }
    look.remove("FoamFile");

    const auto setDefault = []
    (
        dictionary& dict,
        const word& name,
        const auto& value
    )
    {
        if (!dict.found(name))
        {
            dict.add(name, value);
        }
    };
    dictionary camera(look.subOrEmptyDict("camera"));
    setDefault(camera, "width", 480);
    setDefault(camera, "height", 360);
    setDefault(camera, "box", box);
    look.set("camera", camera);
    if (field_ == "T")
    {
        dictionary colours(look.subOrEmptyDict("colours"));
        // At one temperature a kelvin around it
        const scalar margin = range.mag() < 1e-3 ? 0.5 : 0;
        setDefault
        (
            colours,
            "range",
            Pair<scalar>(range.min() - margin, range.max() + margin)
        );
        look.set("colours", colours);
    }

    OFstream os(dir_/"system"/"meltToPovDict");
    IOobject::writeBanner(os)
        << "FoamFile\n{\n    version 2.0;\n    format ascii;\n"
        << "    class dictionary;\n    object meltToPovDict;\n}\n";
    look.write(os, false);

    for (const scalar t : times)
    {
        results.setTime(t);
        const fileName path(results.mesh().time().timePath());
        if (isDir(path/cloud::prefix/"melt"))
        {
            ln(path, dir_/path.name());
        }
        else
        {
            writeCloud(results);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::viewCase::draw() const
{
    const fileName log(dir_/"log.meltFilm");
    const int status = Foam::system
    (
        "meltFilm -noFilm -case '" + dir_ + "' -field " + field_
      + " -representation " + representation_ + " > '" + log
      + "' 2>&1 < /dev/null"
    );
    if (status != 0)
    {
        FatalErrorInFunction
            << "meltFilm failed with status " << status << ", log " << log
            << exit(FatalError);
    }
}


Foam::fileName Foam::melt::viewCase::picture(const word& timeName) const
{
    return
        dir_/"postProcessing"/"meltToPov"
       /("melt_" + representation_ + '_' + field_)/(timeName + ".png");
}


// ************************************************************************* //
