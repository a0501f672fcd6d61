/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidBody.H"

#include <Eigen/Dense>

namespace
{

using namespace Foam;

//- Rotation by the vector theta [rad] (Rodrigues), orthogonal to round-off
tensor rotation(const vector& theta)
{
    const scalar angle = mag(theta);
    if (angle <= 0)
    {
        return tensor::I;
    }
    const vector n(theta/angle);
    const tensor cross(0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0);
    return tensor::I
      + std::sin(angle)*cross
      + 2*sqr(std::sin(0.5*angle))*(cross & cross);
}


symmTensor rotated(const tensor& R, const symmTensor& I)
{
    return symm(R & I & R.T());
}

} // End anonymous namespace


Foam::symmTensor Foam::melt::solidBody::pseudoInverse(const symmTensor& t)
{
    Eigen::Matrix3d a;
    a << t.xx(), t.xy(), t.xz(),
         t.xy(), t.yy(), t.yz(),
         t.xz(), t.yz(), t.zz();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
    const Eigen::Vector3d values = solver.eigenvalues();
    Eigen::Vector3d inverse;
    for (int k = 0; k < 3; ++k)
    {
        inverse[k] = values[k] > ROOTSMALL*values[2] ? 1/values[k] : 0;
    }
    const Eigen::Matrix3d& e = solver.eigenvectors();
    const Eigen::Matrix3d b = e*inverse.asDiagonal()*e.transpose();
    return symmTensor(b(0, 0), b(0, 1), b(0, 2), b(1, 1), b(1, 2), b(2, 2));
}


void Foam::melt::solidBody::setGeometry(const particles& f)
{
    mass = 0;
    vector sum(Zero);
    for (const int i : members)
    {
        mass += f.m[i];
        sum += f.m[i]*vector(f.x[i], f.y[i], f.z[i]);
    }
    // One particle does not spin: no inertia of round-off
    const int first = members.front();
    centre =
        members.size() == 1
      ? vector(f.x[first], f.y[first], f.z[first])
      : sum/mass;

    inertia = Zero;
    for (const int i : members)
    {
        const vector r(arm(f, i));
        inertia += f.m[i]*(magSqr(r)*symmTensor::I - sqr(r));
    }
    inverseInertia = pseudoInverse(inertia);
}


void Foam::melt::solidBody::setMotion
(
    const particles& f,
    const std::vector<double>& u,
    const std::vector<double>& v,
    const std::vector<double>& w
)
{
    U = Zero;
    L = Zero;
    for (const int i : members)
    {
        const vector momentum(f.m[i]*vector(u[i], v[i], w[i]));
        U += momentum;
        L += arm(f, i) ^ momentum;
    }
    U /= mass;
}


void Foam::melt::solidBody::setVelocities
(
    const particles& f,
    std::vector<double>& u,
    std::vector<double>& v,
    std::vector<double>& w
) const
{
    const vector spin(omega());
    for (const int i : members)
    {
        const vector velocity
        (
            fixed ? vector(Zero) : vector(U + (spin ^ arm(f, i)))
        );
        u[i] = velocity.x();
        v[i] = velocity.y();
        w[i] = velocity.z();
    }
}


void Foam::melt::solidBody::move(particles& f, const scalar deltaT)
{
    // Spin half way: the inertia turns with the body
    const tensor half(rotation(0.5*deltaT*omega()));
    const vector spin(rotated(half, inverseInertia) & L);
    const tensor R(rotation(deltaT*spin));
    const vector way(deltaT*U);

    for (const int i : members)
    {
        const vector r(R & arm(f, i));
        f.x[i] = centre.x() + way.x() + r.x();
        f.y[i] = centre.y() + way.y() + r.y();
        f.z[i] = centre.z() + way.z() + r.z();
    }
    centre += way;
    inertia = rotated(R, inertia);
    inverseInertia = rotated(R, inverseInertia);
}

// ************************************************************************* //
