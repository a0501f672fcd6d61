/*---------------------------------------------------------------------------*\
    meltFoam: melting and flowing of highly viscous materials
    Copyright (C) 2026 The meltFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidContact.H"

void Foam::melt::solidContact::findPlaces
(
    const std::vector<solidBody>& bodies,
    const std::vector<int>& bodyOf
)
{
    const particles& f = system_.fluid;
    const wallState& walls = system_.walls;
    const scalar spacing = system_.spacing;
    const int n = f.size();

    // Of each particle, by its own thread
    std::vector<std::vector<place>> found(n);
    system_.near.fluid().forEach([&](const int i, const auto& row)
    {
        if (bodyOf[i] < 0)
        {
            return;
        }
        const solidBody& own = bodies[bodyOf[i]];
        const vector xi(f.x[i], f.y[i], f.z[i]);
        for (int k = 0; k < row.size(); ++k)
        {
            const int j = row[k];
            if (j <= i || bodyOf[j] < 0 || bodyOf[j] == bodyOf[i])
            {
                continue;
            }
            const vector between(xi - vector(f.x[j], f.y[j], f.z[j]));
            const scalar distance = mag(between);
            if (distance > 2*spacing)
            {
                continue;
            }
            const vector normal(between/max(distance, VSMALL));
            const vector at(xi - 0.5*between);
            found[i].push_back
            ({
                bodyOf[i], bodyOf[j], normal,
                at - own.centre, at - bodies[bodyOf[j]].centre, Zero,
                distance - spacing, 0, Zero
            });
        }

        const auto wallRow = system_.near.walls().sourcesOf(i);
        int nearest = -1;
        scalar nearest2 = GREAT;
        for (int k = 0; k < wallRow.size(); ++k)
        {
            const int j = wallRow[k];
            const scalar r2 =
                magSqr(xi - vector(walls.x[j], walls.y[j], walls.z[j]));
            if (r2 < nearest2)
            {
                nearest2 = r2;
                nearest = j;
            }
        }
        if (nearest >= 0)
        {
            const int j = nearest;
            const vector normal(walls.nx[j], walls.ny[j], walls.nz[j]);
            found[i].push_back
            ({
                bodyOf[i], -1, normal,
                xi - 0.5*spacing*normal - own.centre, Zero,
                vector(walls.wallU[j], walls.wallV[j], walls.wallW[j]),
                (normal & xi) - walls.offset[j] - 0.5*spacing, 0, Zero
            });
        }
    });

    places_.clear();
    for (const std::vector<place>& some : found)
    {
        places_.insert(places_.end(), some.begin(), some.end());
    }
}


void Foam::melt::solidContact::push
(
    std::vector<solidBody>& bodies,
    const place& at,
    const vector& impulse
)
{
    solidBody& a = bodies[at.first];
    if (!a.fixed)
    {
        a.U += impulse/a.mass;
        a.L += at.arm1 ^ impulse;
    }
    if (at.second >= 0 && !bodies[at.second].fixed)
    {
        solidBody& b = bodies[at.second];
        b.U -= impulse/b.mass;
        b.L -= at.arm2 ^ impulse;
    }
}


void Foam::melt::solidContact::push
(
    std::vector<solidBody>& bodies,
    const std::vector<int>& bodyOf,
    const scalar deltaT
)
{
    findPlaces(bodies, bodyOf);

    const auto velocity = [](const solidBody& b, const vector& arm)
    {
        return b.fixed ? vector(Zero) : vector(b.U + (b.omega() ^ arm));
    };
    // Speed along a direction that a unit impulse along it makes
    const auto mobility = [](const solidBody& b, const vector& arm, const vector& d)
    {
        const vector torque(arm ^ d);
        return b.fixed ? 0 : 1/b.mass + (torque & (b.inverseInertia & torque));
    };
    const auto slip = [&](const place& p)
    {
        return velocity(bodies[p.first], p.arm1)
          - (p.second >= 0 ? velocity(bodies[p.second], p.arm2) : p.U);
    };
    const auto mobilityOf = [&](const place& p, const vector& d)
    {
        return mobility(bodies[p.first], p.arm1, d)
          + (p.second >= 0 ? mobility(bodies[p.second], p.arm2, d) : 0);
    };

    for (label sweep = 0; sweep < sweeps_; ++sweep)
    {
        for (place& p : places_)
        {
            const scalar normalMobility = mobilityOf(p, p.normal);
            if (!(normalMobility > 0))
            {
                continue;
            }
            const scalar speed = slip(p) & p.normal;
            const scalar allowed = -max(p.gap, scalar(0))/deltaT;
            const scalar impulse =
                max(scalar(0), p.impulse + (allowed - speed)/normalMobility);
            push(bodies, p, (impulse - p.impulse)*p.normal);
            p.impulse = impulse;
            if (!(impulse > 0))
            {
                push(bodies, p, -p.friction);
                p.friction = Zero;
                continue;
            }

            const vector u(slip(p));
            const vector tangential(u - (u & p.normal)*p.normal);
            const scalar size = mag(tangential);
            if (!(size > 0))
            {
                continue;
            }
            vector friction
            (
                p.friction - tangential/mobilityOf(p, tangential/size)
            );
            const scalar most = friction_*impulse;
            if (mag(friction) > most)
            {
                friction *= most/mag(friction);
            }
            push(bodies, p, friction - p.friction);
            p.friction = friction;
        }
    }
}

// ************************************************************************* //
