/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "svgPlot.H"
#include "error.H"

#include <cmath>
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Of the picture, and of the margins left and at right, top, bottom [pixel]
constexpr double width = 560;
constexpr double height = 320;
constexpr double left = 80;
constexpr double right = 20;
constexpr double top = 52;
constexpr double bottom = 44;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarMinMax Foam::melt::svgPlot::range(const bool ofX) const
{
    scalarMinMax all;
    for (const series& s : series_)
    {
        for (const scalar value : ofX ? s.x : s.y)
        {
            if (std::isfinite(value))
            {
                all.add(value);
            }
        }
    }

    if (!all.valid())
    {
        return scalarMinMax(0, 1);
    }

    // What differs in round-off only is a level line
    const scalar least = 1e-9*max(mag(all.min()), mag(all.max()));
    if (all.mag() <= least)
    {
        const scalar margin = least > 0 ? 0.05*max(mag(all.min()), least) : 1;
        return scalarMinMax(all.min() - margin, all.max() + margin);
    }
    return all;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::svgPlot::svgPlot(const string& title, const string& xTitle)
:
    title_(title),
    xTitle_(xTitle)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::melt::svgPlot::add
(
    const string& name,
    const scalarField& x,
    const scalarField& y
)
{
    series_.append(series{name, x, y});
}


Foam::scalarList Foam::melt::svgPlot::ticks
(
    const scalarMinMax& range,
    const label n
)
{
    const scalar power = std::pow(10, std::floor(std::log10(range.mag()/n)));
    scalar step = power;
    for (const scalar factor : {1, 2, 5, 10})
    {
        step = factor*power;
        if (range.mag()/step <= n)
        {
            break;
        }
    }

    DynamicList<scalar> values;
    const scalar first = std::ceil(range.min()/step - 1e-9);
    for (label i = 0; (first + i)*step <= range.max() + 1e-9*step; ++i)
    {
        values.append((first + i)*step);
    }
    return scalarList(values);
}


Foam::string Foam::melt::svgPlot::colour(const label i)
{
    // Told apart by those who see no red or green (Okabe and Ito)
    static const char* colours[] =
    {
        "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"
    };
    return colours[i % 6];
}


void Foam::melt::svgPlot::write(const fileName& file) const
{
    const scalarMinMax xRange(range(true));
    const scalarMinMax yRange(range(false));
    const auto x = [&](const scalar value)
    {
        return
            left
          + (width - left - right)*(value - xRange.min())/xRange.mag();
    };
    const auto y = [&](const scalar value)
    {
        return
            height - bottom
          - (height - top - bottom)*(value - yRange.min())/yRange.mag();
    };

    std::ofstream os(file);
    os  << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width
        << "\" height=\"" << height << "\" viewBox=\"0 0 " << width << ' '
        << height << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        << "<text x=\"" << width/2 << "\" y=\"18\" text-anchor=\"middle\""
        << " font-size=\"14\">" << title_ << "</text>\n";

    os.precision(6);
    for (const scalar value : ticks(xRange, 6))
    {
        os  << "<path d=\"M" << x(value) << ' ' << height - bottom << "V"
            << top << "\" stroke=\"#dddddd\"/>\n<text x=\"" << x(value)
            << "\" y=\"" << height - bottom + 16
            << "\" text-anchor=\"middle\">" << value << "</text>\n";
    }
    for (const scalar value : ticks(yRange, 5))
    {
        os  << "<path d=\"M" << left << ' ' << y(value) << "H"
            << width - right << "\" stroke=\"#dddddd\"/>\n<text x=\""
            << left - 6 << "\" y=\"" << y(value) + 4
            << "\" text-anchor=\"end\">" << value << "</text>\n";
    }
    os  << "<path d=\"M" << left << ' ' << top << "V" << height - bottom
        << "H" << width - right << "\" fill=\"none\" stroke=\"black\"/>\n"
        << "<text x=\"" << (left + width - right)/2 << "\" y=\"" << height - 8
        << "\" text-anchor=\"middle\">" << xTitle_ << "</text>\n";

    forAll(series_, i)
    {
        const series& s = series_[i];
        os  << "<polyline fill=\"none\" stroke-width=\"1.8\" stroke=\""
            << colour(i) << "\" points=\"";
        forAll(s.x, j)
        {
            if (std::isfinite(s.x[j]) && std::isfinite(s.y[j]))
            {
                os  << x(s.x[j]) << ',' << y(s.y[j]) << ' ';
            }
        }
        os  << "\"/>\n";

        const double begin = left + i*(width - left - right)/series_.size();
        os  << "<path d=\"M" << begin << " 36h18\" stroke-width=\"3\" stroke=\""
            << colour(i) << "\"/>\n<text x=\"" << begin + 23
            << "\" y=\"40\">" << s.name << "</text>\n";
    }
    os  << "</svg>\n";

    if (!os.flush())
    {
        FatalErrorInFunction << "Cannot write " << file << exit(FatalError);
    }
}


// ************************************************************************* //
