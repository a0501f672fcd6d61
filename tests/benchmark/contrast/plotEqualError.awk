# Table of equalError to SVG: seconds a simulated second against the error, both
# logarithmic. Left that of all of the melt, right that of the outermost particles
function x(e, panel) { return 70 + 280*panel + 80*(log(e)/log(10) + 1) }
function y(s) { return 300 - 65*log(s)/log(10) }
function panel(k, title, i)
{
    for (i = 1; i in tick; ++i)
    {
        printf "<text x=\"%.1f\" y=\"318\" text-anchor=\"middle\">%s</text>\n", x(tick[i], k), tick[i]
        printf "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"300\" y2=\"40\" stroke=\"#ddd\"/>\n", x(tick[i], k), x(tick[i], k)
    }
    for (i = 0; i <= 4; ++i)
    {
        printf "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">1e%d</text>\n", x(0.1, k) - 10, y(10^i) + 4, i
        printf "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/>\n", x(0.1, k), x(50, k), y(10^i), y(10^i)
    }
    printf "<text x=\"%.1f\" y=\"340\" text-anchor=\"middle\">%s</text>\n", x(2.2, k), title
}
function point(scheme, k, e)
{
    e = e < 0 ? -e : e
    # The reference's own
    if (e < 0.1) return
    printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", x(e, k), y($5), colour[scheme]
    if ($3 == 1) points[scheme, k] = points[scheme, k] sprintf("%.1f,%.1f ", x(e, k), y($5))
}
BEGIN {
    split("0.1 0.5 1 2 5 10 20 50", tick, " ")
    colour["robust"] = "#1f77b4"; colour["explicit"] = "#d62728"; colour["unsmoothed"] = "#ff7f0e"
    colour["tensionless"] = "#17becf"
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"620\" height=\"360\" font-family=\"sans-serif\" font-size=\"12\">"
    print "<rect width=\"620\" height=\"360\" fill=\"white\"/>"
    printf "<text x=\"20\" y=\"20\">seconds of CPU a simulated second:</text>"
    printf "<text x=\"270\" y=\"20\" fill=\"%s\">robust</text>\n", colour["robust"]
    printf "<text x=\"315\" y=\"20\" fill=\"%s\">tensionless</text>\n", colour["tensionless"]
    printf "<text x=\"390\" y=\"20\" fill=\"%s\">explicit (sibgrapi2006)</text>\n", colour["explicit"]
    printf "<text x=\"535\" y=\"20\" fill=\"%s\">unsmoothed</text>\n", colour["unsmoothed"]
    panel(0, "error of centre, top and spread, rms [%]")
    panel(1, "error of the half width [%]")
}
/^Errors/ { on = 1 }
/^Seconds/ { on = 0 }
on && $1 in colour {
    point($1, 0, sqrt(($6*$6 + $7*$7 + $9*$9)/3))
    point($1, 1, $8)
}
END {
    for (scheme in colour)
        for (k = 0; k < 2; ++k)
            printf "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\"/>\n", points[scheme, k], colour[scheme]
    print "</svg>"
}
