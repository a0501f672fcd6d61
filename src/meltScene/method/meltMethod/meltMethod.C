/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltMethod.H"
#include "fvMesh.H"
#include "Time.H"
#include "stringOps.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeNameAndDebug(meltMethod, 0);
    defineRunTimeSelectionTable(meltMethod, scene);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::fileName Foam::melt::meltMethod::library(const word& name)
{
    string capitalised(name);

    if (!name.empty())
    {
        capitalised[0] = char(std::toupper(capitalised[0]));
    }

    return "libmelt" + capitalised + ".so";
}


Foam::autoPtr<Foam::melt::meltMethod> Foam::melt::meltMethod::New
(
    const word& name,
    fvMesh& mesh,
    const meltScene& scene
)
{
    const auto known = [&]()
    {
        return sceneConstructorTablePtr_ && sceneConstructorTablePtr_->found(name);
    };

    if (!name.empty() && !known())
    {
        // Time owns what it opens, so the library outlives the method
        const_cast<Time&>(mesh.time()).libs().open(library(name), false);
    }

    if (!known())
    {
        // For the list of those that there are
        const_cast<Time&>(mesh.time()).libs().open(library("sph"), false);

        OStringStream message;
        message
            << "Unknown method \"" << name << "\", and no library "
            << library(name) << " that has it." << nl
            << "Valid methods: "
            <<
            (
                sceneConstructorTablePtr_
              ? sceneConstructorTablePtr_->sortedToc()
              : wordList()
            );

        const dictionary& controlDict = mesh.time().controlDict();

        if
        (
            controlDict.found("method")
         && controlDict.get<word>("method") == name
        )
        {
            FatalIOErrorInFunction(controlDict.lookup("method"))
                << message.str().c_str() << exit(FatalIOError);
        }

        FatalErrorInFunction << message.str().c_str() << exit(FatalError);
    }

    return sceneConstructorTablePtr_->find(name).val()(mesh, scene);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::meltMethod::meltMethod(fvMesh& mesh, const meltScene& scene)
:
    mesh_(mesh),
    scene_(scene)
{}


// ************************************************************************* //
