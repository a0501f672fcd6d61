#!/usr/bin/env python3
# SPDX-FileCopyrightText: meltFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reference for a viscous cube slumping under its own weight (needs numpy, scipy).

A cube of incompressible Newtonian liquid (edge L) stands on a no-slip floor
y = 0; its five other faces are traction-free (p_ambient = 0, no surface
tension). It is released from rest at t = 0. Quarter cube x, z in [0, L/2].
Drops (mm) are positive downwards.

Linear theory on the fixed cube: staggered grid from the energy integral of
2 mu D:D with edge-centred shears (after Batty & Bridson 2008), BDF2 in time.
Cross-check of viscousCubeFem.py lin. n cells along L/2 in x and z, 2n along y.
Usage: viscousCubeMac.py n [--mu 50] [--dt 1e-3] [--tend 0.048]
"""
import argparse
import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

RHO, G, L = 1000.0, 9.81, 0.1


def factor(K):
    """Sparse LU of a symmetric positive definite matrix."""
    return splu(K.tocsc(), permc_spec='MMD_AT_PLUS_A', diag_pivot_thresh=0.0,
                options=dict(SymmetricMode=True))


def kron3(a, b, c):
    return sp.kron(sp.kron(a, b), c, format='csr')


# ------------------------------------------------------------------ MAC, linear
def run_mac(a):
    n, h = a.n, 0.5*L/a.n
    N = (n, 2*n, n)                       # cells along x, y, z
    I = [sp.identity(m) for m in N]

    def dirs(ops):                        # operators in x, y, z -> 3-D operator
        return kron3(*[I[d] if o is None else o for d, o in enumerate(ops)])

    # faces 1..m in each direction (face 0 is a symmetry plane or the floor: 0)
    D = [sp.diags([np.ones(m), -np.ones(m-1)], [0, -1])/h for m in N]
    half = [sp.diags(np.r_[np.ones(m-1), 0.5]) for m in N]   # free-face volume
    div = [dirs([D[d] if e == d else None for e in range(3)]) for d in range(3)]
    nu = np.prod(N)
    V = h**3
    M = sp.block_diag([V*RHO*dirs([half[d] if e == d else None for e in range(3)])
                       for d in range(3)], format='csr')
    A = sp.block_diag([2*a.mu*V*q.T@q for q in div], format='lil').tocsr()
    B = V*sp.hstack(div, format='csr')

    # Edge shears. Edges on free faces (zero shear stress) and on symmetry planes
    # (zero shear rate) carry no energy: only interior edges and the floor remain.
    def inner(m):                         # cells -> interior edges 1..m-1
        return sp.diags([-np.ones(m-1), np.ones(m-1)], [0, 1], shape=(m-1, m))/h

    def sel(m):                           # faces 1..m -> interior edges 1..m-1
        return sp.eye(m-1, m)

    Z = sp.csr_matrix
    for p, q in ((0, 1), (1, 2), (0, 2)):
        def emb(op, oq):
            o = [None]*3
            o[p], o[q] = op, oq
            return dirs(o)
        S = [Z((emb(sel(N[p]), sel(N[q])).shape[0], nu))]*3
        S[p] = emb(sel(N[p]), inner(N[q]))
        S[q] = emb(inner(N[p]), sel(N[q]))
        S = sp.hstack(S, format='csr')
        A = A + a.mu*V*S.T@S
    # floor edges: tangential u over half a cell height, half a volume (and the
    # half weight of the free face at the contact line)
    low = sp.csr_matrix(([1.0], ([0], [0])), shape=(N[1], N[1]))
    F = a.mu*V*0.5*(2/h)**2
    A = A + sp.block_diag([F*dirs([half[0], low, None]), sp.csr_matrix((nu, nu)),
                           F*dirs([None, low, half[2]])], format='csr')
    lam = 1e3*(a.mu + RHO*L*L/a.dt*0.1)
    Wi = 1.0/V                            # inverse pressure mass
    P = lam*Wi*B.T@B
    gv = np.zeros(3*nu)
    gv[nu:2*nu] = -G
    f = M@gv
    mv = M.diagonal()[nu:2*nu]
    u0 = u = d0 = d = np.zeros(3*nu)
    p = np.zeros(nu)
    lu = {}
    for s in range(1, int(round(a.tend/a.dt)) + 1):
        c, r, e = (1.0, u, d) if s == 1 else (1.5, 2*u - 0.5*u0, 2*d - 0.5*d0)
        if c not in lu:
            lu.clear()
            lu[c] = factor(c/a.dt*M + A + P)
        rhs = f + M@r/a.dt
        for _ in range(4):                # augmented-Lagrangian (Uzawa) sweeps
            w = lu[c].solve(rhs + B.T@p)
            p = p - lam*Wi*(B@w)
        u0, u = u, w
        d0, d = d, (e + a.dt*u)/c
        if report(a, s):
            top = -d[nu:2*nu].reshape(N)[:, -1, :]
            ctr = np.r_[9/8, -1/8]        # even extrapolation to the axis
            edg = np.r_[-0.5, 1.5]        # linear extrapolation to the edge
            mid = ctr@top[:2]
            print_row(a, s, centre=ctr@top[:2, :2]@ctr, mean=top.mean(),
                      edge=edg@(ctr@top[:2])[-2:], corner=edg@top[-2:, -2:]@edg,
                      com=-(mv@d[nu:2*nu])/(RHO*V*nu), div=abs(B@u).max()/V)


def report(a, s):
    return any(abs(s*a.dt - t) < 0.01*a.dt for t in a.times)


def print_row(a, s, **v):
    print(f'mac n={a.n} mu={a.mu:g} dt={a.dt:g} t={s*a.dt:.4f} '
          + ' '.join(f'{k}={x:.6g}' if k == 'div' else
                     f'{k}={1e3*x:.5f}' for k, x in v.items()) + '  (mm)', flush=True)


if __name__ == '__main__':
    ap = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    ap.add_argument('n', type=int)
    for k, v in dict(mu=50.0, dt=1e-3, tend=0.048).items():
        ap.add_argument('--' + k, type=float, default=v)
    ap.add_argument('--times', type=float, nargs='+', default=[0.032, 0.048])
    a = ap.parse_args()
    run_mac(a)
