/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltScene.H"
#include "checkedEntry.H"
#include "fvMesh.H"
#include "initialTemperature.H"
#include "shape.H"
#include "shapeFill.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::meltScene::fill(const scalar givenResolution)
{
    const dictionary& shapesDict = dict_.subDict("shapes");

    resolution_ = givenResolution;
    label exactlyFilled = -1;

    forAll(shapes_, i)
    {
        const dictionary& dict = shapesDict.subDict(shapes_[i].name());

        if (resolution_ <= 0 && dict.found("nParticles"))
        {
            points_[i] =
                shapeFill::fillExactly(shapes_[i], dict, g_, resolution_);
            exactlyFilled = i;
        }
    }

    if (resolution_ <= 0)
    {
        resolution_ = checkedEntry::get
        (
            mesh_.time().controlDict(),
            "resolution",
            dimLength,
            checkedEntry::positive()
        );
    }

    forAll(shapes_, i)
    {
        if (i != exactlyFilled)
        {
            points_[i] = shapeFill::fill(shapes_[i], resolution_, g_);
        }
    }
}


void Foam::melt::meltScene::checkShapes() const
{
    const boundBox& domain = mesh_.bounds();

    forAll(shapes_, i)
    {
        const dictionary& dict =
            dict_.subDict("shapes").subDict(shapes_[i].name());

        if (points_[i].empty())
        {
            FatalIOErrorInFunction(dict)
                << "Shape " << shapes_[i].name() << " is empty: its bounds "
                << shapes_[i].bounds() << " hold no point at a resolution of "
                << resolution_ << " m." << nl
                << "Accepted: a shape that is thicker than the resolution"
                << exit(FatalIOError);
        }

        const label nOutside =
            shapeFill::outside(points_[i], domain).size();

        if (nOutside)
        {
            FatalIOErrorInFunction(dict)
                << "Shape " << shapes_[i].name() << " is outside the domain: "
                << nOutside << " of " << points_[i].size()
                << " points, its bounds are " << shapes_[i].bounds() << nl
                << "Accepted: a shape within " << domain
                << exit(FatalIOError);
        }

        for (label j = 0; j < i; ++j)
        {
            if (shapeFill::overlap(shapes_[j], shapes_[i], resolution_))
            {
                FatalIOErrorInFunction(dict)
                    << "Shapes " << shapes_[j].name() << " and "
                    << shapes_[i].name() << " overlap: their bounds are "
                    << shapes_[j].bounds() << " and " << shapes_[i].bounds()
                    << nl << "Accepted: shapes that are apart or touch"
                    << exit(FatalIOError);
            }
        }
    }
}


void Foam::melt::meltScene::setTemperatures()
{
    const scalarMinMax accepted(thermo_.TMin(), thermo_.TMax());

    forAll(shapes_, i)
    {
        const dictionary& dict =
            dict_.subDict("shapes").subDict(shapes_[i].name()).subDict("T");

        T_[i] = initialTemperature::New(dict, shapes_[i])->value(points_[i]);

        for (const scalar T : T_[i])
        {
            // Written so that NaN fails
            if (!(T >= accepted.min() && T <= accepted.max()))
            {
                FatalIOErrorInFunction(dict)
                    << "Temperature " << T << " K of shape "
                    << shapes_[i].name() << " is outside the range of the "
                    << "material." << nl
                    << "Accepted: TMin " << accepted.min() << " K to TMax "
                    << accepted.max() << " K" << exit(FatalIOError);
            }
        }
    }

    const scalarMinMax walls(walls_.TRange());

    if
    (
        walls.valid()
     && !(accepted.contains(walls.min()) && accepted.contains(walls.max()))
    )
    {
        FatalIOErrorInFunction(dict_.subDict("material").subDict("thermo"))
            << "Walls in 0/T have temperatures of " << walls.min() << " K to "
            << walls.max() << " K, outside the range of the material." << nl
            << "Accepted: TMin " << accepted.min() << " K to TMax "
            << accepted.max() << " K" << exit(FatalIOError);
    }
}


void Foam::melt::meltScene::applyEffects()
{
    if (!effects()("latentHeat"))
    {
        thermo_.omitLatentHeat();
    }
    if (!effects()("phaseChange"))
    {
        scalar sum = 0;
        label n = 0;
        for (const scalarField& T : T_)
        {
            sum += Foam::sum(T);
            n += T.size();
        }
        thermo_.keepPhase(sum/n > thermo_.enthalpy().solidus);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::meltScene::meltScene
(
    const fvMesh& mesh,
    const scalar givenResolution,
    const word& preset
)
:
    mesh_(mesh),
    dict_
    (
        IOobject
        (
            "meltProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ_IF_MODIFIED,
            IOobject::NO_WRITE
        )
    ),
    g_
    (
        uniformDimensionedVectorField
        (
            IOobject
            (
                "g",
                mesh.time().constant(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        ).value()
    ),
    thermo_(dict_.subDict("material").subDict("thermo")),
    rheology_
    (
        rheologyModel::New(dict_.subDict("material").subDict("rheology"))
    ),
    walls_(mesh),
    periods_(mesh),
    resolution_(0),
    preset_(preset)
{
    const dictionary& shapesDict = dict_.subDict("shapes");
    const wordList names(shapesDict.toc());

    if (names.empty())
    {
        FatalIOErrorInFunction(shapesDict)
            << "There is no shape. Accepted: at least one"
            << exit(FatalIOError);
    }

    shapes_.setSize(names.size());
    points_.setSize(names.size());
    T_.setSize(names.size());

    forAll(names, i)
    {
        shapes_.set
        (
            i,
            shape::New
            (
                names[i],
                shapesDict.subDict(names[i]),
                mesh.time().globalPath()
            )
        );
    }

    fill(givenResolution);
    checkShapes();
    setTemperatures();

    effects_.reset(new effectSwitches(dict_.subOrEmptyDict("effects"), *this));
    applyEffects();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

// Here, where shape is complete
Foam::melt::meltScene::~meltScene()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::melt::meltScene::numerics
(
    const word& name,
    IOobject::readOption option
) const
{
    return IOobject
    (
        preset_.empty() ? name : word(name + "." + preset_),
        mesh_.time().system(),
        mesh_,
        preset_.empty() ? option : IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
}


Foam::scalar Foam::melt::meltScene::pointVolume(const label i) const
{
    return shapes_[i].volume()/points_[i].size();
}


Foam::scalarMinMax Foam::melt::meltScene::TRange() const
{
    scalarMinMax range(walls_.TRange());

    for (const scalarField& T : T_)
    {
        range.add(T);
    }

    return range;
}


// ************************************************************************* //
