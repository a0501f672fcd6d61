/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runRecord.H"
#include "caseScales.H"
#include "fvMesh.H"
#include "Time.H"

#include <omp.h>
#include <sys/resource.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Largest resident memory of this process so far [MB]
Foam::scalar peakMemory()
{
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);

    // Linux counts in kibibytes
    return 1.024e-3*usage.ru_maxrss;
}


//- CPU time of this process so far, of all its threads [s]; Time's has 10 ms
Foam::scalar processCpuTime()
{
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);

    const auto seconds = [](const timeval& t)
    {
        return t.tv_sec + 1e-6*t.tv_usec;
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::runRecord::runRecord
(
    const meltScene& scene,
    const meltMethod& method
)
:
    writeFile
    (
        scene.mesh(),
        "meltRun",
        "meltRun",
        dictionary(IStringStream("writePrecision 12;")())
    ),
    method_(method),
    startClock_(clockValue::now()),
    startCpu_(processCpuTime()),
    startIndex_(scene.mesh().time().timeIndex())
{
    // All ranks sum up, the first one writes
    const caseScales scales(scene);
    const auto counts = method.operationCounts();
    if (writeToFile_)
    {
        file()
            << "# method " << method.type()
            << "; resolution " << scene.resolution()
            << "; threads " << omp_get_max_threads()
            << "; ranks " << Pstream::nProcs()
            << "; class " << scales.caseClass
            << "; extent " << scales.extent
            << "; meltVolume " << scales.meltVolume
            << "; domainVolume " << scales.domainVolume
            << "; duration " << scales.duration
            << "; leastSteps " << scales.leastSteps << ';' << nl
            << "# time[s]" << tab << "steps[-]" << tab << "particles[-]"
            << tab << "particleSteps[-]" << tab << "wallTime[s]"
            << tab << "cpuTime[s]" << tab << "peakMemory[MB]";

        for (label i = 1; i < counts.size(); ++i)
        {
            file() << tab << counts[i].first() << "[-]";
        }
        file() << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::melt::runRecord::cpuTime() const
{
    return returnReduce(processCpuTime() - startCpu_, sumOp<scalar>());
}


Foam::label Foam::melt::runRecord::steps() const
{
    return fileObr_.time().timeIndex() - startIndex_;
}


void Foam::melt::runRecord::write()
{
    const Time& time = fileObr_.time();
    const label nParticles = method_.nParticles();
    const List<Tuple2<word, scalar>> counts(method_.operationCounts());
    const scalar cpu = cpuTime();
    const scalar memory = returnReduce(peakMemory(), sumOp<scalar>());

    if (writeToFile_)
    {
        file()
            << time.value() << tab << time.timeIndex() << tab << nParticles
            << tab << counts[0].second()
            << tab << scalar(clockValue::now()) - startClock_
            << tab << cpu << tab << memory;

        for (label i = 1; i < counts.size(); ++i)
        {
            file() << tab << counts[i].second();
        }
        file() << endl;
    }
}


void Foam::melt::runRecord::print() const
{
    const scalar cpu = cpuTime();
    const scalar memory = returnReduce(peakMemory(), sumOp<scalar>());

    Info<< "Cost: " << steps() << " steps";

    for (const auto& count : method_.operationCounts())
    {
        Info<< ", " << count.first() << ' ' << count.second();
    }

    Info<< nl << "     CPU " << cpu << " s, wall "
        << scalar(clockValue::now()) - startClock_ << " s, peak memory "
        << memory << " MB, threads " << omp_get_max_threads()
        << ", ranks " << Pstream::nProcs() << nl << endl;
}


// ************************************************************************* //
