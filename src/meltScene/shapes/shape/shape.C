/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shape.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace melt
{
    defineTypeName(shape);
    defineRunTimeSelectionTable(shape, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::shape::shape(const word& name, const dictionary& dict)
:
    name_(name),
    transformation_(dict),
    U_(dict.lookupOrDefault<vector>("U", Zero)),
    omega_(dict.lookupOrDefault<vector>("omega", Zero)),
    vortex_(dict.lookupOrDefault<scalar>("vortex", 0))
{
    if
    (
        !std::isfinite(mag(U_))
     || !std::isfinite(mag(omega_))
     || !std::isfinite(vortex_)
    )
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'U' of shape " << name << " is " << U_
            << " m/s, 'omega' is " << omega_ << " rad/s, 'vortex' is "
            << vortex_ << " m/s; accepted are finite numbers" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::melt::shape> Foam::melt::shape::New
(
    const word& name,
    const dictionary& dict,
    const fileName& caseDirectory
)
{
    const word shapeType(dict.get<word>("type"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(shapeType);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'type' of shape " << name << " is " << shapeType
            << "; accepted are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return cstrIter()(name, dict, caseDirectory);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boolList Foam::melt::shape::inside(const pointField& points) const
{
    boolList result(points.size());

    // Small pieces, as points near a surface cost more than others
    #pragma omp parallel for schedule(dynamic, 64)
    for (label i = 0; i < points.size(); ++i)
    {
        result[i] = contains(transformation_.inverse(points[i]));
    }

    return result;
}


Foam::scalarMinMax Foam::melt::shape::extent(const vector& direction) const
{
    const vector n(transformation_.normal(direction));
    const scalar shift = direction & transformation_.translation();

    return scalarMinMax(shift - support(-n), shift + support(n));
}


Foam::boundBox Foam::melt::shape::bounds() const
{
    const scalarMinMax x(extent(vector(1, 0, 0)));
    const scalarMinMax y(extent(vector(0, 1, 0)));
    const scalarMinMax z(extent(vector(0, 0, 1)));

    return boundBox
    (
        point(x.min(), y.min(), z.min()),
        point(x.max(), y.max(), z.max())
    );
}


Foam::scalar Foam::melt::shape::volume() const
{
    return transformation_.volumeRatio()*ownVolume();
}


Foam::vectorField Foam::melt::shape::velocity(const pointField& points) const
{
    const boundBox box(bounds());
    vectorField result(U_ + (omega_ ^ (points - box.midpoint())));
    if (vortex_ != 0)
    {
        const vector L(box.span());
        forAll(points, i)
        {
            const vector d(points[i] - box.min());
            const scalar X = constant::mathematical::pi*d.x()/L.x();
            const scalar Y = constant::mathematical::pi*d.y()/L.y();
            result[i] += vortex_*vector
            (
                std::sin(X)*std::cos(Y),
                -L.y()/L.x()*std::cos(X)*std::sin(Y),
                0
            );
        }
    }
    return result;
}


// ************************************************************************* //
