# Table of Allrun to SVG: seconds a simulated second against the jump number, both
# logarithmic. Jump numbers are powers of ten from 1e2 to 1e8
function x(J) { return 70 + 55*(log(J)/log(10) - 2) }
function y(s) { return 300 - 32*(log(s)/log(10) - 1) }
function curve(points, colour, name, J, s)
{
    printf "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\"/>\n", points, colour
    printf "<text x=\"%d\" y=\"%.1f\" fill=\"%s\" text-anchor=\"end\">%s</text>\n", x(J) - 8, y(s) - 8, colour, name
}
BEGIN {
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"430\" height=\"360\" font-family=\"sans-serif\" font-size=\"12\">"
    print "<rect width=\"430\" height=\"360\" fill=\"white\"/>"
    for (k = 2; k <= 8; ++k)
    {
        printf "<text x=\"%d\" y=\"318\" text-anchor=\"middle\">1e%d</text>\n", x(10^k), k
    }
    for (k = 1; k <= 9; ++k)
    {
        printf "<text x=\"60\" y=\"%d\" text-anchor=\"end\">1e%d</text>\n", y(10^k) + 4, k
        printf "<line x1=\"70\" x2=\"400\" y1=\"%d\" y2=\"%d\" stroke=\"#ddd\"/>\n", y(10^k), y(10^k)
    }
    print "<text x=\"235\" y=\"342\" text-anchor=\"middle\">jump number J</text>"
    print "<text x=\"70\" y=\"20\">seconds of run a simulated second</text>"
}
NR > 1 {
    robust = robust sprintf("%.1f,%.1f ", x($1), y($3))
    explicit = explicit sprintf("%.1f,%.1f ", x($1), y($9))
    J = $1; r = $3; e = $9
}
END {
    curve(robust, "#1f77b4", "robust", J, r)
    curve(explicit, "#d62728", "explicit (sibgrapi2006)", J, e)
    print "</svg>"
}
