/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "smoothingKernel.H"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <tuple>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;

namespace
{

using kernelType = smoothingKernel::kernelType;

//- Kernel by name, 2 or 3 dimensions
class SmoothingKernel
:
    public testing::TestWithParam<std::tuple<std::string, int>>
{
protected:

    // Not 1, so that a wrong power of h is seen
    const double h = 0.37;

    const int dimensions = std::get<1>(GetParam());

    const smoothingKernel kernel
    {
        smoothingKernel::typeOf(std::get<0>(GetParam())), h, dimensions
    };

    double W(const double r) const
    {
        double value = 0;
        kernel.visit([&](const auto& w) { value = w.value(r*r); });
        return value;
    }

    //- dW/dr
    double slope(const double r) const
    {
        double value = 0;
        kernel.visit([&](const auto& w) { value = r*w.gradientOverR(r*r); });
        return value;
    }

    //- Integral of f(r) over all space: Gauss points, five on each of the
    //  intervals on which the kernels are polynomials of r, exact to degree 9
    double integral(const std::function<double(double)>& f) const
    {
        const double node[5] =
        {
            -0.906179845938663993, -0.538469310105683091, 0,
             0.538469310105683091, 0.906179845938663993
        };
        const double weight[5] =
        {
            0.236926885056189088, 0.478628670499366468, 0.568888888888888889,
            0.478628670499366468, 0.236926885056189088
        };

        double sum = 0;
        for (int interval = 0; interval*h < kernel.support(); ++interval)
        {
            for (int k = 0; k < 5; ++k)
            {
                const double r = h*(interval + 0.5 + 0.5*node[k]);
                const double shell =
                    dimensions == 2 ? 2*M_PI*r : 4*M_PI*r*r;
                sum += 0.5*h*weight[k]*shell*f(r);
            }
        }
        return sum;
    }
};

} // End anonymous namespace


TEST_P(SmoothingKernel, integralIsOne)
{
    EXPECT_NEAR(integral([&](double r) { return W(r); }), 1, 1e-12);
}


// int x dW/dx = -1 makes the gradient of a linear field right
TEST_P(SmoothingKernel, firstMomentOfGradientIsMinusOne)
{
    const double moment = integral([&](double r) { return r*slope(r); });
    EXPECT_NEAR(moment/dimensions, -1, 1e-12);
}


TEST_P(SmoothingKernel, secondMoment)
{
    const bool quintic = std::get<0>(GetParam()) == "quinticSpline";
    const double exact =
        quintic ? (dimensions == 3 ? 1.4 : 0.966179)
      : (dimensions == 3 ? 0.8 : 5.0/9.0);

    const double moment = integral([&](double r) { return r*r*W(r); });
    EXPECT_NEAR(moment/(h*h), exact, 5e-7);
}


TEST_P(SmoothingKernel, gradientIsDerivative)
{
    const double dr = 1e-5*h;
    for (double r = 0.003*h; r < 1.1*kernel.support(); r += 0.017*h)
    {
        const double difference = (W(r + dr) - W(r - dr))/(2*dr);
        EXPECT_NEAR(slope(r), difference, 1e-8*W(0)/h) << "r/h = " << r/h;
    }
}


TEST_P(SmoothingKernel, fallsToZeroAtSupport)
{
    const double ratio =
        std::get<0>(GetParam()) == "quinticSpline" ? 3 : 2;
    EXPECT_DOUBLE_EQ(kernel.support(), ratio*h);

    for (double q = 0.01; q < ratio - 0.02; q += 0.01)
    {
        EXPECT_GT(W(q*h), 0) << "q = " << q;
        EXPECT_LT(slope(q*h), 0) << "q = " << q;
        EXPECT_GT(W(q*h), W((q + 0.01)*h)) << "q = " << q;
    }
    for (const double q : {1.0, 1 + 1e-9, 1.5, 100.0})
    {
        EXPECT_NEAR(W(q*kernel.support()), 0, 1e-30);
        EXPECT_NEAR(slope(q*kernel.support()), 0, 1e-30);
    }
}


TEST_P(SmoothingKernel, finiteWhereParticlesCoincide)
{
    EXPECT_TRUE(std::isfinite(W(0)));
    EXPECT_EQ(slope(0), 0);
    kernel.visit
    (
        [](const auto& w) { EXPECT_TRUE(std::isfinite(w.gradientOverR(0.0))); }
    );
    EXPECT_NEAR(slope(1e-9*h), 0, 1e-6*W(0)/h);
}


INSTANTIATE_TEST_SUITE_P
(
    all,
    SmoothingKernel,
    testing::Combine
    (
        testing::ValuesIn(smoothingKernel::names()),
        testing::Values(2, 3)
    )
);


TEST(SmoothingKernelFactor, quinticIsExact)
{
    const double h = 0.2;
    EXPECT_DOUBLE_EQ(quinticSpline(h, 3).sigma, 1/(120*M_PI*h*h*h));
    EXPECT_DOUBLE_EQ(quinticSpline(h, 3).value(0), 66/(120*M_PI*h*h*h));
    EXPECT_DOUBLE_EQ(quinticSpline(h, 2).sigma, 7/(478*M_PI*h*h));
}


TEST(SmoothingKernelFactor, WendlandIsExact)
{
    const double h = 0.2;
    EXPECT_DOUBLE_EQ(wendlandC2(h, 3).value(0), 21/(16*M_PI*h*h*h));
    EXPECT_DOUBLE_EQ(wendlandC2(h, 2).value(0), 7/(4*M_PI*h*h));
}


TEST(SmoothingKernelFactor, nameSelectsKernel)
{
    EXPECT_EQ(smoothingKernel::typeOf("wendlandC2"), kernelType::wendlandC2);
    EXPECT_EQ
    (
        smoothingKernel::typeOf("quinticSpline"), kernelType::quinticSpline
    );
    EXPECT_THROW(smoothingKernel::typeOf("cubic"), std::invalid_argument);
}

// ************************************************************************* //
