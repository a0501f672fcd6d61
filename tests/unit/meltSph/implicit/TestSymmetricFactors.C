/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "symmetricFactors.H"

#include <gtest/gtest.h>

namespace Foam
{
namespace melt
{
namespace unitTest
{
namespace
{

using matrix = Eigen::SparseMatrix<double>;

//- Of a cube of n^3 springs between neighbours, weak ones to the ground
matrix springs(const int n, const double ground)
{
    std::vector<Eigen::Triplet<double>> entries;
    const int strides[3] = {1, n, n*n};
    for (int k = 0; k < n*n*n; ++k)
    {
        entries.emplace_back(k, k, ground);
        for (const int stride : strides)
        {
            const double stiffness = 1 + k%7;
            if (k/stride%n < n - 1)
            {
                const int other = k + stride;
                entries.emplace_back(k, k, stiffness);
                entries.emplace_back(other, other, stiffness);
                entries.emplace_back(k, other, -stiffness);
                entries.emplace_back(other, k, -stiffness);
            }
        }
    }
    matrix A(n*n*n, n*n*n);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
}

} // End anonymous namespace


TEST(SymmetricFactors, solve)
{
    const matrix A(springs(9, 1e-6));
    symmetricFactors factors;
    EXPECT_EQ(factors.bytes(), 0u);

    // Also when used again
    for (const double scale : {1.0, 3.0})
    {
        ASSERT_TRUE(factors.compute(scale*A));
        const Eigen::VectorXd x(Eigen::VectorXd::Random(A.cols()));
        Eigen::VectorXd y(scale*(A*x));
        factors.solve(y);
        EXPECT_LT((x - y).norm(), 1e-8*x.norm());
    }
}


// A preconditioner has to be
TEST(SymmetricFactors, areSymmetric)
{
    const matrix A(springs(7, 1e-9));
    symmetricFactors factors;
    ASSERT_TRUE(factors.compute(A));
    const Eigen::VectorXd a(Eigen::VectorXd::Random(A.cols()));
    const Eigen::VectorXd b(Eigen::VectorXd::Random(A.cols()));
    Eigen::VectorXd inverseA(a), inverseB(b);
    factors.solve(inverseA);
    factors.solve(inverseB);
    EXPECT_NEAR
    (
        b.dot(inverseA), a.dot(inverseB), 1e-12*b.norm()*inverseA.norm()
    );
}


TEST(SymmetricFactors, holdLessThanThoseWithoutSymmetry)
{
    const matrix A(springs(9, 1));
    symmetricFactors factors;
    ASSERT_TRUE(factors.compute(A));
    Eigen::SparseLU<matrix, Eigen::NaturalOrdering<int>> both;
    both.isSymmetric(true);
    both.compute(A);
    // With its indices, and those of the other without
    EXPECT_LT
    (
        factors.bytes(), 0.8*sizeof(double)*(both.nnzL() + both.nnzU())
    );
}


TEST(SymmetricFactors, failOfASingularMatrix)
{
    symmetricFactors factors;
    EXPECT_FALSE(factors.compute(0*springs(3, 1)));
}

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
