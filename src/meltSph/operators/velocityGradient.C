/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocityGradient.H"

namespace Foam
{
namespace melt
{
namespace
{

//- grad v: component ab is d v_a / d x_b
struct gradient
{
    double xx = 0, xy = 0, xz = 0;
    double yx = 0, yy = 0, yz = 0;
    double zx = 0, zy = 0, zz = 0;
};

//- Deviatoric deformation tensor of particle i
inline void setDeformation
(
    particles& f,
    const int i,
    const gradient& g,
    const int dimensions
)
{
    const double mean = 2*(g.xx + g.yy + g.zz)/dimensions;
    const double xx = 2*g.xx - mean;
    const double yy = 2*g.yy - mean;
    const double zz = dimensions == 3 ? 2*g.zz - mean : 0;
    const double xy = g.xy + g.yx;
    const double xz = g.xz + g.zx;
    const double yz = g.yz + g.zy;

    f.S[0][i] = xx;
    f.S[1][i] = xy;
    f.S[2][i] = xz;
    f.S[3][i] = yy;
    f.S[4][i] = yz;
    f.S[5][i] = zz;
}

} // End anonymous namespace
} // End namespace melt
} // End namespace Foam


void Foam::melt::velocityGradient
(
    const neighbourhood& near,
    const wallState& walls,
    particles& f,
    const bool deformation
)
{
    const double* const x = f.x.data();
    const double* const y = f.y.data();
    const double* const z = f.z.data();
    const double* const u = f.u.data();
    const double* const v = f.v.data();
    const double* const w = f.w.data();
    const double* const V = f.V.data();
    const int dimensions = near.kernel().dimensions();

    near.kernel().visit([&](const auto& W)
    {
        near.fluid().forEach([&](const int i, const auto& row)
        {
            const double xi = x[i], yi = y[i], zi = z[i];
            const double ui = u[i], vi = v[i], wi = w[i];

            double xx = 0, xy = 0, xz = 0;
            double yx = 0, yy = 0, yz = 0;
            double zx = 0, zy = 0, zz = 0;

            #pragma omp simd reduction(+:xx,xy,xz,yx,yy,yz,zx,zy,zz)
            for (int k = 0; k < row.size(); ++k)
            {
                const int j = row[k];
                const double dx = xi - x[j], dy = yi - y[j], dz = zi - z[j];
                const double F =
                    V[j]*W.gradientOverR(dx*dx + dy*dy + dz*dz);
                const double du = F*(u[j] - ui);
                const double dv = F*(v[j] - vi);
                const double dw = F*(w[j] - wi);
                xx += du*dx;
                xy += du*dy;
                xz += du*dz;
                yx += dv*dx;
                yy += dv*dy;
                yz += dv*dz;
                zx += dw*dx;
                zy += dw*dy;
                zz += dw*dz;
            }

            gradient g{xx, xy, xz, yx, yy, yz, zx, zy, zz};
            double divergence = xx + yy + zz;

            const auto wallRow = near.walls().sourcesOf(i);
            for (int k = 0; k < wallRow.size(); ++k)
            {
                const int j = wallRow[k];
                const double dx = xi - walls.x[j];
                const double dy = yi - walls.y[j];
                const double dz = zi - walls.z[j];
                const double F =
                    walls.volume[j]*W.gradientOverR(dx*dx + dy*dy + dz*dz);

                divergence +=
                    F
                   *(
                        (walls.wallU[j] - ui)*dx
                      + (walls.wallV[j] - vi)*dy
                      + (walls.wallW[j] - wi)*dz
                    );

                const double du = F*(walls.u[j] - ui);
                const double dv = F*(walls.v[j] - vi);
                const double dw = F*(walls.w[j] - wi);
                g.xx += du*dx;
                g.xy += du*dy;
                g.xz += du*dz;
                g.yx += dv*dx;
                g.yy += dv*dy;
                g.yz += dv*dz;
                g.zx += dw*dx;
                g.zy += dw*dy;
                g.zz += dw*dz;
            }

            f.dRho[i] = -f.rho[i]*divergence;
            if (deformation)
            {
                setDeformation(f, i, g, dimensions);
            }
        });
    });
}

// ************************************************************************* //
