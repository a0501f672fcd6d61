/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conductionScale.H"
#include "latticeMoment.H"
#include "momentSum.H"
#include "wallDistance.H"

#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::melt;

//- Sums up M, sets the factors
class secondMomentLaw
:
    public momentLaw
{
    particles* f_;
    const wallState* walls_;
    double uniformKappa_, spacing_, least_, most_;

    double kappai_ = 0;

public:

    //- least and most [-] are the bounds of the moment
    secondMomentLaw
    (
        particles& f,
        const wallState& walls,
        const double uniformKappa,
        const double spacing,
        const double least,
        const double most
    )
    :
        f_(&f),
        walls_(&walls),
        uniformKappa_(uniformKappa),
        spacing_(spacing),
        least_(least),
        most_(most)
    {}

    void start(const int i)
    {
        kappai_ = f_->kappa.empty() ? uniformKappa_ : f_->kappa[i];
    }

    template<class Kernel>
    void addWall(const int j, const pairGeometry& p, const Kernel&)
    {
        const double heatTransfer = walls_->heatTransfer[j];
        if (heatTransfer > 0)
        {
            const wallDistance distance(*walls_, j, p, spacing_);
            M_.add(p, p.VF*distance.share(kappai_, heatTransfer));
        }
    }

    void finish(const int i)
    {
        Eigen::Matrix3d M;
        M <<
            M_.xx, M_.xy, M_.xz,
            M_.xy, M_.yy, M_.yz,
            M_.xz, M_.yz, M_.zz;
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
        solver.computeDirect(M, Eigen::EigenvaluesOnly);
        const double largest = solver.eigenvalues()[2];
        f_->conductionScale[i] =
            1/std::sqrt(std::min(std::max(largest, least_), most_));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::conductionScale::conductionScale
(
    const smoothingKernel& kernel,
    const double spacing
)
:
    full_(latticeMoment(kernel, spacing)),
    row_(rowMoment(kernel, spacing)),
    spacing_(spacing)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::conductionScale::update
(
    const neighbourhood& near,
    const wallState& walls,
    const double uniformKappa,
    particles& f
)
{
    if (near.nBuilds() == nBuilds_)
    {
        return;
    }
    nBuilds_ = near.nBuilds();

    f.require({&f.conductionScale});
    pairPass
    (
        near, walls, f,
        secondMomentLaw(f, walls, uniformKappa, spacing_, row_, full_)
    );
}

// ************************************************************************* //
