/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphCloudFields.H"
#include "cellLocations.H"
#include "cloudFile.H"
#include "IOdictionary.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

namespace
{
    // Entries of the files as particle::writePosition and writeCoordinates
    // have them: numbers in ascii, a bracketed block of bytes in binary

    void writeRaw(Ostream& os, const void* data, const std::size_t nBytes)
    {
        os.writeRaw(static_cast<const char*>(data), nBytes);
    }


    void streamPositions
    (
        Ostream& os,
        const pointField& points,
        const cellLocations& in
    )
    {
        const bool ascii = (os.format() == IOstream::ASCII);

        os << points.size() << nl << token::BEGIN_LIST << nl;

        forAll(points, i)
        {
            if (ascii)
            {
                os << points[i] << token::SPACE << in.cell[i];
            }
            else
            {
                os.beginRawWrite(sizeof(point) + sizeof(label));
                writeRaw(os, &points[i], sizeof(point));
                writeRaw(os, &in.cell[i], sizeof(label));
                os.endRawWrite();
            }
            os << nl;
        }

        os << token::END_LIST << nl;
    }


    void streamCoordinates(Ostream& os, const cellLocations& in)
    {
        const bool ascii = (os.format() == IOstream::ASCII);

        os << in.cell.size() << nl << token::BEGIN_LIST << nl;

        forAll(in.cell, i)
        {
            const label cellAndTet[] =
            {
                in.cell[i],
                in.tetFace[i],
                in.tetPoint[i]
            };

            if (ascii)
            {
                os  << in.coordinates[i]
                    << token::SPACE << cellAndTet[0]
                    << token::SPACE << cellAndTet[1]
                    << token::SPACE << cellAndTet[2];
            }
            else
            {
                os.beginRawWrite(sizeof(barycentric) + sizeof(cellAndTet));
                writeRaw(os, &in.coordinates[i], sizeof(barycentric));
                writeRaw(os, cellAndTet, sizeof(cellAndTet));
                os.endRawWrite();
            }
            os << nl;
        }

        os << token::END_LIST << nl;
    }


    void checkFinite(const pointField& points, const word& name)
    {
        forAll(points, i)
        {
            if (!std::isfinite(points[i].x() + points[i].y() + points[i].z()))
            {
                FatalErrorInFunction
                    << "position of particle " << i << " of cloud " << name
                    << " is not finite: " << points[i] << exit(FatalError);
            }
        }
    }
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::sphCloud::checkSize
(
    const word& name,
    const std::size_t size
) const
{
    if (size != x_.size())
    {
        FatalErrorInFunction
            << "field " << name << " of cloud " << this->name() << " has "
            << label(size) << " values for " << nParcels() << " particles"
            << abort(FatalError);
    }
}


bool Foam::melt::sphCloud::writeProperties() const
{
    labelList counts(Pstream::nProcs(), Zero);
    counts[Pstream::myProcNo()] = nParcels();
    Pstream::listCombineGather(counts, maxEqOp<label>());
    Pstream::listCombineScatter(counts);

    IOdictionary properties
    (
        IOobject
        (
            "cloudProperties",
            time().timeName(),
            "uniform"/cloud::prefix/name(),
            db(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    properties.add("geometry", geometryTypeNames[geometryType::COORDINATES]);

    forAll(counts, proci)
    {
        dictionary count;
        count.add("particleCount", counts[proci]);
        properties.add(word("processor" + Foam::name(proci)), count);
    }

    return properties.regIOobject::write(true);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::sphCloud::writeObject(MELT_WRITE_OBJECT_PARAMETERS) const
{
    bool good = writeProperties();

    if (!nParcels())
    {
        outside_ = 0;
        return good;
    }

    const auto writeFile = [&]
    (
        const word& name,
        const word& type,
        const std::function<void(Ostream&)>& stream
    )
    {
        const cloudFile file(fieldObject(name), type, stream);
        good = file.writeObject(MELT_WRITE_OBJECT_ARGUMENTS) && good;
    };

    {
        const pointField points(positions());
        checkFinite(points, name());
        const cellLocations in(mesh_, points);
        outside_ = in.outside;

        writeFile
        (
            geometryTypeNames[geometryType::POSITIONS],
            typeName,
            [&](Ostream& os) { streamPositions(os, points, in); }
        );
        writeFile
        (
            geometryTypeNames[geometryType::COORDINATES],
            typeName,
            [&](Ostream& os) { streamCoordinates(os, in); }
        );
    }

    const auto writeField = [&](const word& name, const auto& field)
    {
        typedef typename std::decay_t<decltype(field)>::value_type Type;
        writeFile
        (
            name,
            IOField<Type>::typeName,
            [&](Ostream& os) { os << field; }
        );
    };

    forAllFields(writeField);

    if (!binds("origId"))
    {
        writeField("origId", Field<label>(identity(nParcels())));
    }

    if (!binds("origProcId"))
    {
        writeField
        (
            "origProcId",
            Field<label>(nParcels(), Pstream::myProcNo())
        );
    }

    return good;
}


// ************************************************************************* //
