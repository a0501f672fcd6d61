/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pairComparison.H"
#include "occupancyGrid.H"
#include "surfaceDistance.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::pairComparison::pairComparison
(
    caseResults& a,
    caseResults& b,
    const scalarList& times,
    const scalar spacing
)
:
    cases_(a.name(), b.name()),
    methods_(a.cost().method, b.cost().method)
{
    for (const scalar t : times)
    {
        a.setTime(t);
        b.setTime(t);
        const meltParcels parcelsA(a.parcels());
        const meltParcels parcelsB(b.parcels());
        boundBox bounds(parcelsA.bounds());
        bounds.add(parcelsB.bounds());

        const occupancyGrid gridA(parcelsA, bounds, spacing);
        const occupancyGrid gridB(parcelsB, bounds, spacing);
        const Pair<scalar> T(occupancyGrid::TDifference(gridA, gridB));
        const surfaceDistance distance(gridA.surface(), gridB.surface());

        items_.append
        (
            item
            {
                "intersectionOverUnion",
                "-",
                t,
                occupancyGrid::intersectionOverUnion(gridA, gridB)
            }
        );
        items_.append(item{"TL2", "K", t, T.first()});
        items_.append(item{"TMax", "K", t, T.second()});
        items_.append(item{"meanDistance", "m", t, distance.mean});
        items_.append(item{"HausdorffDistance", "m", t, distance.Hausdorff});
    }

    for (const word& column : a.diagnostics().names())
    {
        if (b.diagnostics().has(column) && column != "time")
        {
            items_.append
            (
                item
                {
                    column,
                    a.diagnostics().unit(column),
                    -1,
                    a.diagnostics().maxDifference(column, b.diagnostics())
                }
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::melt::pairComparison::item&
Foam::melt::pairComparison::worst(const word& quantity) const
{
    const item* found = nullptr;
    for (const item& i : items_)
    {
        if
        (
            i.quantity == quantity
         &&
            (
                !found
             || (
                    comparisonTolerances::greaterIsBetter(quantity)
                  ? i.value < found->value
                  : i.value > found->value
                )
            )
        )
        {
            found = &i;
        }
    }

    if (!found)
    {
        FatalErrorInFunction
            << "Cases " << cases_ << " have not been compared by " << quantity
            << exit(FatalError);
    }
    return *found;
}


bool Foam::melt::pairComparison::holds
(
    const comparisonTolerances& tolerances
) const
{
    for (const item& i : items_)
    {
        if (!tolerances.holds(i.quantity, i.value, methods_))
        {
            return false;
        }
    }
    return true;
}


// ************************************************************************* //
