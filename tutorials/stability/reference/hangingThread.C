/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Length of the thread of hard case 05 by finite elements: a square prism of an
    incompressible Newtonian liquid hangs from a plane that it sticks to, and
    draws out by its weight; no surface tension. A quarter of it, trilinear
    pressure and triquadratic velocity (Taylor & Hood), on a mesh that moves with
    the liquid; the mesh by the midpoint rule,
    inertia by backward Euler.

        g++ -O2 -I/usr/include/eigen3 hangingThread.C -o hangingThread
        ./hangingThread [elements across half the width [along [step [density]]]]

    Prints time, length (mean of the lower face) and its ratio to that of the
    slender thread without inertia, -ln(1 - a L0 t)/(a t), a = rho g/(3 eta).
    The density is that of inertia alone, the weight stays. As the inertia of the
    start decays in 5 ms, the length converges in steps below that: 69.58, 69.64,
    69.69, 69.72, 69.74 mm at 0.15 s and 79.22, 79.30, 79.36, 79.41, 79.44 at 0.25 s
    in steps of 10, 5, 2.5, 1.25, 0.625 ms with 2 x 2 x 10 elements, of which 69.77 and
    79.47 is the limit; 3 x 3 x 16 elements add 0.005 and 0.01 mm.

\*---------------------------------------------------------------------------*/

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <Eigen/SparseLU>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using vectors = std::vector<Vector3d>;

// The case: half width, length [m], viscosity [Pa s], weight [N/m3], end [s]
constexpr double halfWidth = 0.0075, length0 = 0.06, eta = 100;
constexpr double weight = 9810, end = 0.25;

class thread
{
    const int n_, nz_;
    const double rho_;

    vectors x_, u_;

    // Unknown of each component of velocity, -1: none; how many of them
    std::vector<int> unknown_;
    int nUnknowns_ = 0;

    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver_;
    bool analysed_ = false;

    int across() const { return 2*n_ + 1; }
    int along() const { return 2*nz_ + 1; }

    int node(const int i, const int j, const int k) const
    {
        return (k*across() + j)*across() + i;
    }

    static std::array<double, 3> quadratic(const double s)
    {
        return {s*(s - 1)/2, 1 - s*s, s*(s + 1)/2};
    }

    static std::array<double, 3> derivative(const double s)
    {
        return {s - 0.5, -2*s, s + 0.5};
    }

    // Velocities after h [s] on the mesh x, from u_
    vectors solve(const vectors& x, const double h);

public:

    thread(const int n, const int nz, const double rho);

    void step(const double dt);

    double length() const;
};


thread::thread(const int n, const int nz, const double rho)
:
    n_(n),
    nz_(nz),
    rho_(rho)
{
    // Finer at the faces and at the top
    for (int k = 0; k < along(); ++k)
    for (int j = 0; j < across(); ++j)
    for (int i = 0; i < across(); ++i)
    {
        const double p = double(i)/(across() - 1), q = double(j)/(across() - 1);
        const double s = double(k)/(along() - 1);
        x_.push_back
        ({
            halfWidth*(1.3*p - 0.3*p*p),
            halfWidth*(1.3*q - 0.3*q*q),
            -length0*(0.35*s + 0.65*s*s)
        });
        const bool stuck = k == 0;
        for (const bool fixed : {stuck || i == 0, stuck || j == 0, stuck})
        {
            unknown_.push_back(fixed ? -1 : nUnknowns_++);
        }
    }
    u_.assign(x_.size(), Vector3d::Zero());
}


vectors thread::solve(const vectors& x, const double h)
{
    const int P = n_ + 1;
    const int nAll = nUnknowns_ + P*P*(nz_ + 1);
    const double points[] = {-std::sqrt(0.6), 0, std::sqrt(0.6)};
    const double weights[] = {5.0/9, 8.0/9, 5.0/9};
    // Brings the two blocks to similar sizes
    const double scale = eta;

    std::vector<Eigen::Triplet<double>> entries;
    VectorXd right = VectorXd::Zero(nAll);
    for (int ek = 0; ek < nz_; ++ek)
    for (int ej = 0; ej < n_; ++ej)
    for (int ei = 0; ei < n_; ++ei)
    {
        int nodes[27], corners[8];
        for (int a = 0; a < 27; ++a)
        {
            nodes[a] = node(2*ei + a%3, 2*ej + a/3%3, 2*ek + a/9);
        }
        for (int a = 0; a < 8; ++a)
        {
            corners[a] = ((ek + a/4)*P + ej + a/2%2)*P + ei + a%2;
        }

        MatrixXd K = MatrixXd::Zero(81, 81), B = MatrixXd::Zero(8, 81);
        VectorXd f = VectorXd::Zero(81);
        for (int q = 0; q < 27; ++q)
        {
            const int at[] = {q%3, q/3%3, q/9};
            std::array<double, 3> N[3], D[3];
            for (int d = 0; d < 3; ++d)
            {
                N[d] = quadratic(points[at[d]]);
                D[d] = derivative(points[at[d]]);
            }
            double value[27];
            Vector3d gradient[27];
            Matrix3d J = Matrix3d::Zero();
            for (int a = 0; a < 27; ++a)
            {
                const int i = a%3, j = a/3%3, k = a/9;
                value[a] = N[0][i]*N[1][j]*N[2][k];
                gradient[a] =
                {
                    D[0][i]*N[1][j]*N[2][k],
                    N[0][i]*D[1][j]*N[2][k],
                    N[0][i]*N[1][j]*D[2][k]
                };
                J += x[nodes[a]]*gradient[a].transpose();
            }
            const double dV =
                std::abs(J.determinant())
               *weights[at[0]]*weights[at[1]]*weights[at[2]];
            const Matrix3d toSpace(J.inverse().transpose());
            for (Vector3d& g : gradient)
            {
                g = toSpace*g;
            }

            for (int a = 0; a < 27; ++a)
            {
                for (int b = 0; b < 27; ++b)
                {
                    const double mass = dV*rho_/h*value[a]*value[b];
                    K.block<3, 3>(3*a, 3*b) +=
                        (mass + dV*eta*gradient[a].dot(gradient[b]))
                       *Matrix3d::Identity()
                      + dV*eta*gradient[b]*gradient[a].transpose();
                    f.segment<3>(3*a) += mass*u_[nodes[b]];
                }
                f[3*a + 2] -= dV*weight*value[a];
                for (int p = 0; p < 8; ++p)
                {
                    double corner = 1;
                    for (int d = 0; d < 3; ++d)
                    {
                        const double s = points[at[d]];
                        corner *= (p >> d & 1 ? 1 + s : 1 - s)/2;
                    }
                    B.block<1, 3>(p, 3*a) -=
                        scale*dV*corner*gradient[a].transpose();
                }
            }
        }

        for (int a = 0; a < 81; ++a)
        {
            const int row = unknown_[3*nodes[a/3] + a%3];
            if (row < 0)
            {
                continue;
            }
            right[row] += f[a];
            for (int b = 0; b < 81; ++b)
            {
                const int column = unknown_[3*nodes[b/3] + b%3];
                if (column >= 0)
                {
                    entries.emplace_back(row, column, K(a, b));
                }
            }
            for (int p = 0; p < 8; ++p)
            {
                const int column = nUnknowns_ + corners[p];
                entries.emplace_back(row, column, B(p, a));
                entries.emplace_back(column, row, B(p, a));
            }
        }
    }
    Eigen::SparseMatrix<double> A(nAll, nAll);
    A.setFromTriplets(entries.begin(), entries.end());
    if (!analysed_)
    {
        solver_.analyzePattern(A);
        analysed_ = true;
    }
    solver_.factorize(A);
    const VectorXd solution = solver_.solve(right);

    vectors u(u_.size(), Vector3d::Zero());
    for (std::size_t c = 0; c < unknown_.size(); ++c)
    {
        if (unknown_[c] >= 0)
        {
            u[c/3][c%3] = solution[unknown_[c]];
        }
    }
    return u;
}


void thread::step(const double dt)
{
    // u_ is that of the middle of the step before, or of the start
    const double h = u_.back().isZero() ? dt/2 : dt;
    vectors u(u_);
    for (int iteration = 0; iteration < 2; ++iteration)
    {
        vectors middle(x_);
        for (std::size_t i = 0; i < middle.size(); ++i)
        {
            middle[i] += dt/2*u[i];
        }
        u = solve(middle, h);
    }
    u_ = u;
    for (std::size_t i = 0; i < x_.size(); ++i)
    {
        x_[i] += dt*u_[i];
    }
}


double thread::length() const
{
    double sum = 0, area = 0;
    const int k = along() - 1;
    for (int j = 0; j + 1 < across(); ++j)
    for (int i = 0; i + 1 < across(); ++i)
    {
        const Vector3d& a = x_[node(i, j, k)];
        const Vector3d& b = x_[node(i + 1, j, k)];
        const Vector3d& c = x_[node(i, j + 1, k)];
        const Vector3d& d = x_[node(i + 1, j + 1, k)];
        const double part = (d - a).cross(c - b).norm();
        sum -= part*(a + b + c + d).z()/4;
        area += part;
    }
    return sum/area;
}


int main(int argc, char* argv[])
{
    const int n = argc > 1 ? std::atoi(argv[1]) : 2;
    const int nz = argc > 2 ? std::atoi(argv[2]) : 10;
    const double dt = argc > 3 ? std::atof(argv[3]) : 6.25e-4;
    thread liquid(n, nz, argc > 4 ? std::atof(argv[4]) : 1000);
    const double a = weight/(3*eta);
    for (int s = 1; s*dt < end + dt/2; ++s)
    {
        liquid.step(dt);
        const double t = s*dt, slender = -std::log(1 - a*length0*t)/(a*t);
        std::printf
        (
            "%g s: %.6f m, over the slender thread's %.4f\n",
            t, liquid.length(), liquid.length()/slender
        );
    }
}

// ************************************************************************* //
