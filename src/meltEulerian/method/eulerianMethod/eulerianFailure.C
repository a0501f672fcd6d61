/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"
#include "meltTime.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::melt::eulerianMethod::fail
(
    const scalar deltaT,
    const string& equation,
    const UList<scalar>& residuals,
    const string& advice
)
{
    Time& time = const_cast<Time&>(mesh_.time());
    time.setTime(time.value() - remaining_, time.timeIndex() - 1);
    if (isA<meltTime>(time))
    {
        refCast<meltTime>(time).writeChecked([&]() { write(); });
    }
    FatalErrorInFunction
        << "The " << equation.c_str() << " equation has no solution in the step"
        << " of " << deltaT << " s from time " << time.timeName() << " s." << nl
        << "Relative residuals: " << residuals << nl
        << advice.c_str() << nl
        << "The state before the step is written." << exit(FatalError);
}

// ************************************************************************* //
