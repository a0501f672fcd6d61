/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meltFlow.H"
#include "rheologyModel.H"
#include "StringStream.H"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

using namespace Foam;
using namespace Foam::melt;

namespace
{

//- Velocity [gamma1 H] at distances y/H from the middle of a channel, or from
//  the surface of a film, for the jump numbers 0, 10, 1e3, 1e6 and the wall
//  stresses 0.5, 0.9, 1.5, 3 [tau0]
class profiles
{
    std::vector<std::vector<double>> rows_;

public:

    profiles()
    {
        std::ifstream file
        (
            std::string(std::getenv("MELTFOAM_DIR"))
          + "/tests/unit/meltEulerian/reference/smd_poiseuille_n0.5.csv"
        );
        for (std::string line; std::getline(file, line);)
        {
            if (std::isdigit(line[0]))
            {
                std::vector<double> row;
                std::istringstream is(line);
                for (std::string entry; std::getline(is, entry, ',');)
                {
                    row.push_back(std::stod(entry));
                }
                rows_.push_back(row);
            }
        }
    }

    bool read() const
    {
        return rows_.size() == 101;
    }

    double at(const double y, const int jump, const int stress) const
    {
        return rows_[std::lround(100*y)][1 + 4*jump + stress];
    }
};


const double jumpNumbers[] = {0, 10, 1e3, 1e6}, stresses[] = {0.5, 0.9, 1.5, 3};


//- A channel or film of one cell along the flow and n across, driven along x by
//  a wall stress [tau0]; the wall is at its lower side. The film has air above
struct layer
{
    const int n;

    staggeredGrid grid;

    meltFlow flow;

    meltFlow::record record;

    static meltFlow::controls accurate()
    {
        meltFlow::controls c;
        c.solver.tolerance = 1e-12;
        c.viscosityTolerance = 1e-10;
        c.maxSweeps = 2000;
        return c;
    }

    layer(const int cells, const int air, const double stress, const double J)
    :
        n(cells),
        grid
        (
            {1, cells + air, 1},
            {1.0/cells, 1.0/cells, 1.0/cells},
            {true, true, false},
            {true, false, false}
        ),
        flow((setWalls(air), grid), accurate())
    {
        std::vector<double> alpha(grid.nCells(), 0);
        std::fill(alpha.begin(), alpha.begin() + n, 1);
        faceVelocities g;
        for (int a = 0; a < 3; ++a)
        {
            g[a].assign(grid.nFaces(a), a == 0 ? stress : 0);
        }
        std::ostringstream os;
        os.precision(17);
        os  << "type SouzaMendesDutra; tau0 1; gamma1 1; n 0.5; jumpNumber "
            << J << ';';
        const autoPtr<rheologyModel> rheology
        (
            rheologyModel::New(dictionary(IStringStream(os.str())()))
        );
        record = flow.advance
        (
            alpha,
            1,
            1e15,
            g,
            {},
            [&](const auto& rate, const auto&, auto& eta)
            {
                const std::vector<double> T(eta.size(), 300);
                rheology->eta(eta.size(), rate.data(), T.data(), eta.data());
            },
            true
        );
    }

    void setWalls(const int air)
    {
        if (!air)
        {
            grid.setWall
            (
                1,
                grid.face(1, {0, n, 0}),
                staggeredGrid::condition::slip,
                {0, 0, 0}
            );
            grid.setBlocked(std::vector<char>(grid.nCells(), 0));
        }
    }

    //- Relative error in the L2 norm
    double error(const profiles& exact, const int jump, const int stress) const
    {
        double difference = 0, norm = 0;
        for (int i = 0; i < n; ++i)
        {
            const double u =
                exact.at(1 - (i + 0.5)/n, jump, stress);
            const double e = flow.U()[0][grid.face(0, {0, i, 0})] - u;
            difference += e*e;
            norm += u*u;
        }
        return std::sqrt(difference/norm);
    }
};

} // End anonymous namespace


class MeltFlowLayer
:
    public ::testing::TestWithParam<std::tuple<int, int, int>>
{};


TEST_P(MeltFlowLayer, profileOfSecondOrder)
{
    const profiles exact;
    ASSERT_TRUE(exact.read());
    const auto [air, jump, stress] = GetParam();
    const layer coarse(5, air, stresses[stress], jumpNumbers[jump]);
    const layer fine(25, air, stresses[stress], jumpNumbers[jump]);
    ASSERT_TRUE(coarse.record.solved && fine.record.solved);
    EXPECT_LT(fine.record.change, 1e-10);

    const double error = fine.error(exact, jump, stress);
    EXPECT_LT(error, 0.01);
    EXPECT_GT
    (
        std::log(coarse.error(exact, jump, stress)/error)/std::log(5), 1.95
    );
}


INSTANTIATE_TEST_SUITE_P
(
    channelAndFilm,
    MeltFlowLayer,
    ::testing::Combine
    (
        ::testing::Values(0, 3),
        ::testing::Range(0, 4),
        ::testing::Range(0, 4)
    )
);


// Newtonian film whose surface is in the middle of a cell
TEST(MeltFlow, filmOfHalfCells)
{
    const int n = 10;
    const double d = 1.0/n;
    const staggeredGrid grid
    (
        {1, n + 3, 1}, {d, d, d}, {true, true, false}, {true, false, false}
    );
    std::vector<double> alpha(grid.nCells(), 0);
    std::fill(alpha.begin(), alpha.begin() + n, 1);
    alpha[n] = 0.5;
    faceVelocities g;
    for (int a = 0; a < 3; ++a)
    {
        g[a].assign(grid.nFaces(a), a == 0 ? 1 : 0);
    }
    meltFlow flow(grid, layer::accurate());
    const auto viscosity = [](const auto&, const auto&, auto& eta)
    {
        std::fill(eta.begin(), eta.end(), 1);
    };
    ASSERT_TRUE(flow.advance(alpha, 1, 1e15, g, {}, viscosity, false).solved);
    const double h = 1 + 0.5*d;
    for (int i = 0; i < n; ++i)
    {
        const double y = (i + 0.5)*d;
        EXPECT_NEAR(flow.U()[0][grid.face(0, {0, i, 0})], y*(h - 0.5*y), 0.002);
    }
}


// Without its dependence on the shear rate the viscosity is that at rate 0, also
// in a film that flows already
TEST(MeltFlow, viscosityAtRestWithoutShearRate)
{
    const int n = 8;
    const double d = 1.0/n;
    const staggeredGrid grid
    (
        {1, n + 2, 1}, {d, d, d}, {true, true, false}, {true, false, false}
    );
    std::vector<double> alpha(grid.nCells(), 0);
    std::fill(alpha.begin(), alpha.begin() + n, 1);
    faceVelocities g;
    for (int a = 0; a < 3; ++a)
    {
        g[a].assign(grid.nFaces(a), a == 0 ? 1 : 0);
    }
    const auto thinning = [](const auto& rate, const auto&, auto& eta)
    {
        for (std::size_t i = 0; i < eta.size(); ++i)
        {
            eta[i] = 2/(1 + rate[i]);
        }
    };
    const auto atRest = [](const auto&, const auto&, auto& eta)
    {
        std::fill(eta.begin(), eta.end(), 2);
    };
    meltFlow flow(grid, layer::accurate());
    meltFlow newtonian(grid, layer::accurate());
    for (int step = 0; step < 3; ++step)
    {
        flow.advance(alpha, 1, 0.1, g, {}, thinning, false);
        newtonian.advance(alpha, 1, 0.1, g, {}, atRest, false);
    }
    const int top = grid.face(0, {0, n - 1, 0});
    EXPECT_GT(flow.U()[0][top], 0.1);
    EXPECT_EQ(flow.U()[0][top], newtonian.U()[0][top]);
}


// A melt that nothing drives but inertia keeps its velocity in free fall
TEST(MeltFlow, fallsFreely)
{
    const staggeredGrid grid({8, 16, 8}, {1, 1, 1}, {true, true, true});
    std::vector<double> alpha(grid.nCells(), 0);
    for (int i = 3; i < 5; ++i)
    {
        for (int j = 9; j < 12; ++j)
        {
            for (int k = 2; k < 6; ++k)
            {
                alpha[grid.cell({i, j, k})] = 1;
            }
        }
    }
    faceVelocities g;
    for (int a = 0; a < 3; ++a)
    {
        g[a].assign(grid.nFaces(a), a == 1 ? -10 : 0);
    }
    meltFlow flow(grid, layer::accurate());
    const auto viscosity = [](const auto&, const auto&, auto& eta)
    {
        std::fill(eta.begin(), eta.end(), 1e6);
    };
    for (int step = 1; step <= 3; ++step)
    {
        const auto r = flow.advance(alpha, 1000, 0.01, g, {}, viscosity, false);
        ASSERT_TRUE(r.solved);
        EXPECT_NEAR(flow.U()[1][grid.face(1, {3, 10, 3})], -0.1*step, 1e-9);
        EXPECT_NEAR(flow.U()[0][grid.face(0, {4, 10, 3})], 0, 1e-9);
    }
}
