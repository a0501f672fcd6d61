#!/usr/bin/env python3
# SPDX-FileCopyrightText: meltFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reference for a viscous cube slumping under its own weight (needs numpy, scipy).

A cube of incompressible Newtonian liquid (edge L) stands on a no-slip floor
y = 0; its five other faces are traction-free (p_ambient = 0, no surface
tension). It is released from rest at t = 0. Quarter cube x, z in [0, L/2].
Drops (mm) are positive downwards.

Q2-P1disc finite elements, full symmetric stress, natural zero traction.
 fem  finite deformation, updated Lagrangian: nodes move with the liquid, so
      advection is exact; the contact line is pinned;
 lin  linear theory: the same on the fixed cube (cross-check: viscousCubeMac.py).
Time: BDF2 (first step backward Euler) on the second-order extrapolated
end-of-step geometry. n elements along L/2 in x and z, 2n along y, graded.
Usage: viscousCubeFem.py fem|lin n [--mu 50] [--dt 1e-3] [--tend 0.048] [--grade 1.5]
"""
import argparse
import inspect
import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu, gmres, LinearOperator

# relative tolerance of GMRES (scipy renamed the argument)
TOL = {'rtol' if 'rtol' in inspect.signature(gmres).parameters else 'tol': 1e-8}
RHO, G, L = 1000.0, 9.81, 0.1


def factor(K):
    """Sparse LU of a symmetric positive definite matrix."""
    return splu(K.tocsc(), permc_spec='MMD_AT_PLUS_A', diag_pivot_thresh=0.0,
                options=dict(SymmetricMode=True))


def simpson(e):
    """Weights of the mean over the reference length on a quadratic mesh."""
    w = np.zeros(2*len(e) - 1)
    for k, d in enumerate(np.diff(e)):
        w[2*k:2*k+3] += d*np.array([1, 4, 1])/6
    return w/w.sum()


# ------------------------------------------------- Q2-P1disc FEM, linear or moving
def run_fem(a, moving):
    n = a.n
    ne = (n, 2*n, n)
    m = [2*k + 1 for k in ne]
    # elements graded (exponent a.grade) towards the free side faces and the floor
    ex = 0.5*L*(1 - (1 - np.linspace(0, 1, n+1))**a.grade)
    ey = L*np.linspace(0, 1, 2*n+1)**a.grade

    def nodes(e):
        return np.sort(np.r_[e, 0.5*(e[1:] + e[:-1])])
    X = np.stack(np.meshgrid(nodes(ex), nodes(ey), nodes(ex), indexing='ij'), -1)
    nn = X[..., 0].size
    idx = np.arange(nn).reshape(m)
    X = X.reshape(-1, 3)
    el = np.stack([idx[i:i+2*n-1:2, j:j+4*n-1:2, k:k+2*n-1:2].ravel()
                   for i in range(3) for j in range(3) for k in range(3)], 1)
    nel = len(el)
    # shape functions and their reference gradients at the 3x3x3 Gauss points
    gp, gw = np.polynomial.legendre.leggauss(3)
    f1 = np.stack([gp*(gp-1)/2, 1 - gp**2, gp*(gp+1)/2], 1)       # [gauss, node]
    g1 = np.stack([gp - 0.5, -2*gp, gp + 0.5], 1)

    def t3(p, q, r):
        return np.einsum('ai,bj,ck->abcijk', p, q, r).reshape(27, 27)
    Nq, wq = t3(f1, f1, f1), np.einsum('a,b,c->abc', gw, gw, gw).ravel()
    dN = np.stack([t3(g1, f1, f1), t3(f1, g1, f1), t3(f1, f1, g1)], -1)
    dof = (3*el[:, :, None] + np.arange(3)).reshape(nel, 81)
    fixed = np.zeros((nn, 3), bool)
    fixed[idx[0].ravel(), 0] = True
    fixed[idx[:, :, 0].ravel(), 2] = True
    fixed[idx[:, 0].ravel()] = True
    free = np.flatnonzero(~fixed.ravel())
    R = np.repeat(dof, 81, 1).ravel()
    C = np.tile(dof, (1, 81)).ravel()
    pd = 4*np.arange(nel)[:, None] + np.arange(4)

    def scatter(Ke):
        return sp.csr_matrix((Ke.ravel(), (R, C)), (3*nn, 3*nn))[free][:, free]

    def assemble(x, c):
        """System matrix c/dt M + A, mass M, divergence B, pressure mass W^-1."""
        xe = x[el]
        J = np.einsum('qai,eaj->eqij', dN, xe, optimize=True)
        w = np.linalg.det(J)*wq
        assert w.min() > 0, 'inverted element'
        g = np.einsum('eqij,qaj->eqai', np.linalg.inv(J), dN, optimize=True)
        Me = RHO*np.einsum('eq,qa,qb->eab', w, Nq, Nq, optimize=True)
        gf = g.transpose(0, 2, 3, 1).reshape(nel, 81, 27)         # [e, (a,i), q]
        T = (gf*w[:, None])@gf.transpose(0, 2, 1)
        T = T.reshape(nel, 27, 3, 27, 3)                # int d_i N_a d_k N_b
        Ae = a.mu*T.transpose(0, 1, 4, 3, 2).copy()     # transpose part of 2 mu D:D
        tr = a.mu*np.einsum('eaibi->eab', T) + c/a.dt*Me
        for i in range(3):
            Ae[:, :, i, :, i] += tr
        xq = np.einsum('qa,eai->eqi', Nq, xe)
        xm = xe.mean(1)
        sc = np.ptp(xe, axis=1)
        psi = np.concatenate([np.ones((nel, 27, 1)),
                              (xq - xm[:, None])/sc[:, None]], 2)  # P1 discontinuous
        Be = np.einsum('eq,eqk,eqai->ekai', w, psi, g, optimize=True).reshape(nel, 4, 81)
        Wi = np.linalg.inv(np.einsum('eq,eqk,eql->ekl', w, psi, psi, optimize=True))
        B = sp.csr_matrix((Be.ravel(), (np.repeat(pd, 81, 1).ravel(),
                           np.repeat(dof, 4, 0).ravel())), (4*nel, 3*nn))[:, free]
        Ae = Ae.reshape(nel, 81, 81)
        M = sp.csr_matrix((Me.ravel(), (np.repeat(el, 27, 1).ravel(),
                           np.tile(el, (1, 27)).ravel())), (nn, nn))
        return Ae, M, B, Be, Wi, w.sum(), np.einsum('eq,eqi->i', w, xq)/w.sum()

    lam = 1e3*(a.mu + RHO*L*L/a.dt*0.1)
    x0 = x = X.copy()
    u0 = u = np.zeros((nn, 3))
    p = np.zeros(4*nel)
    grav = np.array([0.0, -G, 0.0])
    vol0, com0 = assemble(X, 1.0)[5:]
    cache = {}
    its = 0
    for s in range(1, int(round(a.tend/a.dt)) + 1):
        c, ru, rx = (1.0, u, x) if s == 1 else (1.5, 2*u - 0.5*u0, 2*x - 0.5*x0)
        xs = (rx + a.dt*(2*u - u0))/c if moving else X   # extrapolated geometry
        if moving or s <= 2:
            Ae, M, B, Be, Wi = assemble(xs, c)[:5]
            K = scatter(Ae)
        if s <= 2 or its > 15:            # (re)factorise the preconditioner
            cache['lu'] = factor(scatter(Ae + lam*Be.transpose(0, 2, 1)@Wi@Be))
            cache['B'], cache['W'] = B, sp.block_diag(list(Wi), format='csr')
        f = (M@(grav + ru/a.dt)).ravel()[free]
        nf, lu, Bp, Wp = len(free), cache['lu'], cache['B'], cache['W']

        def mul(z):                       # [K -B^T; B 0]
            return np.r_[K@z[:nf] - B.T@z[nf:], B@z[:nf]]

        def pre(z):                       # penalised saddle-point solve
            q = lam*(Wp@z[nf:])
            v = lu.solve(z[:nf] + Bp.T@q)
            return np.r_[v, q - lam*(Wp@(Bp@v))]
        cnt = []
        b = np.r_[f, np.zeros(4*nel)]
        z0 = np.r_[(2*u - u0).ravel()[free], p]
        y0 = b - mul(z0)
        op = LinearOperator((len(b),)*2, lambda z: pre(mul(z)))
        y, info = gmres(op, pre(y0), restart=60, maxiter=3, callback=cnt.append,
                        callback_type='pr_norm', **TOL)
        assert info == 0, 'GMRES did not converge'
        its, z = len(cnt), z0 + y
        p = z[nf:]
        un = np.zeros(3*nn)
        un[free] = z[:nf]
        u0, u = u, un.reshape(nn, 3)
        x0, x = x, (rx + a.dt*u)/c
        if report(a, s):
            if moving:
                vol, com = assemble(x, 1.0)[5:]
                cy = com[1]
            else:                         # linear: mean of the displacement
                vol = vol0
                wt = np.asarray(assemble(X, 1.0)[1].sum(0)).ravel()/(RHO*vol0)
                cy = wt@x[:, 1]
            yt = x[:, 1].reshape(m)[:, -1, :]
            sx = simpson(ex)
            side = x[:, 0].reshape(m)[-1]
            print_row(a, s, centre=L - yt[0, 0], mean=L - sx@yt@sx,
                      edge=L - yt[-1, 0], corner=L - yt[-1, -1],
                      com=com0[1] - cy, least=L - yt.max(), most=L - yt.min(),
                      bulge=side.max() - L/2, ymin=x[:, 1].min(),
                      dvol=vol/vol0 - 1, gmres=its)


def report(a, s):
    return any(abs(s*a.dt - t) < 0.01*a.dt for t in a.times)


def print_row(a, s, **v):
    print(f'{a.mode} n={a.n} mu={a.mu:g} dt={a.dt:g} grade={a.grade:g} t={s*a.dt:.4f} '
          + ' '.join(f'{k}={x:.6g}' if k in ('dvol', 'gmres') else
                     f'{k}={1e3*x:.5f}' for k, x in v.items()) + '  (mm)', flush=True)


if __name__ == '__main__':
    ap = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    ap.add_argument('mode', choices=('lin', 'fem'))
    ap.add_argument('n', type=int)
    for k, v in dict(mu=50.0, dt=1e-3, tend=0.048, grade=1.5).items():
        ap.add_argument('--' + k, type=float, default=v)
    ap.add_argument('--times', type=float, nargs='+', default=[0.032, 0.048])
    a = ap.parse_args()
    run_fem(a, a.mode == 'fem')
