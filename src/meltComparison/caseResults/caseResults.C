/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseResults.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Names of times are rounded
bool same(const Foam::scalar a, const Foam::scalar b)
{
    return Foam::mag(a - b) <= 1e-6*Foam::max(Foam::mag(a), Foam::mag(b));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::melt::caseResults::regions() const
{
    wordList names(1, polyMesh::defaultRegion);
    const fileName constant(dir_/"constant");
    for (const fileName& name : readDir(constant, fileName::DIRECTORY))
    {
        if (isDir(constant/name/polyMesh::meshSubDir))
        {
            names.append(name);
        }
    }
    return names;
}


void Foam::melt::caseResults::findMelt(const word& region)
{
    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                region,
                time_->timeName(),
                *time_,
                IOobject::MUST_READ
            )
        )
    );

    DynamicList<instant> times;
    for (const instant& t : time_->times())
    {
        if (t.name() != time_->constant())
        {
            time_->setTime(t, 0);
            if (meltParcels::found(*mesh_))
            {
                times.append(t);
            }
        }
    }
    times_.transfer(times);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::caseResults::caseResults(const fileName& caseDirectory)
:
    dir_(caseDirectory)
{
    if (!isFile(dir_/"system"/Time::controlDictName))
    {
        FatalErrorInFunction
            << "There is no case " << dir_ << nl
            << "Expected: a directory with system/" << Time::controlDictName
            << exit(FatalError);
    }

    diagnostics_.reset(new diagnosticsTable(dir_));
    cost_.reset(new runCost(dir_));
    label_ = cost_->method;

    time_.reset
    (
        new Time
        (
            Time::controlDictName,
            dir_.path(),
            dir_.name(),
            "system",
            "constant",
            false,
            false
        )
    );

    for (const word& region : regions())
    {
        findMelt(region);
        if (times_.size())
        {
            break;
        }
    }

    if (times_.empty())
    {
        FatalErrorInFunction
            << "Case " << dir_ << " has no melt at any time." << nl
            << "Expected: <time>/lagrangian/melt or alpha.melt of one of the"
            << " regions " << regions() << "; parallel results have to be"
            << " reconstructed (reconstructPar)"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::caseResults::has(const scalar time) const
{
    for (const instant& t : times_)
    {
        if (same(t.value(), time))
        {
            return true;
        }
    }
    return false;
}


void Foam::melt::caseResults::setTime(const scalar time)
{
    for (const instant& t : times_)
    {
        if (same(t.value(), time))
        {
            time_->setTime(t, 0);
            return;
        }
    }

    DynamicList<scalar> values;
    for (const instant& t : times_)
    {
        values.append(t.value());
    }
    FatalErrorInFunction
        << "Case " << dir_ << " has no results at " << time << " s." << nl
        << "Times that it has: " << values << exit(FatalError);
}


Foam::melt::meltParcels Foam::melt::caseResults::parcels() const
{
    return meltParcels::read(*mesh_, cost_->resolution);
}


// ************************************************************************* //
