/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remainingMomenta.H"
#include "meltSph/particleCloud/cloudVectors.H"
#include "solidBody.H"

#include <gtest/gtest.h>

#include <numeric>

namespace Foam
{
namespace melt
{
namespace unitTest
{
namespace
{

struct RemainingMomenta
:
    public testing::Test
{
    particleCloud cloud_{lattice{{5, 6, 4}}, 1};
    const particles& f_ = cloud_.fluid;
    solidBody all_;
    std::vector<float> share_ = std::vector<float>(f_.size());
    vectorArray impulse_ = randomVelocity(cloud_);
    vectorArray v_{f_.size()};

    RemainingMomenta()
    {
        all_.members.resize(f_.size());
        std::iota(all_.members.begin(), all_.members.end(), 0);
        all_.setGeometry(f_);
        for (float& share : share_)
        {
            share = float(cloud_.random(0, 1));
        }
    }
};

} // End anonymous namespace


TEST_F(RemainingMomenta, areThoseOfTheImpulses)
{
    vectorArray expected(impulse_);
    expected.divide(f_.m);
    all_.setMotion(f_, expected.x, expected.y, expected.z);
    const vector U(all_.U), L(all_.L);

    addRemainingMomenta(f_, share_, impulse_, true, v_);
    all_.setMotion(f_, v_.x, v_.y, v_.z);
    EXPECT_LT(mag(all_.U - U), 1e-13*mag(U));
    EXPECT_LT(mag(all_.L - L), 1e-13*mag(L));

    // Without spin uniform, by the shares
    v_.zero();
    addRemainingMomenta(f_, share_, impulse_, false, v_);
    all_.setMotion(f_, v_.x, v_.y, v_.z);
    EXPECT_LT(mag(all_.U - U), 1e-13*mag(U));
    for (int i = 1; i < f_.size(); ++i)
    {
        EXPECT_NEAR(v_.x[i]*share_[0], v_.x[0]*share_[i], 1e-10);
    }
}


TEST_F(RemainingMomenta, leaveParticlesWithoutShareAlone)
{
    share_[3] = 0;
    addRemainingMomenta(f_, share_, impulse_, true, v_);
    EXPECT_EQ(v_.x[3], 0);
    EXPECT_EQ(v_.y[3], 0);
    EXPECT_EQ(v_.z[3], 0);
    EXPECT_NE(v_.x[4], 0);

    v_.zero();
    std::fill(share_.begin(), share_.end(), 0);
    addRemainingMomenta(f_, share_, impulse_, true, v_);
    EXPECT_EQ(norm(v_), 0);
}

} // End namespace unitTest
} // End namespace melt
} // End namespace Foam

// ************************************************************************* //
