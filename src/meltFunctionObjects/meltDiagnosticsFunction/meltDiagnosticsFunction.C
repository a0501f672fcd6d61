/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltDiagnosticsFunction.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "sigFpe.H"
#include "uniformDimensionedFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(meltDiagnosticsFunction, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        meltDiagnosticsFunction,
        dictionary
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class FieldType>
const FieldType& Foam::melt::meltDiagnosticsFunction::field
(
    const word& name
) const
{
    if (!mesh_.foundObject<FieldType>(name))
    {
        FatalErrorInFunction
            << "Function object " << this->name() << ": there is no field "
            << name << " of type " << FieldType::typeName << nl
            << "Accepted: one of " << mesh_.sortedNames<FieldType>()
            << exit(FatalError);
    }

    return mesh_.lookupObject<FieldType>(name);
}


Foam::tmp<Foam::scalarField>
Foam::melt::meltDiagnosticsFunction::alpha() const
{
    if (alphaName_ == "none")
    {
        return tmp<scalarField>::New(mesh_.nCells(), 1);
    }

    return min
    (
        max(field<volScalarField>(alphaName_).primitiveField(), scalar(0)),
        scalar(1)
    );
}


Foam::tmp<Foam::scalarField>
Foam::melt::meltDiagnosticsFunction::enthalpy() const
{
    const enthalpyCurve& curve = thermo_->enthalpy();
    tmp<scalarField> th(new scalarField(mesh_.nCells(), curve.hLiquidus()));

    if (TName_ != "none")
    {
        const scalarField& T = field<volScalarField>(TName_);
        scalarField& h = th.ref();

        forAll(h, celli)
        {
            h[celli] = curve.h(T[celli]);
        }
    }

    return th;
}


Foam::melt::meltDiagnostics
Foam::melt::meltDiagnosticsFunction::figures() const
{
    meltDiagnostics d
    (
        diagnostics_->calculate
        (
            alpha(),
            field<volVectorField>(UName_),
            enthalpy(),
            initialCentre_
        )
    );

    d.workOfGravity = initialPotentialEnergy_ - d.potentialEnergy;
    d.heatIn = heatIn_;
    d.heatOut = heatOut_;

    return d;
}


void Foam::melt::meltDiagnosticsFunction::addHeat()
{
    if (TName_ == "none")
    {
        return;
    }

    const volScalarField& T = field<volScalarField>(TName_);
    const enthalpyCurve& curve = thermo_->enthalpy();
    const scalarField alpha(this->alpha());
    const scalar solid = thermo_->kappaSolid();
    const scalar liquid = thermo_->kappaLiquid();
    scalar in = 0;
    scalar out = 0;

    for (const fvPatchScalarField& Tp : T.boundaryField())
    {
        if (Tp.coupled())
        {
            continue;
        }

        const labelUList& cells = Tp.patch().faceCells();
        const scalarField gradient(Tp.snGrad());
        const scalarField& area = Tp.patch().magSf();

        forAll(gradient, facei)
        {
            const scalar fraction =
                curve.liquidFraction(curve.h(T[cells[facei]]));
            const scalar power =
                (solid + fraction*(liquid - solid))
               *alpha[cells[facei]]*gradient[facei]*area[facei];

            (power > 0 ? in : out) += mag(power);
        }
    }

    const scalar deltaT = time_.deltaTValue();
    heatIn_ += deltaT*returnReduce(in, sumOp<scalar>());
    heatOut_ += deltaT*returnReduce(out, sumOp<scalar>());
}


void Foam::melt::meltDiagnosticsFunction::start()
{
    const scalarField alpha(this->alpha());

    if (!getProperty("initialCentre", initialCentre_))
    {
        initialCentre_ = diagnostics_->centreOfMass(alpha);
    }
    if (!getProperty("initialPotentialEnergy", initialPotentialEnergy_))
    {
        initialPotentialEnergy_ =
           -thermo_->rho()*gSum(alpha*mesh_.V())
           *(g_ & diagnostics_->centreOfMass(alpha));
    }
    heatIn_ = getProperty<scalar>("heatIn");
    heatOut_ = getProperty<scalar>("heatOut");
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::meltDiagnosticsFunction::meltDiagnosticsFunction
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    file_(mesh_, name),
    g_(Zero)
{
    uniformDimensionedVectorField g
    (
        IOobject
        (
            "g",
            time_.constant(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        ),
        dimensionedVector("g", dimAcceleration, Zero)
    );
    g_ = g.value();

    read(dict);
    start();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::meltDiagnosticsFunction::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);

    alphaName_ = dict.lookupOrDefault<word>("alpha", "none");
    UName_ = dict.lookupOrDefault<word>("U", "U");
    TName_ = dict.lookupOrDefault<word>("T", "T");
    thermo_.reset(new meltThermo(dict.subDict("thermo")));
    diagnostics_.reset
    (
        new fieldDiagnostics
        (
            mesh_,
            *thermo_,
            g_,
            checkedEntry::getOrDefault
            (
                dict, "seen", dimless, checkedEntry::positiveUpTo(1), 0.5
            )
        )
    );

    return true;
}


bool Foam::melt::meltDiagnosticsFunction::execute()
{
    // Vectorised loops compute branches that are not taken
    const sigFpe::ignore ignored;

    addHeat();

    return true;
}


bool Foam::melt::meltDiagnosticsFunction::write()
{
    {
        const sigFpe::ignore ignored;
        file_.write(figures());
    }

    setProperty("initialCentre", initialCentre_);
    setProperty("initialPotentialEnergy", initialPotentialEnergy_);
    setProperty("heatIn", heatIn_);
    setProperty("heatOut", heatOut_);

    return true;
}


// ************************************************************************* //
