/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "CLASSNAME.H"
#include "IStringStream.H"

using namespace Foam;
using namespace Foam::melt;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST(CLASSNAME, hasItsViscosityAtRest)
{
    const dictionary dict(IStringStream("type CLASSNAME; eta0 50;")());
    const autoPtr<rheologyModel> model(rheologyModel::New(dict));

    const scalar shearRate = 0;
    const scalar T = 300;
    scalar eta = 0;
    model->eta(1, &shearRate, &T, &eta);

    EXPECT_DOUBLE_EQ(eta, 50);
    EXPECT_GE(model->etaMax(T, T), eta);
}


TEST(CLASSNAME, rejectsNegativeViscosity)
{
    const dictionary dict(IStringStream("type CLASSNAME; eta0 -1;")());

    EXPECT_THROW(rheologyModel::New(dict), Foam::IOerror);
}


// ************************************************************************* //
