# Table of equalError to SVG: seconds a simulated second against the error, the root
# mean square of the first four, both logarithmic
function x(e) { return 70 + 130*log(e)/log(10) }
function y(s) { return 300 - 65*log(s)/log(10) }
function curve(points, colour, name, e, s)
{
    printf "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\"/>\n", points, colour
    printf "<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\">%s</text>\n", x(e) + 8, y(s) + 4, colour, name
}
BEGIN {
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"460\" height=\"360\" font-family=\"sans-serif\" font-size=\"12\">"
    print "<rect width=\"460\" height=\"360\" fill=\"white\"/>"
    split("1 2 5 10 20 50", tick, " ")
    for (k = 1; k in tick; ++k)
    {
        printf "<text x=\"%.1f\" y=\"318\" text-anchor=\"middle\">%d</text>\n", x(tick[k]), tick[k]
        printf "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"300\" y2=\"40\" stroke=\"#ddd\"/>\n", x(tick[k]), x(tick[k])
    }
    for (k = 0; k <= 4; ++k)
    {
        printf "<text x=\"60\" y=\"%.1f\" text-anchor=\"end\">1e%d</text>\n", y(10^k) + 4, k
        printf "<line x1=\"70\" x2=\"330\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/>\n", y(10^k), y(10^k)
    }
    print "<text x=\"200\" y=\"342\" text-anchor=\"middle\">error of centre, top, width and spread, root mean square [%]</text>"
    print "<text x=\"20\" y=\"20\">seconds of CPU a simulated second</text>"
    colours["robust"] = "#1f77b4"; colours["explicit"] = "#d62728"
    names["robust"] = "robust"; names["explicit"] = "explicit (sibgrapi2006)"
}
/^Errors/ { on = 1 }
/^Seconds/ { on = 0 }
on && $1 in colours {
    e = sqrt(($6*$6 + $7*$7 + $8*$8 + $9*$9)/4)
    printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", x(e), y($5), colours[$1]
    if ($3 != 1) next
    points[$1] = points[$1] sprintf("%.1f,%.1f ", x(e), y($5))
    if (!($1 in first)) { first[$1] = e; cost[$1] = $5 }
}
END {
    for (name in points) curve(points[name], colours[name], names[name], first[name], cost[name])
    print "</svg>"
}
