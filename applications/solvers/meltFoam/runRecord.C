/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runRecord.H"
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
    startCpu_(scene.mesh().time().elapsedCpuTime())
{
    if (writeToFile_)
    {
        file()
            << "# method " << method.type()
            << "; resolution " << scene.resolution()
            << "; threads " << omp_get_max_threads()
            << "; ranks " << Pstream::nProcs() << ';' << nl
            << "# time[s]" << tab << "steps[-]" << tab << "particles[-]"
            << tab << "particleSteps[-]" << tab << "wallTime[s]"
            << tab << "cpuTime[s]" << tab << "peakMemory[MB]" << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::runRecord::write()
{
    const Time& time = fileObr_.time();
    const label nParticles = method_.nParticles();
    const scalar particleSteps = method_.particleSteps();
    const scalar cpuTime =
        returnReduce(time.elapsedCpuTime() - startCpu_, sumOp<scalar>());
    const scalar memory = returnReduce(peakMemory(), sumOp<scalar>());

    if (writeToFile_)
    {
        file()
            << time.value() << tab << time.timeIndex() << tab << nParticles
            << tab << particleSteps
            << tab << scalar(clockValue::now()) - startClock_
            << tab << cpuTime << tab << memory << endl;
    }
}


// ************************************************************************* //
