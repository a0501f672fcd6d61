# Points of equalError to its tables. Input, sorted: preset, particles, factor, steps,
# seconds a simulated second, change of the centre of mass, of the top, of the half
# width and of the spread [m], and melted volume over that at the start. -v sizes: of the reference
function magnitude(x) { return x < 0 ? -x : x }
function head(title, q)
{
    printf "%-10s %9s %6s %6s %9s", title, "particles", "factor", "steps", "CPU s/s"
    for (q = 1; q <= 5; ++q) printf " %9s", name[q]
    print ""
}
function row(i) { printf "%-10s %9d %6s %6d %9.3g", label[i], particles[i], factor[i], steps[i], seconds[i] }
# Is j as good as i in q? 6 means the first four: the melted volume moves with the
# layers of particles by more than conduction changes it
function good(j, i, q, r)
{
    for (r = 1; r <= 5; ++r)
        if ((q == 6 ? r < 5 : q == r) && magnitude(error[j, r]) > magnitude(error[i, r])) return 0
    return 1
}
function quotient(i, q, scheme, j, least)
{
    for (j = 1; j <= NR; ++j)
        if (label[j] == scheme && !(least && seconds[j] >= least) && good(j, i, q)) least = seconds[j]
    return least ? sprintf("%.0f", seconds[i]/least) : "none"
}
BEGIN {
    split(sizes, size, " ")
    ratio = (size[2]/size[1])^(1/3)
    split("centre top width spread melted", name, " ")
    split("1000 1000 1000 1000 1", scale, " ")
}
{
    for (q = 1; q <= 5; ++q) value[NR, q] = $(5 + q)
    label[NR] = $1; particles[NR] = $2; factor[NR] = $3; steps[NR] = $4; seconds[NR] = $5
    for (k = 1; k <= 3; ++k)
        if ($1 == "robust" && $3 == 0.25 && $2 == size[k])
            for (q = 1; q <= 5; ++q) fine[k, q] = $(5 + q)
}
END {
    # Extrapolated by the observed order, at most 2; the finest where that is below
    # 1, or there is none as the values go to and fro
    for (q = 1; q <= 5; ++q)
    {
        last = fine[3, q] - fine[2, q]
        growth = last ? (fine[2, q] - fine[1, q])/last : 0
        order[q] = growth > 0 ? log(growth)/log(ratio) : 0
        reference[q] = fine[3, q]
        if (order[q] >= 1) reference[q] += last/(ratio^(order[q] > 2 ? 2 : order[q]) - 1)
    }

    print "Changes in mm; melted volume over that at the start"
    head("scheme")
    for (i = 1; i <= NR; ++i)
    {
        row(i)
        for (q = 1; q <= 5; ++q) printf " %9s", value[i, q] == "-" ? "-" : sprintf("%.4f", scale[q]*value[i, q])
        print ""
    }
    printf "%-44s", "reference, extrapolated"
    for (q = 1; q <= 5; ++q) printf " %9.4f", scale[q]*reference[q]
    printf "\n%-44s", "its distance from the finest, %"
    for (q = 1; q <= 5; ++q) printf " %9.2f", 100*magnitude(fine[3, q]/reference[q] - 1)
    printf "\n%-44s", "observed order"
    for (q = 1; q <= 5; ++q) printf " %9s", order[q] ? sprintf("%.2f", order[q]) : "none"

    print "\n\nErrors, % of the reference"
    head("scheme")
    for (i = 1; i <= NR; ++i)
    {
        row(i)
        for (q = 1; q <= 5; ++q)
        {
            error[i, q] = 100*(value[i, q]/reference[q] - 1)
            printf " %9s", value[i, q] == "-" ? "-" : sprintf("%.2f", error[i, q])
        }
        print ""
    }

    print "\nSeconds over those of the cheapest robust, tensionless that is no less accurate"
    printf "%-44s", "scheme and particles"
    for (q = 1; q <= 5; ++q) printf " %11s", name[q]
    print "  first four"
    for (i = 1; i <= NR; ++i)
    {
        if (label[i] != "explicit" && label[i] != "unsmoothed") continue
        printf "%-10s %33d", label[i], particles[i]
        for (q = 1; q <= 6; ++q)
            printf " %11s", quotient(i, q, "robust") ", " quotient(i, q, "tensionless")
        print ""
    }
}
