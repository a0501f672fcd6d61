/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceHeating.H"
#include "boundBox.H"
#include "pairPass.H"

#include <unordered_set>

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::melt;

// |grad C| h from which a particle is at the surface
constexpr double least = 0.1;


//- |grad C| [1/m] of the particles in the layers below the flat surface of a
//  lattice, from the first layer on
std::vector<double> gradientsOfLayers
(
    const smoothingKernel& kernel,
    const double spacing
)
{
    // What each plane of the lattice adds to a particle that many layers away
    const int n = int(kernel.support()/spacing);
    const int nAcross = kernel.dimensions() == 3 ? n : 0;
    const double V = std::pow(spacing, kernel.dimensions());
    std::vector<double> plane(n + 1, 0);
    kernel.visit([&](const auto& W)
    {
        for (int k = 1; k <= n; ++k)
        {
            for (int a = -n; a <= n; ++a)
            {
                for (int b = -nAcross; b <= nAcross; ++b)
                {
                    const double r2 = (a*a + b*b + k*k)*spacing*spacing;
                    plane[k] -= V*k*spacing*W.gradientOverR(r2);
                }
            }
        }
    });

    // Planes above cancel as many below
    std::vector<double> result(n, 0);
    for (int layer = 0; layer < n; ++layer)
    {
        for (int k = layer + 1; k <= n; ++k)
        {
            result[layer] += plane[k];
        }
    }
    return result;
}


//- Sums up grad C of each particle [1/m]
class colourGradientLaw
{
    std::vector<vector>* gradient_;

    double x_ = 0, y_ = 0, z_ = 0;

public:

    explicit colourGradientLaw(std::vector<vector>& gradient)
    :
        gradient_(&gradient)
    {}

    void start(const int)
    {}

    template<class Kernel>
    void add(const int, const pairGeometry& p, const Kernel&)
    {
        x_ += p.VF*p.dx;
        y_ += p.VF*p.dy;
        z_ += p.VF*p.dz;
    }

    template<class Kernel>
    void addWall(const int j, const pairGeometry& p, const Kernel& W)
    {
        add(j, p, W);
    }

    void finish(const int i)
    {
        (*gradient_)[i] = vector(x_, y_, z_);
    }
};


//- Voxels of one spacing that hold a particle
class particleShade
:
    public occlusion
{
    const scalar edge_, from_;

    boundBox box_;

    std::unordered_set<std::int64_t> occupied_;

    std::int64_t key(const point& p) const
    {
        const vector v((p - box_.min())/edge_);
        const std::int64_t stride = 1 << 20;
        return
            (std::int64_t(v.x())*stride + std::int64_t(v.y()))*stride
          + std::int64_t(v.z());
    }

public:

    particleShade(const particles& f, const scalar spacing, const scalar from)
    :
        edge_(spacing),
        from_(from),
        box_(boundBox::invertedBox)
    {
        for (int i = 0; i < f.size(); ++i)
        {
            box_.add(point(f.x[i], f.y[i], f.z[i]));
        }
        for (int i = 0; i < f.size(); ++i)
        {
            occupied_.insert(key(point(f.x[i], f.y[i], f.z[i])));
        }
    }

    virtual boolList blocked
    (
        const surfaceElements& elements,
        const labelList& set,
        const pointField& to
    ) const
    {
        boolList result(set.size(), false);
        #pragma omp parallel for schedule(dynamic, 64)
        for (label k = 0; k < set.size(); ++k)
        {
            const point& start = elements.position[set[k]];
            const vector way(to[k] - start);
            const scalar length = mag(way);
            for (scalar s = from_; s < length; s += 0.5*edge_)
            {
                const point p(start + s/length*way);
                if (!box_.contains(p))
                {
                    break;
                }
                if (occupied_.count(key(p)))
                {
                    result[k] = true;
                    break;
                }
            }
        }
        return result;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::surfaceHeating::surfaceHeating
(
    const dictionary& meltProperties,
    sphSystem& system
)
:
    system_(system),
    sources_(meltProperties)
{
    const smoothingKernel& kernel = system.near.kernel();
    const double spacing = system.spacing;
    double counted = 0;
    for (const double gradient : gradientsOfLayers(kernel, spacing))
    {
        counted += gradient*kernel.h() >= least ? gradient*spacing : 0;
    }
    areaFactor_ = 1/counted;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::melt::surfaceElements Foam::melt::surfaceHeating::elements()
{
    const particles& f = system_.fluid;
    std::vector<vector> gradient(f.size());
    pairPass
    (
        system_.near, system_.walls, f, colourGradientLaw(gradient)
    );

    particle_.clear();
    for (int i = 0; i < f.size(); ++i)
    {
        if (mag(gradient[i])*system_.near.kernel().h() >= least)
        {
            particle_.push_back(i);
        }
    }
    const label n = label(particle_.size());
    surfaceElements e;
    e.position.resize(n);
    e.normal.resize(n);
    e.area.resize(n);
    e.T.resize(n);
    forAll(e.position, k)
    {
        const int i = particle_[k];
        const scalar size = mag(gradient[i]);
        e.position[k] = point(f.x[i], f.y[i], f.z[i]);
        e.normal[k] = -gradient[i]/size;
        e.area[k] = areaFactor_*f.V[i]*size;
        e.T[k] = f.T[i];
    }
    e.smoothArea = e.area;
    e.free = boolList(n, true);
    return e;
}


Foam::scalar Foam::melt::surfaceHeating::heat
(
    const scalar time,
    const scalar deltaT
)
{
    sources_.update();
    if (!active())
    {
        return 0;
    }
    particles& f = system_.fluid;
    const enthalpyCurve curve = system_.thermo.enthalpy();

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < f.size(); ++i)
    {
        f.V[i] = f.m[i]/f.rho[i];
        f.T[i] = curve.T(f.h[i]);
    }

    const surfaceElements e(elements());
    const absorbedHeat absorbed
    (
        sources_.heatSurface
        (
            time,
            e,
            particleShade(f, system_.spacing, system_.near.kernel().support())
        )
    );

    scalar sum = 0;
    forAll(e.position, k)
    {
        const int i = particle_[k];
        const scalar heat =
            deltaT*absorbed.power[k]
           /(1 + absorbed.slope[k]*deltaT/(f.m[i]*curve.Cp(f.h[i])));
        f.h[i] += heat/f.m[i];
        sum += heat;
    }

    if (sources_.inVolume())
    {
        pointField positions(f.size());
        scalarField volumes(f.size());
        forAll(positions, i)
        {
            positions[i] = point(f.x[i], f.y[i], f.z[i]);
            volumes[i] = f.V[i];
        }
        const scalarField power(sources_.heatVolume(time, positions, volumes));
        forAll(power, i)
        {
            f.h[i] += deltaT*power[i]/f.m[i];
            sum += deltaT*power[i];
        }
    }
    return sum;
}

// ************************************************************************* //
