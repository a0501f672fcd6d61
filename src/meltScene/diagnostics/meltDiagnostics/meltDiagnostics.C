/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltDiagnostics.H"
#include "Ostream.H"

#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::meltDiagnostics::writeHeader(Ostream& os)
{
    os  << tab << "mass[kg]"
        << tab << "volume[m3]"
        << tab << "meltedFraction[-]"
        << tab << "solidFraction[-]"
        << tab << "centreOfMassX[m]"
        << tab << "centreOfMassY[m]"
        << tab << "centreOfMassZ[m]"
        << tab << "minX[m]"
        << tab << "minY[m]"
        << tab << "minZ[m]"
        << tab << "maxX[m]"
        << tab << "maxY[m]"
        << tab << "maxZ[m]"
        << tab << "height[m]"
        << tab << "frontRadius[m]"
        << tab << "kineticEnergy[J]"
        << tab << "thermalEnergy[J]"
        << tab << "potentialEnergy[J]"
        << tab << "elasticEnergy[J]"
        << tab << "workOfGravity[J]"
        << tab << "workOut[J]"
        << tab << "heatIn[J]"
        << tab << "heatOut[J]"
        << tab << "maxU[m/s]"
        << tab << "minT[K]"
        << tab << "maxT[K]";
}


void Foam::melt::meltDiagnostics::write(Ostream& os) const
{
    const auto vectorColumns = [&](const vector& v)
    {
        os  << tab << v.x() << tab << v.y() << tab << v.z();
    };

    os  << tab << mass << tab << volume << tab << meltedFraction
        << tab << solidFraction();
    vectorColumns(centreOfMass);
    vectorColumns(bounds.min());
    vectorColumns(bounds.max());
    os  << tab << height
        << tab << frontRadius
        << tab << kineticEnergy
        << tab << thermalEnergy
        << tab << potentialEnergy
        << tab << elasticEnergy
        << tab << workOfGravity
        << tab << workOut()
        << tab << heatIn
        << tab << heatOut
        << tab << maxU
        << tab << minT
        << tab << maxT;
}


bool Foam::melt::meltDiagnostics::finite() const
{
    for
    (
        const scalar value
      : {
            mass,
            centreOfMass.x(),
            centreOfMass.y(),
            centreOfMass.z(),
            kineticEnergy,
            thermalEnergy,
            potentialEnergy,
            elasticEnergy,
            maxU,
            minT,
            maxT
        }
    )
    {
        if (!std::isfinite(value))
        {
            return false;
        }
    }

    return true;
}


// ************************************************************************* //
