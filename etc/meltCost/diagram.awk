#!/usr/bin/awk -f
#------------------------------------------------------------------------------
#   meltFoam: melting and flowing of highly viscous materials
#   Copyright (C) 2026 The meltFoam authors
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
# A work-precision diagram (SVG) from cost.csv:
#     awk -F, -v column=<of cost> -v title=<of its axis> -f diagram.awk cost.csv
# Error against cost, log-log; a curve for each method and factor, the Pareto
# front in full circles.
#------------------------------------------------------------------------------
function log10(x) { return log(x)/log(10) }
function X(v) { return 80 + 420*(log10(v) - x0)/(x1 - x0) }
function Y(v) { return 380 - 340*(log10(v) - y0)/(y1 - y0) }
function floor(x,    i) { i = int(x); return i > x ? i - 1 : i }
NR > 1 && $NF == "ok" && $4 > 0 && $column > 0 {
    c[++n] = $column; e[n] = $4; s[n] = $1 ($3 == 1 ? "" : ", step x " $3)
    if (!(s[n] in id)) { id[s[n]] = ++m; key[m] = s[n] }
    if (n == 1 || c[n] < cMin) cMin = c[n]; if (n == 1 || c[n] > cMax) cMax = c[n]
    if (n == 1 || e[n] < eMin) eMin = e[n]; if (n == 1 || e[n] > eMax) eMax = e[n]
}
END {
    split("#1f77b4 #d62728 #2ca02c #9467bd #ff7f0e #17becf #8c564b #7f7f7f", colour, " ")
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"760\" height=\"440\" font-family=\"sans-serif\" font-size=\"13\">"
    print "<rect width=\"760\" height=\"440\" fill=\"white\"/>"
    if (n == 0) { print "<text x=\"80\" y=\"60\">no point</text></svg>"; exit }
    x0 = floor(log10(cMin)); x1 = floor(log10(cMax)) + 1
    y0 = floor(log10(eMin)); y1 = floor(log10(eMax)) + 1
    for (i = x0; i <= x1; ++i) {
        printf "<line x1=\"%g\" y1=\"40\" x2=\"%g\" y2=\"380\" stroke=\"#ddd\"/>", X(10^i), X(10^i)
        printf "<text x=\"%g\" y=\"398\" text-anchor=\"middle\">1e%d</text>\n", X(10^i), i
    }
    for (i = y0; i <= y1; ++i) {
        printf "<line x1=\"80\" y1=\"%g\" x2=\"500\" y2=\"%g\" stroke=\"#ddd\"/>", Y(10^i), Y(10^i)
        printf "<text x=\"74\" y=\"%g\" text-anchor=\"end\">1e%d</text>\n", Y(10^i) + 4, i
    }
    printf "<text x=\"290\" y=\"424\" text-anchor=\"middle\">%s</text>\n", title
    print "<text x=\"20\" y=\"24\">error</text>"
    for (k = 1; k <= m; ++k) {
        col = colour[(k - 1) % 8 + 1]; points = ""
        # In the order of cost
        nk = 0
        for (i = 1; i <= n; ++i) if (id[s[i]] == k) o[++nk] = i
        for (a = 2; a <= nk; ++a) for (b = a; b > 1 && c[o[b]] < c[o[b - 1]]; --b) { t = o[b]; o[b] = o[b - 1]; o[b - 1] = t }
        for (a = 1; a <= nk; ++a) points = points sprintf("%g,%g ", X(c[o[a]]), Y(e[o[a]]))
        printf "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\"/>\n", points, col
        for (a = 1; a <= nk; ++a) {
            i = o[a]; best = 1
            for (j = 1; j <= n; ++j) if (c[j] <= c[i] && e[j] <= e[i] && (c[j] < c[i] || e[j] < e[i])) best = 0
            printf "<circle cx=\"%g\" cy=\"%g\" r=\"4.5\" fill=\"%s\" stroke=\"%s\"/>\n", X(c[i]), Y(e[i]), (best ? col : "white"), col
        }
        printf "<circle cx=\"520\" cy=\"%d\" r=\"4.5\" fill=\"%s\"/><text x=\"532\" y=\"%d\">%s</text>\n", 40 + 20*k, col, 44 + 20*k, key[k]
    }
    printf "<text x=\"514\" y=\"%d\" font-size=\"11\">full circle: Pareto front</text>\n</svg>\n", 60 + 20*m
}
