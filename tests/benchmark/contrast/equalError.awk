# Points of equalError to its tables. Input, sorted: preset, particles, factor, steps,
# seconds a simulated second, fall of the centre of mass and of the top (negative),
# growth of the half width [m] and of the melted fraction. -v sizes: of the reference
function order(a, b, c) { return (a - b)/(b - c) > 0 ? log((a - b)/(b - c))/log(ratio) : 0 }
function magnitude(x) { return x < 0 ? -x : x }
BEGIN {
    split(sizes, size, " ")
    ratio = (size[2]/size[1])^(1/3)
    split("centre top width melted", name, " ")
}
{
    for (q = 1; q <= 4; ++q) value[NR, q] = $(5 + q)
    label[NR] = $1; particles[NR] = $2; factor[NR] = $3; steps[NR] = $4; seconds[NR] = $5
    if ($1 == "robust" && $3 == 0.25)
        for (k = 1; k <= 3; ++k)
            if ($2 == size[k]) for (q = 1; q <= 4; ++q) fine[k, q] = $(5 + q)
}
END {
    printf "%-9s %9s %6s %6s %9s", "scheme", "particles", "factor", "steps", "CPU s/s"
    for (q = 1; q <= 4; ++q) printf " %9s", name[q]
    print "\n" "Changes: mm, mm, mm, %"
    # The order must lie between 1 and 2 for the extrapolation to be better than the
    # finest; otherwise the first order is assumed
    for (q = 1; q <= 4; ++q)
    {
        p[q] = order(fine[1, q], fine[2, q], fine[3, q])
        used = p[q] < 1 ? 1 : p[q] > 2 ? 2 : p[q]
        reference[q] = fine[3, q] + (fine[3, q] - fine[2, q])/(ratio^used - 1)
        scale[q] = q == 4 ? 100 : 1000
    }
    for (i = 1; i <= NR; ++i)
    {
        printf "%-9s %9d %6s %6d %9.3g", label[i], particles[i], factor[i], steps[i], seconds[i]
        for (q = 1; q <= 4; ++q) printf " %9.4f", scale[q]*value[i, q]
        print ""
    }
    printf "%-42s", "reference, extrapolated"
    for (q = 1; q <= 4; ++q) printf " %9.4f", scale[q]*reference[q]
    printf "\n%-42s", "its distance from the finest, %"
    for (q = 1; q <= 4; ++q) printf " %9.2f", 100*magnitude(fine[3, q]/reference[q] - 1)
    printf "\n%-42s", "observed order"
    for (q = 1; q <= 4; ++q) printf " %9.2f", p[q]

    print "\n\nErrors, % of the reference's change"
    for (i = 1; i <= NR; ++i)
    {
        printf "%-9s %9d %6s %6d %9.3g", label[i], particles[i], factor[i], steps[i], seconds[i]
        for (q = 1; q <= 4; ++q)
        {
            error[i, q] = 100*(value[i, q]/reference[q] - 1)
            printf " %9.2f", error[i, q]
        }
        print ""
    }

    print "\nSeconds of explicit over those of the cheapest robust that is nowhere less accurate"
    printf "%-42s", "explicit"
    for (q = 1; q <= 4; ++q) printf " %9s", name[q]
    printf " %9s\n", "all four"
    for (i = 1; i <= NR; ++i)
    {
        if (label[i] != "explicit") continue
        printf "%-9s %9d %22s", label[i], particles[i], ""
        for (q = 1; q <= 5; ++q)
        {
            least = 0
            for (j = 1; j <= NR; ++j)
            {
                if (label[j] != "robust" || (least && seconds[j] >= least)) continue
                good = 1
                for (r = 1; r <= 4; ++r)
                    if ((q == 5 || q == r) && magnitude(error[j, r]) > magnitude(error[i, r])) good = 0
                if (good) least = seconds[j]
            }
            printf " %9s", least ? sprintf("%.0f", seconds[i]/least) : "none"
        }
        print ""
    }
}
