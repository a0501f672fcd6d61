/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphCloud.H"
#include "cloudFile.H"
#include "IOdictionary.H"
#include "passiveParticle.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

namespace
{
    // Position of an entry of a file `positions`; its cell is of no interest
    point readPosition(Istream& is)
    {
        point p;
        label celli;

        if (is.format() == IOstream::ASCII)
        {
            is >> p >> celli;
        }
        else
        {
            is.beginRawRead();
            readRawScalar(is, p.data(), vector::nComponents);
            readRawLabel(is, &celli);
            is.endRawRead();
        }

        return p;
    }


    bool finite(const scalar value)
    {
        return std::isfinite(value);
    }


    bool finite(const vector& value)
    {
        return std::isfinite(value.x() + value.y() + value.z());
    }


    bool finite(const label)
    {
        return true;
    }


    template<class Type>
    void checkFinite(const Field<Type>& field, const Istream& is)
    {
        forAll(field, i)
        {
            if (!finite(field[i]))
            {
                FatalIOErrorInFunction(is)
                    << "value " << i << " is not a finite number: " << field[i]
                    << exit(FatalIOError);
            }
        }
    }
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::sphCloud::present(const word& name) const
{
    return fieldObject(name, IOobject::MUST_READ).typeHeaderOk<IOField<label>>
    (
        false,
        false
    );
}


Foam::label Foam::melt::sphCloud::writtenCount() const
{
    IOobject io
    (
        "cloudProperties",
        time().timeName(),
        "uniform"/cloud::prefix/name(),
        db(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        return -1;
    }

    const IOdictionary properties(io);
    const word rank("processor" + Foam::name(Pstream::myProcNo()));
    const dictionary* counts = properties.findDict(rank);

    return counts ? counts->get<label>("particleCount") : 0;
}


Foam::pointField Foam::melt::sphCloud::readPositions() const
{
    // The barycentric coordinates give the positions only up to round-off
    const bool exact = present(geometryTypeNames[geometryType::POSITIONS]);

    cloudFile file
    (
        fieldObject
        (
            geometryTypeNames
            [
                exact ? geometryType::POSITIONS : geometryType::COORDINATES
            ],
            IOobject::MUST_READ
        )
    );

    Istream& is = file.readStream(word::null);

    pointField points(readLabel(is));
    is.readBeginList(FUNCTION_NAME);

    for (point& p : points)
    {
        p =
            exact
          ? readPosition(is)
          : passiveParticle(mesh_, is, false, true).position();
    }

    is.readEndList(FUNCTION_NAME);
    is.check(FUNCTION_NAME);
    checkFinite(points, is);
    file.close();

    return points;
}


template<class Type>
Foam::Field<Type> Foam::melt::sphCloud::readField
(
    const word& name,
    const label n,
    const bool required
)
{
    if (!required && !present(name))
    {
        missing_.insert(name);
        return Field<Type>(n, Zero);
    }

    cloudFile file(fieldObject(name, IOobject::MUST_READ));
    Istream& is = file.readStream(IOField<Type>::typeName);

    Field<Type> field(is);

    if (field.size() != n)
    {
        FatalIOErrorInFunction(is)
            << field.size() << " values for " << n << " particles"
            << exit(FatalIOError);
    }

    checkFinite(field, is);
    file.close();

    return field;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::sphCloud::read()
{
    const bool stored =
        present(geometryTypeNames[geometryType::POSITIONS])
     || present(geometryTypeNames[geometryType::COORDINATES]);

    if (!stored)
    {
        const label count = writtenCount();

        if (count < 0)
        {
            return false;
        }
        else if (count > 0 && !Pstream::parRun())
        {
            FatalErrorInFunction
                << "cloudProperties tell of " << count << " particles, but "
                << fieldObject("positions").objectPath() << " is missing"
                << exit(FatalError);
        }
    }

    missing_.clear();

    const pointField points(stored ? readPositions() : pointField());
    const label n = points.size();

    const auto unpack = [&]
    (
        const Field<vector>& from,
        std::vector<double>& x,
        std::vector<double>& y,
        std::vector<double>& z
    )
    {
        x.resize(n);
        y.resize(n);
        z.resize(n);

        forAll(from, i)
        {
            x[i] = from[i].x();
            y[i] = from[i].y();
            z[i] = from[i].z();
        }
    };

    unpack(points, x_, y_, z_);

    // Without particles there are no files of fields
    for (const scalarEntry& entry : scalars_)
    {
        const Field<scalar> field
        (
            readField<scalar>(entry.name, n, entry.required && n)
        );
        entry.values->assign(field.begin(), field.end());
    }

    for (const vectorEntry& entry : vectors_)
    {
        unpack
        (
            readField<vector>(entry.name, n, entry.required && n),
            *entry.x,
            *entry.y,
            *entry.z
        );
    }

    for (const labelEntry& entry : labels_)
    {
        const Field<label> field
        (
            readField<label>(entry.name, n, entry.required && n)
        );
        entry.values->assign(field.begin(), field.end());
    }

    return true;
}


// ************************************************************************* //
