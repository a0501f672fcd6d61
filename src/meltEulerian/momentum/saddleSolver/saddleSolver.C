/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "saddleSolver.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::melt::saddleSolver;
using matrix = saddleSolver::matrix;
using vector = saddleSolver::vector;

// Part of C in the factors: the smaller, the fewer refinements; the larger,
// the fewer digits are lost
const double epsilon = 1e-7;

const int maxRefinements = 30;

// Refined to that part of the tolerance as long as it helps, which costs little
// beside the factors: what is left of div U is liquid without room
const double polish = 1e-4;

// Residual that rounding leaves of terms that cancel, relative to them
const double rounding = 1e-13;

using factors = Eigen::IncompleteCholesky<double>;


//- Residuals of both equations
void residual
(
    const saddleSolver::system& s,
    const vector& u,
    const vector& p,
    vector& ru,
    vector& rp
)
{
    ru = s.f - s.A*u + s.B.transpose()*p;
    rp = s.g + s.B*u;
}


//- The norm in which the preconditioner without its factors would measure
double norm
(
    const saddleSolver::system& s,
    const vector& diagonalA,
    const vector& ru,
    const vector& rp
)
{
    return std::sqrt
    (
        (ru.array().square()/diagonalA.array()).sum()
      + (rp.array().square()/s.C.array()).sum()
    );
}


//- Block preconditioner of MINRES
class preconditioner
{
    const saddleSolver::system& s_;

    factors A_, L_;

    bool good_;

public:

    explicit preconditioner(const saddleSolver::system& s)
    :
        s_(s),
        A_(s.A)
    {
        const matrix L
        (
            s.B*s.M.cwiseMax(1e-300).cwiseInverse().asDiagonal()
           *s.B.transpose()
        );
        L_.compute(L);
        good_ = A_.info() == Eigen::Success && L_.info() == Eigen::Success;
    }

    bool good() const
    {
        return good_;
    }

    void apply
    (
        const vector& ru,
        const vector& rp,
        vector& zu,
        vector& zp
    ) const
    {
        zu = A_.solve(ru);
        zp = L_.solve(rp);
        zp.array() += rp.array()/s_.C.array();
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::melt::saddleSolver::direct(const system& s, vector& u, vector& p)
{
    const Eigen::Index nu = s.f.size(), np = s.g.size();
    method_ = "direct";
    int refinements = 0;

    // Lower triangle
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(s.A.nonZeros() + s.B.nonZeros() + np);
    for (int j = 0; j < s.A.outerSize(); ++j)
    {
        for (matrix::InnerIterator it(s.A, j); it; ++it)
        {
            if (it.row() >= it.col())
            {
                entries.emplace_back(it.row(), it.col(), it.value());
            }
        }
    }
    for (int j = 0; j < s.B.outerSize(); ++j)
    {
        for (matrix::InnerIterator it(s.B, j); it; ++it)
        {
            entries.emplace_back(nu + it.row(), it.col(), -it.value());
        }
    }
    for (Eigen::Index i = 0; i < np; ++i)
    {
        entries.emplace_back(nu + i, nu + i, -epsilon*s.C[i]);
    }
    matrix K(nu + np, nu + np);
    K.setFromTriplets(entries.begin(), entries.end());

    const Eigen::SimplicialLDLT<matrix, Eigen::Lower> ldlt(K);
    if (ldlt.info() != Eigen::Success)
    {
        return false;
    }

    const vector diagonal(s.A.diagonal());
    u.setZero();
    p.setZero();
    vector ru(s.f), rp(s.g), r(nu + np);
    const double start = norm(s, diagonal, ru, rp);
    if (start == 0)
    {
        return true;
    }
    double last = 1, before = 4;
    while
    (
        last > polish*controls_.tolerance
     && last < 0.5*before
     && refinements++ < maxRefinements
    )
    {
        r << ru, rp;
        const vector delta(ldlt.solve(r));
        u += delta.head(nu);
        p += delta.tail(np);
        residual(s, u, p, ru, rp);
        before = last;
        last = norm(s, diagonal, ru, rp)/start;
        history_.push_back(last);
    }

    // A stiff melt's forces cancel to what drives it: no better than they are
    // rounded
    const vector forces
    (
        s.f.cwiseAbs() + s.A.cwiseAbs()*u.cwiseAbs()
      + s.B.cwiseAbs().transpose()*p.cwiseAbs()
    );
    const vector fluxes(s.g.cwiseAbs() + s.B.cwiseAbs()*u.cwiseAbs());
    return
        last <= controls_.tolerance
     || last*start <= rounding*norm(s, diagonal, forces, fluxes);
}


bool Foam::melt::saddleSolver::iterate(const system& s, vector& u, vector& p)
{
    method_ = "MINRES";
    const preconditioner P(s);
    if (!P.good())
    {
        return false;
    }

    // Lanczos vectors v, z = P v, and directions d, of velocity and pressure
    vector zu, zp, vu, vp, vuOld, vpOld, du, dp, duOld, dpOld;
    P.apply(s.f, s.g, zu, zp);
    const double start = std::sqrt(s.f.dot(zu) + s.g.dot(zp));

    residual(s, u, p, vu, vp);
    P.apply(vu, vp, zu, zp);
    double beta = std::sqrt(vu.dot(zu) + vp.dot(zp));
    if (!(beta > controls_.tolerance*start))
    {
        return true;
    }
    vuOld = duOld = du = vector::Zero(vu.size());
    vpOld = dpOld = dp = vector::Zero(vp.size());
    double betaOld = 0, c = 1, cOld = 1, sine = 0, sineOld = 0, eta = beta;

    for (int i = 0; i < controls_.maxIterations; ++i)
    {
        vu /= beta;
        vp /= beta;
        zu /= beta;
        zp /= beta;
        vector wu(s.A*zu - s.B.transpose()*zp);
        vector wp(-(s.B*zu));
        const double a = wu.dot(zu) + wp.dot(zp);
        wu -= a*vu + beta*vuOld;
        wp -= a*vp + beta*vpOld;
        betaOld = beta;
        vuOld.swap(vu);
        vpOld.swap(vp);
        vu.swap(wu);
        vp.swap(wp);
        vector nu, np;
        P.apply(vu, vp, nu, np);
        beta = std::sqrt(vu.dot(nu) + vp.dot(np));

        const double delta = c*a - cOld*sine*betaOld;
        const double r1 = std::hypot(delta, beta);
        const double r2 = sine*a + cOld*c*betaOld;
        const double r3 = sineOld*betaOld;
        cOld = c;
        sineOld = sine;
        c = delta/r1;
        sine = beta/r1;

        duOld = (zu - r3*duOld - r2*du)/r1;
        dpOld = (zp - r3*dpOld - r2*dp)/r1;
        duOld.swap(du);
        dpOld.swap(dp);
        u += c*eta*du;
        p += c*eta*dp;
        eta *= -sine;
        zu.swap(nu);
        zp.swap(np);

        history_.push_back(std::abs(eta)/start);
        if (!(history_.back() > controls_.tolerance))
        {
            return std::isfinite(history_.back());
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::melt::saddleSolver::solve(const system& s, vector& u, vector& p)
{
    history_.clear();
    return
        (
            s.f.size() + s.g.size() > controls_.directUnknowns
         && iterate(s, u, p)
        )
     || direct(s, u, p);
}

// ************************************************************************* //
