/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatSources.H"
#include "vents.H"
#include "mathematicalConstants.H"
#include "meltUnitTests.H"
#include "StringStream.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::melt;
using constant::mathematical::pi;

namespace
{

//- Nothing is in the way, or everything
class sky
:
    public occlusion
{
    const bool dark_;

public:

    explicit sky(const bool dark = false)
    :
        dark_(dark)
    {}

    virtual boolList blocked
    (
        const surfaceElements&,
        const labelList& set,
        const pointField&
    ) const
    {
        return boolList(set.size(), dark_);
    }
};


//- Square plate z = 0 around the origin, facing +z, n x n elements
surfaceElements plate(const scalar edge, const label n, const scalar T = 300)
{
    surfaceElements e;
    const scalar dx = edge/n;
    e.position.resize(n*n);
    forAll(e.position, i)
    {
        e.position[i] =
            point((i/n + 0.5)*dx - 0.5*edge, (i % n + 0.5)*dx - 0.5*edge, 0);
    }
    e.normal = vectorField(n*n, vector(0, 0, 1));
    e.area = scalarField(n*n, sqr(dx));
    e.smoothArea = e.area;
    e.T = scalarField(n*n, T);
    e.free = boolList(n*n, true);
    return e;
}


dictionary scene(const string& sources)
{
    return dictionary(IStringStream("heatSources { " + sources + " }")());
}


absorbedHeat heat
(
    const string& sources,
    const surfaceElements& e,
    const scalar time = 0,
    const bool dark = false
)
{
    const dictionary dict(scene(sources));
    return heatSources(dict).heatSurface(time, e, sky(dark));
}

} // End anonymous namespace


// q = P H/(4 pi (H^2 + r^2)^(3/2))
TEST(PointSource, lightsAPlate)
{
    const scalar P = 100, H = 0.1;
    const surfaceElements e(plate(0.4, 100));
    const absorbedHeat a
    (
        heat("lamp { type pointSource; position (0 0 0.1); power 100; }", e)
    );
    scalar disc = 0;
    forAll(e.position, i)
    {
        const scalar r2 = magSqr(e.position[i]);
        EXPECT_NEAR
        (
            a.power[i]/e.area[i]*4*pi*std::pow(H*H + r2, 1.5)/(P*H), 1, 1e-10
        );
        disc += r2 < sqr(0.1) ? a.power[i] : 0;
    }
    EXPECT_NEAR(disc/(0.5*P*(1 - H/std::sqrt(2*H*H))), 1, 0.01);
}


// A closed box around the lamp, facing inwards, absorbs all of the power
TEST(PointSource, powerGoesSomewhere)
{
    surfaceElements e;
    for (label side = 0; side < 6; ++side)
    {
        const surfaceElements p(plate(1, 40));
        forAll(p.position, i)
        {
            const vector in(p.position[i] + vector(0, 0, -0.5));
            const label k = side/2;
            const scalar sign = side % 2 ? 1 : -1;
            vector position(Zero), normal(Zero);
            position[k] = sign*in.z();
            position[(k + 1) % 3] = in.x();
            position[(k + 2) % 3] = in.y();
            normal[k] = sign;
            e.position.append(position);
            e.normal.append(normal);
            e.area.append(p.area[i]);
            e.smoothArea.append(p.area[i]);
            e.T.append(300);
            e.free.append(true);
        }
    }
    const absorbedHeat a
    (
        heat
        (
            "lamp { type pointSource; position (0.1 -0.2 0.15); power 7;"
            " absorptivity 0.5; }",
            e
        )
    );
    EXPECT_NEAR(sum(a.power)/3.5, 1, 0.01);
}


TEST(PointSource, lightsNothingInShadeBehindOrSwitchedOff)
{
    const surfaceElements e(plate(0.4, 10));
    const string lamp("type pointSource; power 100; ");
    EXPECT_EQ(sum(heat("a {" + lamp + "position (0 0 1);}", e, 0, true).power), 0);
    EXPECT_EQ(sum(heat("a {" + lamp + "position (0 0 -1);}", e).power), 0);
    EXPECT_EQ
    (
        sum(heat("a {" + lamp + "position (0 0 1); active no;}", e).power), 0
    );
    EXPECT_GT(sum(heat("a {" + lamp + "position (0 0 1);}", e).power), 0);
    // At an element: no more than all of the power
    const absorbedHeat a(heat("a {" + lamp + "position (0.02 0.02 1e-9);}", e));
    EXPECT_LE(max(a.power), 100);
}


TEST(Oven, convectsAndRadiates)
{
    const surfaceElements e(plate(1, 4, 400));
    const absorbedHeat a
    (
        heat("o { type oven; temperature 300; h 10; emissivity 0.8; }", e)
    );
    const scalar sigma = 5.670374419e-8;
    EXPECT_NEAR
    (
        sum(a.power), -10*100 + 0.8*sigma*(pow4(300.0) - pow4(400.0)), 1e-9
    );
    EXPECT_GT(min(a.slope), 0);
}


// Half a cell of melt before the surface: h and kappa/d in series
TEST(Oven, behindAResistance)
{
    surfaceElements e(plate(1, 4, 400));
    const scalar h = 20, kappa = 0.5, d = 0.01;
    e.resistance = d/(kappa*e.smoothArea);
    const absorbedHeat absorbed
    (
        heat("a { type oven; temperature 500; h 20; }", e)
    );
    const scalar inSeries = 1/(1/h + d/kappa);
    EXPECT_NEAR(sum(absorbed.power), inSeries*100, 1e-9);
    EXPECT_NEAR(sum(absorbed.slope), inSeries, 1e-11);
}


TEST(HotPlate, heatsWhatIsInItsBox)
{
    surfaceElements e(plate(1, 10, 300));
    e.free = false;
    const absorbedHeat a
    (
        heat
        (
            "p { type hotPlate; box ((-0.5 -0.5 -0.1) (0 0.5 0.1));"
            " temperature 350; h 20; }",
            e
        )
    );
    EXPECT_NEAR(sum(a.power), 0.5*20*50, 1e-9);
}


TEST(MovingLaser, absorbsItsPowerWhereItIs)
{
    const surfaceElements e(plate(0.1, 200));
    const string laser
    (
        "l { type movingLaser; direction (0 0 -1); power 50; radius 0.01;"
        " position table ((0 (-0.02 0 0)) (1 (0.02 0 0))); }"
    );
    for (const scalar time : {0.0, 0.5, 1.0})
    {
        const absorbedHeat a(heat(laser, e, time));
        EXPECT_NEAR(sum(a.power), 50, 0.01);
        EXPECT_NEAR
        (
            sum(a.power*e.position.component(0))/sum(a.power),
            -0.02 + 0.04*time,
            1e-4
        );
    }
}


TEST(VolumetricSource, heatsVolumes)
{
    const dictionary dict
    (
        scene
        (
            "v { type volumetricSource; box ((0 0 0) (1 1 1));"
            " powerDensity table ((0 0) (10 100)); }"
        )
    );
    const heatSources sources(dict);
    EXPECT_TRUE(sources.inVolume());
    const scalarField power
    (
        sources.heatVolume
        (
            5,
            pointField({point(0.5, 0.5, 0.5), point(2, 0, 0)}),
            scalarField(2, 0.2)
        )
    );
    EXPECT_NEAR(power[0], 10, 1e-12);
    EXPECT_EQ(power[1], 0);
}


TEST(HeatSources, areReadAgainWhenTheyChange)
{
    dictionary dict(scene("o { type oven; temperature 300; h 10; }"));
    heatSources sources(dict);
    EXPECT_FALSE(sources.update());
    dict.subDict("heatSources").subDict("o").set("active", false);
    EXPECT_TRUE(sources.update());
    EXPECT_FALSE(sources[0].active());
    const dictionary none;
    EXPECT_TRUE(heatSources(none).empty());
}


TEST(HeatSources, wrongInputIsRejected)
{
    for
    (
        const char* wrong
      : {
            "a { type candle; }",
            "a { type pointSource; position (0 0 1); power -1; }",
            "a { type pointSource; position (0 0 1); power 1; absorptivity 2; }",
            "a { type pointSource; power 1; }",
            "a { type oven; temperature -3; }",
            "a { type oven; temperature 300; emissivity 1.1; }",
            "a { type hotPlate; box ((0 0 0) (0 0 0)); temperature 300; h 1; }",
            "a { type movingLaser; position (0 0 0); direction (0 0 0);"
            " power 1; radius 1; }",
            "a { type movingLaser; position (0 0 0); direction (0 0 1);"
            " power 1; radius 0; }"
        }
    )
    {
        const dictionary dict(scene(wrong));
        EXPECT_THROW(heatSources{dict}, error) << wrong;
    }
}


TEST(Vents, rateIsAFunctionOfTime)
{
    const dictionary dict
    (
        IStringStream
        (
            "vents { a { position (1 2 3); radius 2; temperature 1400;"
            " rate table ((0 0) (10 50)); } }"
        )()
    );
    const vents v(dict);
    ASSERT_EQ(v.size(), 1);
    EXPECT_NEAR(v[0].rate(5), 25, 1e-12);
    const dictionary wrong
    (
        IStringStream
        (
            "vents { a { position (1 2 3); radius 0; temperature 1400;"
            " rate 1; } }"
        )()
    );
    EXPECT_THROW(vents{wrong}, error);
}

// ************************************************************************* //
