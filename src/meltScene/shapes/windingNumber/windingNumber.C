/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "windingNumber.H"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using vector = Foam::melt::windingNumber::vector;
using triangle = Foam::melt::windingNumber::triangle;

//- Triangles of a leaf: so many cost about as much as two nodes below it
constexpr int leafSize = 8;

//- The tree halves at each level, so that this is deep enough for any int
constexpr int maxDepth = 64;


vector areaVector(const triangle& t)
{
    return 0.5*(t.b - t.a).cross(t.c - t.a);
}


vector centroid(const triangle& t)
{
    return (t.a + t.b + t.c)/3;
}


bool degenerate(const triangle& t)
{
    const double squaredEdge = std::max
    ({
        (t.b - t.a).squaredNorm(),
        (t.c - t.b).squaredNorm(),
        (t.a - t.c).squaredNorm()
    });

    return
        areaVector(t).norm()
     <= std::numeric_limits<double>::epsilon()*squaredEdge;
}


//- Van Oosterom, Strackee (1983), doi 10.1109/TBME.1983.325207
double solidAngle(const triangle& t, const vector& x)
{
    const vector a = t.a - x;
    const vector b = t.b - x;
    const vector c = t.c - x;
    const double magA = a.norm();
    const double magB = b.norm();
    const double magC = c.norm();

    return 2*std::atan2
    (
        a.dot(b.cross(c)),
        magA*magB*magC + a.dot(b)*magC + b.dot(c)*magA + c.dot(a)*magB
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int Foam::melt::windingNumber::addNode(const int begin, const int end)
{
    node n;
    n.begin = begin;
    n.end = end;
    n.left = n.right = 0;

    vector lowest = vector::Constant(std::numeric_limits<double>::max());
    vector highest = -lowest;
    double sumArea = 0;
    n.centre.setZero();
    n.area.setZero();
    for (int i = begin; i < end; ++i)
    {
        const vector x = centroid(triangles_[i]);
        const vector A = areaVector(triangles_[i]);
        lowest = lowest.cwiseMin(x);
        highest = highest.cwiseMax(x);
        sumArea += A.norm();
        n.centre += A.norm()*x;
        n.area += A;
    }
    n.centre /= sumArea;

    n.radius = 0;
    n.moment.setZero();
    for (int i = begin; i < end; ++i)
    {
        const triangle& t = triangles_[i];
        for (const vector* corner : {&t.a, &t.b, &t.c})
        {
            n.radius = std::max(n.radius, (*corner - n.centre).norm());
        }
        n.moment += (centroid(t) - n.centre)*areaVector(t).transpose();
    }

    const int label = nodes_.size();
    nodes_.push_back(n);

    if (end - begin > leafSize)
    {
        int axis;
        (highest - lowest).maxCoeff(&axis);

        const int middle = begin + (end - begin)/2;
        std::nth_element
        (
            triangles_.begin() + begin,
            triangles_.begin() + middle,
            triangles_.begin() + end,
            [axis](const triangle& t, const triangle& u)
            {
                return centroid(t)[axis] < centroid(u)[axis];
            }
        );

        const int left = addNode(begin, middle);
        const int right = addNode(middle, end);
        nodes_[label].left = left;
        nodes_[label].right = right;
    }

    return label;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::melt::windingNumber::windingNumber
(
    std::vector<triangle> triangles,
    const double accuracy
)
:
    triangles_(std::move(triangles)),
    nodes_(),
    squaredAccuracy_(accuracy*accuracy),
    nDegenerate_(triangles_.size())
{
    triangles_.erase
    (
        std::remove_if(triangles_.begin(), triangles_.end(), degenerate),
        triangles_.end()
    );
    nDegenerate_ -= triangles_.size();

    if (!triangles_.empty())
    {
        nodes_.reserve(4*triangles_.size()/leafSize + 1);
        addNode(0, triangles_.size());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::melt::windingNumber::operator()(const vector& x) const
{
    double sum = 0;

    std::array<int, maxDepth> waiting;
    int nWaiting = 0;
    if (!nodes_.empty())
    {
        waiting[nWaiting++] = 0;
    }

    while (nWaiting)
    {
        const node& n = nodes_[waiting[--nWaiting]];
        const vector d = n.centre - x;
        const double d2 = d.squaredNorm();

        if (d2 > squaredAccuracy_*n.radius*n.radius)
        {
            const double rd3 = 1/(d2*std::sqrt(d2));
            sum +=
                rd3
               *(
                    d.dot(n.area)
                  + n.moment.trace()
                  - 3*d.dot(n.moment*d)/d2
                );
        }
        else if (n.left)
        {
            waiting[nWaiting++] = n.left;
            waiting[nWaiting++] = n.right;
        }
        else
        {
            for (int i = n.begin; i < n.end; ++i)
            {
                sum += solidAngle(triangles_[i], x);
            }
        }
    }

    return sum/(4*M_PI);
}


double Foam::melt::windingNumber::volume() const
{
    if (nodes_.empty())
    {
        return 0;
    }

    // About a point in the middle, for the sake of round-off
    const vector& o = nodes_[0].centre;
    double sum = 0;
    for (const triangle& t : triangles_)
    {
        sum += (t.a - o).dot((t.b - o).cross(t.c - o));
    }

    return sum/6;
}


// ************************************************************************* //
