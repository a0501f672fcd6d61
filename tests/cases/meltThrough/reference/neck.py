#!/usr/bin/env python3
#------------------------------------------------------------------------------
#   meltFoam: melting and flowing of highly viscous materials
#   Copyright (C) 2026 The meltFoam authors
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
# When does the neck of the dumbbell melt through: conduction in its fixed shape
# with the heat set free in the neck, T_t = a lap T + q/(rho Cp), insulated,
# explicit finite volumes of an eighth (mirrored in x, y, z).
#
#     neck.py <cells in half the neck's width>
#
# prints the times at which the hottest and the coldest cell of the layer in the
# middle of the neck reach the solidus, and those of the layers beside it
#------------------------------------------------------------------------------
import sys

n = int(sys.argv[1])
half, block, a, source, solidus = 0.01, 0.02, 200/(1000*2000), 8e7/(1000*2000), 20
d = half/n
# x and z from the axis, y from the middle of the neck
size = (2*n, 3*n, 2*n)


def inside(i, j, k):
    return j < 3*n and (j >= n or (i < n and k < n))


cells = [(i, j, k) for i in range(size[0]) for j in range(size[1])
         for k in range(size[2]) if i < 2*n and k < 2*n and inside(i, j, k)]
index = {cell: m for m, cell in enumerate(cells)}
neighbours = [[index[c] for c in ((i + 1, j, k), (i - 1, j, k), (i, j + 1, k),
                                  (i, j - 1, k), (i, j, k + 1), (i, j, k - 1))
               if c in index] for i, j, k in cells]
heated = [source if j < n else 0 for i, j, k in cells]

dt = 0.9*d*d/(6*a)
r = a*dt/(d*d)
T = [0.0]*len(cells)
time = 0
layers = [[m for m, c in enumerate(cells) if c[1] == j] for j in range(n)]
through = {}
while len(through) < n and time < 5:
    new = [t + r*(sum(T[q] for q in near) - len(near)*t) + dt*h
           for t, near, h in zip(T, neighbours, heated)]
    for j, layer in enumerate(layers):
        before, after = min(T[m] for m in layer), min(new[m] for m in layer)
        if j not in through and after >= solidus:
            through[j] = time + dt*(solidus - before)/(after - before)
            print("layer at %.5f m through at %.4f s" % ((j + 0.5)*d, through[j]),
                  flush=True)
    T = new
    time += dt
