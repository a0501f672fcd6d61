/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carriedEnthalpy.H"
#include "fvcSurfaceIntegrate.H"
#include "meltScene/scene/sceneCase.H"
#include "meltUnitTests.H"

#include <cmath>

using namespace Foam;
using namespace Foam::melt;
using unitTest::sceneCase;

namespace
{

//- A box of 1 m full of melt that moves together
class stream
{
    sceneCase files_;

    autoPtr<meltScene> scene_;

    autoPtr<eulerianMesh> mesh_;

    autoPtr<carriedEnthalpy> carried_;

public:

    scalarField alpha, h;

    autoPtr<surfaceScalarField> volume;

    stream
    (
        const scalar dx,
        const vector& U,
        const std::function<scalar(const point&)>& enthalpy,
        const std::string& scheme = ""
    )
    {
        if (scheme.size())
        {
            files_.set
            (
                "system/eulerian/fvSchemes",
                "ddtSchemes {} gradSchemes { default Gauss linear; }"
                " divSchemes { div(phi,h) " + scheme + "; }"
                " laplacianSchemes {} snGradSchemes {}"
                " interpolationSchemes { default linear; }"
            );
        }
        scene_.reset(new meltScene(files_.mesh(), dx));
        mesh_.reset(new eulerianMesh(*scene_));
        carried_.reset(new carriedEnthalpy(*mesh_));
        const fvMesh& m = mesh();
        alpha.setSize(m.nCells(), 1);
        for (const point& c : m.C().primitiveField())
        {
            h.append(enthalpy(c));
        }
        volume.reset
        (
            new surfaceScalarField
            (
                "phi", m.Sf() & dimensionedVector("U", dimVelocity, U)
            )
        );
    }

    const fvMesh& mesh() const
    {
        return mesh_->mesh();
    }

    eulerianMesh& onGrid()
    {
        return *mesh_;
    }

    tmp<surfaceScalarField> faces(const scalar deltaT)
    {
        return carried_->at(alpha, h, *volume, deltaT);
    }

    void step(const scalar deltaT)
    {
        const tmp<volScalarField> out
        (
            fvc::surfaceIntegrate(faces(deltaT)**volume)
        );
        const tmp<volScalarField> net(fvc::surfaceIntegrate(*volume));
        h -= deltaT*(out().primitiveField() - h*net().primitiveField());
    }
};


//- Greatest difference from the mean over a step of what goes through the inner
//  faces normal to x, for h = exp(2 x), at a Courant number of 0.4
scalar differs(const scalar dx, const std::string& scheme)
{
    const scalar U = 0.5, deltaT = 0.4*dx/U;
    stream s
    (
        dx, vector(U, 0, 0), [](const point& c) { return std::exp(2*c.x()); },
        scheme
    );
    const tmp<surfaceScalarField> faces(s.faces(deltaT));
    scalar greatest = 0;
    forAll(s.mesh().neighbour(), facei)
    {
        const point& c = s.mesh().faceCentres()[facei];
        const vector& S = s.mesh().faceAreas()[facei];
        if (c.x() > 0.25 && c.x() < 0.75 && mag(S.x()) > 0.5*mag(S))
        {
            const scalar exact =
                (std::exp(2*c.x()) - std::exp(2*(c.x() - U*deltaT)))
               /(2*U*deltaT);
            greatest = max(greatest, mag(faces()[facei] - exact));
        }
    }
    return greatest;
}

} // End anonymous namespace


TEST(CarriedEnthalpy, secondOrderWhereSmooth)
{
    EXPECT_NEAR
    (
        std::log2(differs(0.1, "") / differs(0.05, "")), 2, 0.2
    );
    EXPECT_NEAR
    (
        std::log2
        (
            differs(0.1, "Gauss upwind")/differs(0.05, "Gauss upwind")
        ),
        1,
        0.2
    );
    EXPECT_LT(differs(0.05, ""), 0.1*differs(0.05, "Gauss upwind"));
}


// A hot block that moves across the grid: nothing comes above or below it
TEST(CarriedEnthalpy, bounded)
{
    for
    (
        const vector& U :
        {
            vector(1, 0, 0), vector(-1, 0, 0), vector(1, 1, 0),
            vector(1, 0.6, -0.8)
        }
    )
    {
        stream s
        (
            0.05, U, [](const point& c)
            {
                return cmptMax(cmptMag(c - vector::one/2)) < 0.2 ? 2e5 : 1e5;
            }
        );
        for (label step = 0; step < 20; ++step)
        {
            s.step(0.4*0.05/cmptMax(cmptMag(U)));
            ASSERT_LE(max(s.h), 2e5*(1 + 1e-12))
                << U.x() << ' ' << U.y() << ' ' << U.z() << ", step " << step;
            ASSERT_GE(min(s.h), 1e5*(1 - 1e-12))
                << U.x() << ' ' << U.y() << ' ' << U.z() << ", step " << step;
        }
        EXPECT_LT(min(s.h) + 1e3, max(s.h));
    }
}


// Beside air and solid melt the slope is not known: what is there leaves
TEST(CarriedEnthalpy, upwindAtSurfaceAndSolid)
{
    for (const bool air : {true, false})
    {
        stream s(0.1, vector(1, 0, 0), [](const point& c) { return c.x(); });
        std::vector<char> blocked(s.mesh().nCells(), 0);
        forAll(s.alpha, celli)
        {
            if (s.mesh().C()[celli].x() < 0.4)
            {
                s.alpha[celli] = air ? 0 : 1;
                blocked[s.onGrid().gridCell(celli)] = !air;
            }
        }
        s.onGrid().grid().setBlocked(blocked);
        const tmp<surfaceScalarField> faces(s.faces(0.04));
        forAll(s.mesh().neighbour(), facei)
        {
            const scalar x = s.mesh().faceCentres()[facei].x();
            if
            (
                mag(s.mesh().faceAreas()[facei].x()) > SMALL
             && x > 0.45 && x < 0.85
            )
            {
                EXPECT_NEAR
                (
                    faces()[facei], x - 0.05 + (x > 0.55 ? 0.03 : 0), 1e-9
                ) << x;
            }
        }
    }
}
