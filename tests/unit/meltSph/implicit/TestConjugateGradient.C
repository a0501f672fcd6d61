/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conjugateGradient.H"
#include "meltUnitTests.H"
#include "vectorArray.H"

#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;

namespace
{

//- Solve x = 1, 2, ..., times factor as the matrix
iterationResult solve
(
    const double factor,
    vectorArray& x,
    const double preconditioner = 1
)
{
    const int n = 5;
    x = vectorArray(n);
    vectorArray r(n);
    for (int i = 0; i < n; ++i)
    {
        r.x[i] = i + 1;
    }
    const auto apply = [&](const vectorArray& p, vectorArray& Ap)
    {
        for (int i = 0; i < n; ++i)
        {
            Ap.x[i] = factor*p.x[i];
            Ap.y[i] = factor*p.y[i];
            Ap.z[i] = factor*p.z[i];
        }
    };
    const auto precondition = [&](const vectorArray& a, vectorArray& b)
    {
        b = a;
        b.multiply(std::vector<double>(n, preconditioner));
    };
    const auto scale = [](const vectorArray&) { return 1.0; };

    conjugateGradient<vectorArray> solver;
    return solver.solve(apply, precondition, scale, 1e-12, 0, 20, x, r);
}

} // End anonymous namespace


TEST(ConjugateGradient, solves)
{
    vectorArray x;
    const auto result = solve(4, x);
    EXPECT_TRUE(result.converged);
    EXPECT_NEAR(x.x[4], 5.0/4, 1e-14);
    EXPECT_EQ(x.y[4], 0);
}


TEST(ConjugateGradient, whatIsNotANumberHasNotConverged)
{
    vectorArray x;
    EXPECT_FALSE(solve(std::numeric_limits<double>::quiet_NaN(), x).converged);
    EXPECT_FALSE(solve(std::numeric_limits<double>::infinity(), x).converged);
}


TEST(ConjugateGradient, indefiniteMatrixHasNotConverged)
{
    vectorArray x;
    EXPECT_FALSE(solve(-1, x).converged);
    EXPECT_FALSE(solve(0, x).converged);
}


TEST(ConjugateGradient, seesANegativePreconditioner)
{
    vectorArray x;
    EXPECT_FALSE(solve(4, x, -1).positive);
    EXPECT_TRUE(solve(4, x).positive);
}

// ************************************************************************* //
