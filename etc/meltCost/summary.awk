#!/usr/bin/awk -f
#------------------------------------------------------------------------------
#   meltFoam: melting and flowing of highly viscous materials
#   Copyright (C) 2026 The meltFoam authors
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
# From cost.csv without its header, points of a curve in the order of their
# operations: of each method and factor the slope of error against operations
# and CPU time, and what 10, 3 and 1 % cost, between its points; memory. A line
# each, fields by |
#------------------------------------------------------------------------------
# From there on the error stays below the target
function reach(k, column, target,    i, j, w) {
    for (j = n[k]; j > 0 && err[k, j] <= target; --j) i = j
    if (j == n[k]) return "-"
    if (j == 0) return sprintf("< %.2g", val[k, 1, column])
    w = log(err[k, j]/target)/log(err[k, j]/err[k, i])
    return sprintf("%.2g", exp((1 - w)*log(val[k, j, column]) + w*log(val[k, i, column])))
}
function slope(k, column,    i, x, y, sx, sy, sxx, sxy, m) {
    for (i = 1; i <= n[k]; ++i) {
        if (!(val[k, i, column] > 0 && err[k, i] > 0)) continue
        x = log(val[k, i, column]); y = log(err[k, i]); ++m
        sx += x; sy += y; sxx += x*x; sxy += x*y
    }
    return m > 1 && m*sxx > sx*sx ? sprintf("%.2f", (m*sxy - sx*sy)/(m*sxx - sx*sx)) : "-"
}
$NF == "ok" && $4 > 0 {
    key = $1 ($3 == 1 ? "" : ", step x " $3)
    if (!(key in n)) order[++m] = key
    i = ++n[key]; err[key, i] = $4; val[key, i, 7] = $7; val[key, i, 8] = ($8 > 0 ? $8 : 0.005)
    memory[key] = $12
}
END {
    for (q = 1; q <= m; ++q) {
        k = order[q]
        printf "%s|%s|%s|%s|%s|%s|%s|%s|%s|%.0f\n", k, slope(k, 7), slope(k, 8),
            reach(k, 7, 0.1), reach(k, 7, 0.03), reach(k, 7, 0.01),
            reach(k, 8, 0.1), reach(k, 8, 0.03), reach(k, 8, 0.01), memory[k]
    }
}
