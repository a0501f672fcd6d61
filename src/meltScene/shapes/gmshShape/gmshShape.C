/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gmshShape.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "geometryFile.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "SHA1.H"

#include <limits>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(gmshShape);
    addToRunTimeSelectionTable(shape, gmshShape, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{

//- Arguments of gmsh that set the parameters
static stringList parameterArguments(const dictionary& parameters)
{
    DynamicList<string> arguments;
    for (const word& parameter : parameters.sortedToc())
    {
        const scalar value = checkedEntry::get
        (
            parameters,
            parameter,
            dimless,
            checkedEntry::any()
        );
        std::ostringstream text;
        text.precision(std::numeric_limits<scalar>::max_digits10);
        text << value;

        arguments.append("-setnumber");
        arguments.append(parameter);
        arguments.append(text.str());
    }

    return stringList(arguments);
}


//- Key of a surface: changes with the script and the arguments
static word contentKey(const fileName& script, const stringList& arguments)
{
    std::ostringstream content;
    content << IFstream(script)().stdStream().rdbuf();
    for (const string& argument : arguments)
    {
        content << ' ' << argument;
    }

    // As long as git's short form, enough for the few files of a case
    return SHA1(content.str()).digest().str().substr(0, 12);
}


//- Surface of the script, meshed if need be
static fileName meshedSurface(const fileName& script, const dictionary& dict)
{
    const stringList arguments
    (
        parameterArguments(dict.subOrEmptyDict("parameters"))
    );
    const fileName stem(script + "." + contentKey(script, arguments));
    const fileName surface(stem + ".stl");

    bool missing = !isFile(surface);
    Pstream::scatter(missing);

    if (missing)
    {
        // Under another name until complete
        const fileName part(stem + ".part.stl");

        stringList command
        ({
            "gmsh", "-2", "-v", "1", "-format", "stl", "-bin", "-o", part
        });
        command.append(arguments);
        command.append(script);

        Info<< "Meshing " << script.name() << " with gmsh" << endl;
        geometryFile::run
        (
            command,
            "see its messages above; is the program gmsh installed (package"
            " gmsh), and may the directory be written?",
            dict,
            part
        );

        if (Pstream::master())
        {
            mv(part, surface);
        }
        label synchronise = 0;
        Pstream::scatter(synchronise);
    }

    return surface;
}

} // End namespace melt
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::gmshShape::gmshShape
(
    const word& name,
    const dictionary& dict,
    const fileName& caseDirectory
)
:
    triSurfaceShape
    (
        meshedSurface(geometryFile::find(dict, caseDirectory), dict),
        name,
        dict
    )
{}


// ************************************************************************* //
