/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltUnitTests.H"
#include "particles.H"

#include <numeric>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

using namespace Foam::melt;

namespace
{

//- n particles whose carried arrays hold different numbers
particles marked(const int n)
{
    particles f;
    f.resize(n);
    int mark = 0;
    for (particles::array* a : f.arrays())
    {
        ++mark;
        for (std::size_t i = 0; i < a->size(); ++i)
        {
            (*a)[i] = 1000*mark + int(i);
        }
    }
    std::iota(f.id.begin(), f.id.end(), 0);
    return f;
}

} // End anonymous namespace


TEST(Particles, newOnesAreZero)
{
    particles f;
    f.resize(3);
    EXPECT_EQ(f.size(), 3);
    EXPECT_EQ(f.id.size(), 3u);
    for (particles::array* a : f.arrays())
    {
        for (const double value : *a)
        {
            EXPECT_EQ(value, 0);
        }
    }
}


TEST(Particles, effectsThatAreOffHaveNoMemory)
{
    particles f;
    f.resize(10);
    EXPECT_TRUE(f.dH.empty());
    EXPECT_TRUE(f.eta.empty());
    EXPECT_TRUE(f.S[5].empty());
    EXPECT_TRUE(f.du.empty());
    EXPECT_TRUE(f.kappa.empty());

    const std::size_t before = f.bytes();
    f.require({&f.eta, &f.dH});
    EXPECT_EQ(f.eta.size(), 10u);
    EXPECT_EQ(f.dH.size(), 10u);
    EXPECT_EQ(f.bytes(), before + 2*10*sizeof(double));
}


TEST(Particles, permuteMovesEveryArrayAlike)
{
    const std::vector<int> order{3, 0, 4, 1, 2};
    const int n = int(order.size());
    particles f = marked(n);
    const particles before = f;
    f.permute(order);

    const auto now = f.arrays();
    const auto then = const_cast<particles&>(before).arrays();
    for (std::size_t a = 0; a < now.size(); ++a)
    {
        ASSERT_EQ(now[a]->size(), then[a]->size());
        for (std::size_t i = 0; i < now[a]->size(); ++i)
        {
            EXPECT_EQ((*now[a])[i], (*then[a])[order[i]]);
        }
    }
    EXPECT_EQ(f.id, order);
}


TEST(Particles, permuteDropsWhoIsNotNamed)
{
    particles f = marked(6);
    f.require({&f.dH, &f.kappa});
    f.permute({5, 2});

    EXPECT_EQ(f.size(), 2);
    EXPECT_EQ(f.id, (std::vector<int>{5, 2}));
    for (particles::array* a : f.arrays())
    {
        EXPECT_TRUE(a->empty() || a->size() == 2);
    }
    EXPECT_EQ(f.dH.size(), 2u);
    EXPECT_TRUE(f.eta.empty());
}

// ************************************************************************* //
