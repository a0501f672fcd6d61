/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coarseLevel.H"
#include "sphSystem.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::melt::implicitParts;
using Foam::melt::sphSystem;
using Foam::melt::trilinearGrid;
using Foam::melt::vectorArray;

constexpr int nCorners = trilinearGrid::nCorners;

using vector = Eigen::Vector3d;
using elementMatrix = Eigen::Matrix<double, 3*nCorners, 3*nCorners>;

Eigen::Matrix3d block(const Foam::symmTensor& b)
{
    Eigen::Matrix3d a;
    a <<
        b.xx(), b.xy(), b.xz(),
        b.xy(), b.yy(), b.yz(),
        b.xz(), b.yz(), b.zz();
    return a;
}


vector at(const Foam::vector& a)
{
    return vector(a.x(), a.y(), a.z());
}


//- Add what particle i gives to the matrix of its cell
void addParticle
(
    const sphSystem& system,
    const implicitParts& p,
    const double deltaT,
    const int i,
    const trilinearGrid::shape& shape,
    elementMatrix& A
)
{
    const auto& f = system.fluid;
    const int dimensions = system.near.kernel().dimensions();
    const double V = f.V[i];
    const double eta =
        p.eta ? (*p.eta)[i]
      : p.centralShare > 0 ? p.centralShare*f.eta[i]
      : 0;
    const double pressure = p.stiffness ? deltaT*V*(*p.stiffness)[i] : 0;
    const double viscous = deltaT*V*eta;
    Eigen::Matrix3d local = f.m[i]*Eigen::Matrix3d::Identity();
    if (p.centralWall)
    {
        local += deltaT*block((*p.centralWall)[i]);
    }
    const vector b =
        p.L
      ? at(implicitParts::at(*p.L, i) & (*p.viscousWall)[i])
      : vector(0, 0, 0);
    const vector bp =
        p.pressureWall ? at((*p.pressureWall)[i]) : vector(0, 0, 0);

    vector s[nCorners], q[nCorners];
    for (int a = 0; a < nCorners; ++a)
    {
        vector gradient(shape.gradient[a].data());
        if (dimensions == 2)
        {
            gradient.z() = 0;
        }
        s[a] = gradient - shape.N[a]*b;
        q[a] = gradient - shape.N[a]*bp;
    }

    for (int c = 0; c < nCorners; ++c)
    {
        const vector vs = viscous*s[c], vp = pressure*q[c];
        for (int a = 0; a <= c; ++a)
        {
            Eigen::Matrix3d k =
                shape.N[a]*shape.N[c]*local
              + vs*s[a].transpose()
              - (2.0/dimensions)*s[a]*vs.transpose()
              + q[a]*vp.transpose();
            k.diagonal().array() += s[a].dot(vs);
            A.block<3, 3>(3*a, 3*c) += k;
        }
    }
}

} // End anonymous namespace

// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

bool Foam::melt::coarseLevel::build
(
    const sphSystem& system,
    const implicitParts& parts,
    const double deltaT,
    const double cellSize
)
{
    fluid_ = &system.fluid;
    grid_.build(system.fluid, cellSize, system.near.box());

    const int nCells = grid_.nCells();
    const int n = 3*grid_.nNodes();
    constexpr int nElement = 3*nCorners;
    constexpr int nEntries = nElement*nElement;

    std::vector<Eigen::Triplet<double>> entries
    (
        std::size_t(nCells)*nEntries
    );
    #pragma omp parallel for schedule(dynamic, 4)
    for (int cell = 0; cell < nCells; ++cell)
    {
        elementMatrix A = elementMatrix::Zero();
        grid_.forMembers
        (
            system.fluid, cell,
            [&](const int i, const trilinearGrid::shape& shape)
            {
                addParticle(system, parts, deltaT, i, shape, A);
            }
        );
        A.triangularView<Eigen::StrictlyLower>() =
            A.transpose().triangularView<Eigen::StrictlyLower>();

        const std::array<int, nCorners>& corners = grid_.corners(cell);
        for (int row = 0; row < nElement; ++row)
        {
            for (int column = 0; column < nElement; ++column)
            {
                entries[std::size_t(cell)*nEntries + nElement*row + column] =
                {
                    3*corners[row/3] + row%3,
                    3*corners[column/3] + column%3,
                    A(row, column)
                };
            }
        }
    }

    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());

    // Motions of nodes that move no particle have no inertia and no stress
    constexpr double roundOff = 1e-12;
    for (int row = 0; row < n; ++row)
    {
        double& diagonal = A.coeffRef(row, row);
        diagonal = diagonal > 0 ? (1 + roundOff)*diagonal : 1;
    }

    A.makeCompressed();
    nodes_.resize(n);
    return factors_.compute(A);
}


void Foam::melt::coarseLevel::solveNodes(const vectorArray& r)
{
    grid_.restrict(*fluid_, r, nodes_.data());
    factors_.solve(nodes_);
}


std::size_t Foam::melt::coarseLevel::bytes() const
{
    return
        grid_.bytes() + sizeof(double)*nodes_.size() + factors_.bytes();
}

// ************************************************************************* //
