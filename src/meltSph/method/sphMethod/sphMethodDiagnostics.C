/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphMethod.H"
#include "blockSum.H"
#include "fvMesh.H"
#include "meltCompat.H"
#include "Time.H"

#include <cmath>
#include <limits>

Foam::point Foam::melt::sphMethod::centreOfMass() const
{
    const particles& f = system_.fluid;
    const int n = f.size();
    const scalar mass = blockSum(n, [&](const int i) { return f.m[i]; });

    return point
    (
        blockSum(n, [&](const int i) { return f.m[i]*f.x[i]; }),
        blockSum(n, [&](const int i) { return f.m[i]*f.y[i]; }),
        blockSum(n, [&](const int i) { return f.m[i]*f.z[i]; })
    )/max(mass, VSMALL)
  + crossed()/max(mass, VSMALL);
}


Foam::vector Foam::melt::sphMethod::crossed() const
{
    const std::array<double, 3>& sums = system_.near.crossed();
    return vector(sums[0], sums[1], sums[2]);
}


Foam::scalar Foam::melt::sphMethod::potentialEnergy() const
{
    const particles& f = system_.fluid;
    const std::array<double, 3>& g = system_.g;

    return -blockSum
    (
        f.size(),
        [&](const int i)
        {
            return f.m[i]*(g[0]*f.x[i] + g[1]*f.y[i] + g[2]*f.z[i]);
        }
    ) - (scene_.g() & crossed());
}


void Foam::melt::sphMethod::readSums()
{
    sums_.readIfPresent("heatIn", heatIn_);
    sums_.readIfPresent("heatOut", heatOut_);
    sums_.readIfPresent("heatFromWalls", system_.heatFromWalls);
    sums_.readIfPresent("stepBefore", system_.stepBefore);
    sums_.readIfPresent("initialPotentialEnergy", initialPotentialEnergy_);
    sums_.readIfPresent("escapedMass", escapedMass_);
    sums_.readIfPresent("initialCentre", initialCentre_);

    vector crossed(Zero);
    sums_.readIfPresent("crossed", crossed);
    system_.near.crossed() = {crossed.x(), crossed.y(), crossed.z()};
}


void Foam::melt::sphMethod::writeSums()
{
    // All digits, for a restart that goes on as if never stopped; an entry is
    // made into text when it is set
    const unsigned int precision = IOstream::defaultPrecision
    (
        std::numeric_limits<scalar>::max_digits10
    );
    sums_.set("heatIn", heatIn_);
    sums_.set("heatOut", heatOut_);
    sums_.set("heatFromWalls", system_.heatFromWalls);
    sums_.set("stepBefore", system_.stepBefore);
    sums_.set("initialPotentialEnergy", initialPotentialEnergy_);
    sums_.set("escapedMass", escapedMass_);
    sums_.set("initialCentre", initialCentre_);
    sums_.set("crossed", crossed());
    sums_.instance() = mesh_.time().timeName();

    sums_.regIOobject::writeObject
    (
        MELT_WRITE_OBJECT_DEFAULTS(mesh_.time()), true
    );
    IOstream::defaultPrecision(precision);
}


Foam::melt::meltDiagnostics Foam::melt::sphMethod::diagnostics() const
{
    const particles& f = system_.fluid;
    const int n = f.size();
    const enthalpyCurve curve = scene_.thermo().enthalpy();
    const scalar rho0 = scene_.thermo().rho();
    const scalar c = system_.soundSpeed;

    meltDiagnostics d;
    if (n == 0)
    {
        return d;
    }

    const auto sum = [&](auto&& value) { return blockSum(n, value); };
    const auto highest = [&](auto&& value) { return parallelMax(n, value); };

    d.mass = sum([&](const int i) { return f.m[i]; });
    d.volume = sum([&](const int i) { return f.m[i]/f.rho[i]; });
    d.meltedFraction =
        sum
        (
            [&](const int i) { return f.m[i]*curve.liquidFraction(f.h[i]); }
        )/d.mass;
    d.centreOfMass = centreOfMass();

    // A particle is a cube of its volume
    const auto half = [&](const int i) { return 0.5*std::cbrt(f.m[i]/f.rho[i]); };
    d.bounds = boundBox
    (
        point
        (
           -highest([&](const int i) { return half(i) - f.x[i]; }),
           -highest([&](const int i) { return half(i) - f.y[i]; }),
           -highest([&](const int i) { return half(i) - f.z[i]; })
        ),
        point
        (
            highest([&](const int i) { return f.x[i] + half(i); }),
            highest([&](const int i) { return f.y[i] + half(i); }),
            highest([&](const int i) { return f.z[i] + half(i); })
        )
    );

    const vector& g = scene_.g();
    const vector up = mag(g) > 0 ? vector(-g/mag(g)) : vector(0, 0, 1);
    const auto upwards = [&](const int i)
    {
        return f.x[i]*up.x() + f.y[i]*up.y() + f.z[i]*up.z();
    };
    d.height =
        highest([&](const int i) { return upwards(i) + half(i); })
      + highest([&](const int i) { return half(i) - upwards(i); });
    d.frontRadius = highest
    (
        [&](const int i)
        {
            const vector away(point(f.x[i], f.y[i], f.z[i]) - initialCentre_);
            return mag(away - (away & up)*up) + half(i);
        }
    );

    const auto speed2 = [&](const int i)
    {
        return f.u[i]*f.u[i] + f.v[i]*f.v[i] + f.w[i]*f.w[i];
    };
    d.kineticEnergy =
        sum([&](const int i) { return 0.5*f.m[i]*speed2(i); });
    d.thermalEnergy = sum([&](const int i) { return f.m[i]*f.h[i]; });
    d.potentialEnergy = potentialEnergy();
    d.elasticEnergy = sum
    (
        [&](const int i)
        {
            // Integral of p/rho^2 from rho0
            const double r = f.rho[i]/rho0;
            return f.p[i] != 0 ? f.m[i]*c*c*(std::log(r) + 1/r - 1) : 0;
        }
    );
    d.workOfGravity = initialPotentialEnergy_ - d.potentialEnergy;
    d.heatIn = heatIn_;
    d.heatOut = heatOut_;
    d.maxU = std::sqrt(highest(speed2));
    d.maxT = highest([&](const int i) { return curve.T(f.h[i]); });
    d.minT = -highest([&](const int i) { return -curve.T(f.h[i]); });
    return d;
}


void Foam::melt::sphMethod::report(Ostream& os) const
{
    const particles& f = system_.fluid;
    const int n = f.size();
    const scalar rho0 = scene_.thermo().rho();
    const scalar densityError = n ? parallelMax
    (
        n,
        [&](const int i) { return std::abs(f.rho[i]/rho0 - 1); }
    ) : 0;

    os  << "SPH: " << n << " particles, "
        << scalar(system_.near.fluid().nPairs())/max(n, 1)
        << " neighbours listed a particle, lists built "
        << label(system_.near.nBuilds()) << " times, "
        << label
           (
               (f.bytes() + system_.near.bytes() + scheme_->bytes())/max(n, 1)
           )
        << " bytes a particle" << nl
        << "     sound " << system_.soundSpeed << " m/s, density within "
        << 100*densityError << " %, put back at walls "
        << scheme_->wallContacts() << " times, escaped " << escapedMass_
        << " kg" << nl;
    scheme_->report(os);
}

// ************************************************************************* //
