#!/usr/bin/env python3
#------------------------------------------------------------------------------
#   meltFoam: melting and flowing of highly viscous materials
#   Copyright (C) 2026 The meltFoam authors
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
# reference.csv: the Souza Mendes-Dutra fluid between plates, n = 0.5
#
#     reference.py > reference.csv
#
# Closed form, in units of gamma1 and H. The flow curve
#
#     tau(g) = (1 - exp(-a g))(1 + g^n),    a = J + 1
#
# has the integral
#
#     Phi(g) = g + g^(n+1)/(n+1) - (1 - exp(-a g))/a
#            - a^-(n+1) gamma(n+1, a g)
#
# with the lower incomplete gamma function, for n = 0.5
# sqrt(pi)/2 erf(sqrt x) - sqrt(x) exp(-x). The stress is tauW y, so that the
# velocity is that between the rates of shear there and at the wall,
#
#     u = [g tau - Phi]/tauW
#------------------------------------------------------------------------------
from math import erf, exp, expm1, pi, sqrt

n = 0.5


def stress(g, J):
    return -expm1(-(J + 1)*g)*(1 + g**n)


def rate(tau, J):
    """Rate of shear at a stress, by bisection of its logarithm"""
    low, high = -60.0, 60.0
    for _ in range(200):
        middle = 0.5*(low + high)
        if stress(exp(middle), J) > tau:
            high = middle
        else:
            low = middle
    return exp(0.5*(low + high)) if tau > 0 else 0


def psi(g, J):
    a = J + 1.0
    x = a*g
    incomplete = sqrt(pi)/2*erf(sqrt(x)) - sqrt(x)*exp(-x)
    phi = g + g**(n + 1)/(n + 1) + expm1(-x)/a - incomplete/a**(n + 1)
    return g*stress(g, J) - phi


def velocity(y, tauW, J):
    return (psi(rate(tauW, J), J) - psi(rate(tauW*y, J), J))/tauW


cases = [(J, tauW) for J in (0, 10, 1e3, 1e6) for tauW in (0.5, 0.9, 1.5, 3)]
print('# SMD plane Poiseuille: y from mid plane, wall at y=H (half gap H),'
      ' tau_w*=|dp/dx|H/tau0, u in gamma1*H')
print('# the same table is the film profile with y=distance below the free'
      ' surface and tau_w*=rho g sin(theta) H/tau0')
print(','.join(['y/H[-]']
               + ['u_J%g_tw%g[gamma1*H]' % (J, tauW) for J, tauW in cases]))
for i in range(101):
    y = i/100
    print(','.join(['%.10g' % y]
                   + ['%.10g' % velocity(y, tauW, J) for J, tauW in cases]))
