/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eulerianMethod.H"
#include "checkedEntry.H"
#include "effectTimes.H"
#include "surfaceTension.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::melt::meltFlow::controls Foam::melt::eulerianMethod::flowControls
(
    const dictionary& dict,
    const bool inPlane
)
{
    const scalarMinMax share(checkedEntry::positiveUpTo(1));
    const scalarMinMax atLeastOne(1, labelMax);
    const auto number = [&]
    (
        const word& keyword,
        const scalarMinMax& accepted,
        const scalar defaultValue
    )
    {
        return checkedEntry::getOrDefault
        (
            dict, keyword, dimless, accepted, defaultValue
        );
    };
    meltFlow::controls c;
    c.solver.tolerance = number("tolerance", share, 1e-8);
    c.solver.maxIterations = int(number("maxIterations", atLeastOne, 1000));
    c.solver.directUnknowns = int
    (
        number
        (
            "directUnknowns", scalarMinMax(0, labelMax), inPlane ? 8000 : 2000
        )
    );
    c.viscosityTolerance = number("viscosityTolerance", share, 1e-4);
    c.maxSweeps = int(number("maxSweeps", atLeastOne, 20));
    c.wetFrom = number("wetFrom", checkedEntry::positiveUpTo(0.5), 1e-3);
    return c;
}


Foam::tmp<Foam::scalarField>
Foam::melt::eulerianMethod::liquidFraction() const
{
    const scalarField& alpha = interface_.alpha();
    tmp<scalarField> f(new scalarField(alpha.size(), 1));
    forAll(alpha, celli)
    {
        if (alpha[celli] > VSMALL)
        {
            f.ref()[celli] = scene_.thermo().enthalpy().liquidFraction
            (
                alphaH_[celli]/alpha[celli]
            );
        }
    }
    return f;
}


void Foam::melt::eulerianMethod::flow(const scalar deltaT)
{
    const tmp<scalarField> fraction(liquidFraction());
    solid_.block(interface_.alpha(), fraction(), flow_.wetFrom(), region_);
    const meltThermo& thermo = scene_.thermo();
    const rheologyModel& rheology = scene_.rheology();

    std::vector<double> T(region_.onGrid(energy_.T()));
    for (double& value : T)
    {
        value = min(max(value, thermo.TMin()), thermo.TMax());
    }
    faceVelocities acceleration
    (
        buoyancy_.acceleration
        (
            scene_.g(), interface_.alpha(), energy_.T(), region_
        )
    );
    region_.addPressure(thermo.rho(), scene_.g(), acceleration);
    const std::vector<double> alpha(region_.onGrid(interface_.alpha()));
    if (surfaceTension_ > 0)
    {
        const effectTimes::part timing("surfaceTension", "surfaceTension");
        surfaceTension::addAcceleration
        (
            region_.grid(),
            alpha,
            flow_.wetFrom(),
            surfaceTension_,
            thermo.rho(),
            acceleration
        );
    }
    flowRecord_ = flow_.advance
    (
        alpha,
        thermo.rho(),
        deltaT,
        acceleration,
        solid_.sink(fraction(), region_),
        [&]
        (
            const std::vector<double>& rate,
            const std::vector<int>& cell,
            std::vector<double>& eta
        )
        {
            std::vector<double> TOfCell(cell.size());
            for (std::size_t i = 0; i < cell.size(); ++i)
            {
                TOfCell[i] = T[cell[i]];
            }
            rheology.eta
            (
                label(eta.size()), rate.data(), TOfCell.data(), eta.data()
            );
        },
        scene_.effects()("generalisedNewtonian")
    );
    nSystems_ += flowRecord_.sweeps;
    nIterations_ += label(flowRecord_.iterations);
    if (!flowRecord_.solved)
    {
        scalarList residuals(flowRecord_.residuals.size());
        std::copy
        (
            flowRecord_.residuals.begin(),
            flowRecord_.residuals.end(),
            residuals.begin()
        );
        fail
        (
            deltaT,
            "momentum",
            residuals,
            "Remedy: a smaller deltaT in controlDict, a larger tolerance of"
            " momentum in eulerianSolution, a rheology whose viscosity differs"
            " less"
        );
    }
}

// ************************************************************************* //
