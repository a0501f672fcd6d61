/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "smoothingKernel.H"

#include <stdexcept>

const std::vector<std::string>& Foam::melt::smoothingKernel::names()
{
    static const std::vector<std::string> all{"wendlandC2", "quinticSpline"};
    return all;
}


Foam::melt::smoothingKernel::kernelType
Foam::melt::smoothingKernel::typeOf(const std::string& name)
{
    for (std::size_t i = 0; i < names().size(); ++i)
    {
        if (names()[i] == name)
        {
            return kernelType(i);
        }
    }
    throw std::invalid_argument("unknown kernel " + name);
}

// ************************************************************************* //
