/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "comparisonReport.H"
#include "OSspecific.H"
#include "svgPlot.H"
#include "viewCase.H"

#include <fstream>
#include <iomanip>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::melt::comparisonReport::columns() const
{
    DynamicList<word> common;
    for (const word& column : cases_[0].diagnostics().names())
    {
        bool all = column != "time";
        for (const caseResults& c : cases_)
        {
            all = all && c.diagnostics().has(column);
        }
        if (all)
        {
            common.append(column);
        }
    }
    return wordList(common);
}


Foam::List<std::pair<Foam::string, Foam::scalar>>
Foam::melt::comparisonReport::costs(const runCost& cost)
{
    return
    {
        {"resolution [m]", cost.resolution},
        {"particles", cost.particles},
        {"steps", cost.steps},
        {"particle-steps", cost.particleSteps},
        {"wall time [s]", cost.wallTime},
        {"CPU time [s]", cost.cpuTime},
        {"peak memory [MB]", cost.peakMemory},
        {"threads", cost.threads},
        {"ranks", cost.ranks}
    };
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::comparisonReport::comparisonReport
(
    const fileName& directory,
    const word& title,
    PtrList<caseResults>& cases,
    const PtrList<pairComparison>& pairs,
    const comparisonTolerances& tolerances
)
:
    dir_(directory),
    title_(title),
    cases_(cases),
    pairs_(pairs),
    tolerances_(tolerances)
{
    mkDir(dir_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::comparisonReport::holds() const
{
    for (const pairComparison& pair : pairs_)
    {
        if (!pair.holds(tolerances_))
        {
            return false;
        }
    }
    return true;
}


void Foam::melt::comparisonReport::writeCsv() const
{
    std::ofstream comparison(dir_/"comparison.csv");
    comparison << "case a,case b,quantity,unit,time[s],value,tolerance,holds\n"
        << std::setprecision(10);
    for (const pairComparison& pair : pairs_)
    {
        for (const pairComparison::item& i : pair.items())
        {
            comparison
                << pair.cases().first() << ',' << pair.cases().second() << ','
                << i.quantity << ',' << i.unit << ',';
            if (i.time >= 0)
            {
                comparison << i.time;
            }
            comparison << ',' << i.value << ',';
            if (tolerances_.found(i.quantity, pair.methods()))
            {
                comparison
                    << tolerances_.value(i.quantity, pair.methods()) << ','
                    <<
                    (
                        tolerances_.holds(i.quantity, i.value, pair.methods())
                      ? "yes" : "no"
                    );
            }
            else
            {
                comparison << ',';
            }
            comparison << '\n';
        }
    }

    std::ofstream diagnostics(dir_/"diagnostics.csv");
    diagnostics << std::setprecision(12) << "case,time[s]";
    for (const word& column : columns())
    {
        diagnostics
            << ',' << column << '[' << cases_[0].diagnostics().unit(column)
            << ']';
    }
    diagnostics << '\n';
    for (const caseResults& c : cases_)
    {
        forAll(c.diagnostics().time(), i)
        {
            diagnostics << c.name() << ',' << c.diagnostics().time()[i];
            for (const word& column : columns())
            {
                diagnostics << ',' << c.diagnostics()[column][i];
            }
            diagnostics << '\n';
        }
    }

    std::ofstream cost(dir_/"cost.csv");
    cost << "case,method";
    for (const auto& item : costs(cases_[0].cost()))
    {
        cost << ',' << item.first;
    }
    cost << '\n';
    for (const caseResults& c : cases_)
    {
        cost << c.name() << ',' << c.cost().method;
        for (const auto& item : costs(c.cost()))
        {
            cost << ',' << item.second;
        }
        cost << '\n';
    }

    if (!comparison.flush() || !diagnostics.flush() || !cost.flush())
    {
        FatalErrorInFunction << "Cannot write to " << dir_ << exit(FatalError);
    }
}


void Foam::melt::comparisonReport::writePlots() const
{
    mkDir(dir_/"plots");
    for (const word& column : columns())
    {
        const string unit(cases_[0].diagnostics().unit(column));
        svgPlot plot(column + " [" + unit + ']', "time [s]");
        for (const caseResults& c : cases_)
        {
            plot.add(c.name(), c.diagnostics().time(), c.diagnostics()[column]);
        }
        const fileName file(dir_/"plots"/column);
        plot.write(file + ".svg");

        if
        (
            Foam::system
            (
                "ffmpeg -loglevel error -y -i '" + file + ".svg' '" + file
              + ".png' < /dev/null 2> /dev/null"
            ) != 0
        )
        {
            WarningInFunction
                << "ffmpeg has not made " << file << ".png" << endl;
        }
    }
}


void Foam::melt::comparisonReport::writePictures
(
    const scalarList& times,
    const dictionary& pictures
)
{
    boundBox box(boundBox::invertedBox);
    scalarMinMax range;
    for (caseResults& c : cases_)
    {
        for (const scalar t : times)
        {
            c.setTime(t);
            const meltParcels parcels(c.parcels());
            box.add(parcels.bounds());
            range.add(parcels.T);
        }
    }

    mkDir(dir_/"pictures");
    for (caseResults& c : cases_)
    {
        Info<< "    pictures of " << c.name() << endl;
        const viewCase view
        (
            dir_/"view"/c.name(), c, times, pictures, box, range
        );
        view.draw();
        forAll(times, i)
        {
            c.setTime(times[i]);
            const fileName picture(view.picture(c.mesh().time().timeName()));
            cp
            (
                picture,
                dir_/"pictures"/(c.name() + '_' + Foam::name(i) + ".png")
            );
        }
    }
    rmDir(dir_/"view");
    pictureTimes_ = times;
}


// ************************************************************************* //
