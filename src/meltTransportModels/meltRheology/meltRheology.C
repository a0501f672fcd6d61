/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltRheology.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "sigFpe.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosityModels
{
    defineTypeNameAndDebug(meltRheology, 0);
    addToRunTimeSelectionTable(viscosityModel, meltRheology, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::viscosityModels::meltRheology::readCoeffs()
{
    using namespace melt::checkedEntry;

    const dictionary& coeffs =
        viscosityProperties_.optionalSubDict(typeName + "Coeffs");

    rheology_ = melt::rheologyModel::New(coeffs);
    rho_ = get(viscosityProperties_, "rho", dimDensity, positive());
    fileT_.clear();

    TName_ = "T";
    if (coeffs.found("T"))
    {
        const token first(coeffs.lookup("T").first());
        TName_ = first.isWord() ? first.wordToken() : word();
    }
    if (TName_.empty())
    {
        uniformT_ = get(coeffs, "T", dimTemperature, notNegative());
    }
}


const Foam::volScalarField&
Foam::viscosityModels::meltRheology::temperature() const
{
    const fvMesh& mesh = U_.mesh();

    if (!TName_.empty() && mesh.foundObject<volScalarField>(TName_))
    {
        return mesh.lookupObject<volScalarField>(TName_);
    }

    if (fileT_.valid())
    {
        return *fileT_;
    }

    const auto fieldIO = [&]
    (
        const fileName& instance,
        const IOobject::readOption r
    )
    {
        return IOobject
        (
            TName_.empty() ? word("T") : TName_,
            instance,
            mesh,
            r,
            IOobject::NO_WRITE,
            false
        );
    };

    if (TName_.empty())
    {
        fileT_.reset
        (
            new volScalarField
            (
                fieldIO(mesh.time().timeName(), IOobject::NO_READ),
                mesh,
                dimensionedScalar("T", dimTemperature, uniformT_)
            )
        );
        return *fileT_;
    }

    const IOobject io
    (
        fieldIO
        (
            mesh.time().findInstance
            (
                mesh.dbDir(), TName_, IOobject::READ_IF_PRESENT
            ),
            IOobject::MUST_READ
        )
    );

    if (!IOobject(io).typeHeaderOk<volScalarField>(true))
    {
        FatalIOErrorInFunction(viscosityProperties_)
            << "There is no temperature field " << TName_ << ": neither of the"
            << " solver, which has " << mesh.sortedNames<volScalarField>()
            << ", nor in a time directory." << nl
            << "Accepted: entry T of " << typeName << "Coeffs is the name of"
            << " such a field or a temperature [K]" << exit(FatalIOError);
    }

    fileT_.reset(new volScalarField(io, mesh));
    return *fileT_;
}


Foam::tmp<Foam::volScalarField>
Foam::viscosityModels::meltRheology::calcNu() const
{
    const volScalarField& T = temperature();
    const tmp<volScalarField> tshearRate(strainRate());
    const volScalarField& shearRate = tshearRate();

    tmp<volScalarField> tnu
    (
        volScalarField::New
        (
            name_ + "New", U_.mesh(), dimensionedScalar(dimViscosity, Zero)
        )
    );
    volScalarField& nu = tnu.ref();

    // Vectorised loops compute branches that are not taken
    const sigFpe::ignore ignored;

    const auto evaluate = [&]
    (
        const scalarField& shearRateValues,
        const scalarField& TValues,
        scalarField& nuValues
    )
    {
        rheology_->eta
        (
            nuValues.size(),
            shearRateValues.cdata(),
            TValues.cdata(),
            nuValues.data()
        );
        nuValues /= rho_;
    };

    evaluate(shearRate, T, nu.primitiveFieldRef());
    forAll(nu.boundaryField(), patchi)
    {
        evaluate
        (
            shearRate.boundaryField()[patchi],
            T.boundaryField()[patchi],
            nu.boundaryFieldRef()[patchi]
        );
    }

    return tnu;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosityModels::meltRheology::meltRheology
(
    const word& name,
    const dictionary& viscosityProperties,
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    viscosityModel(name, viscosityProperties, U, phi),
    rho_(0),
    uniformT_(0),
    nu_
    (
        IOobject
        (
            name,
            U.time().timeName(),
            U.db(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        U.mesh(),
        dimensionedScalar(dimViscosity, Zero)
    )
{
    readCoeffs();
    nu_ = calcNu();
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

bool Foam::viscosityModels::meltRheology::read
(
    const dictionary& viscosityProperties
)
{
    viscosityModel::read(viscosityProperties);
    readCoeffs();

    return true;
}


// ************************************************************************* //
