// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Damping d and dry friction f of a free joint (MJCF), along the axes of its six velocities: the world's of the origin, the link's of the
// turn. With the inertia m of the link alone, an implicit step gives the damper's force -d v / (1 + h d / m), which only slows
// down whatever hangs on the link; friction then takes at most what stops it.
#include <algorithm>

#include "robots/body_poses.h"
#include "robots/build.h"

namespace epode::robots {

namespace {

// Of each component.
Vec drag_of(const Joint& joint, Vec rate, double inertia, double h)
{
    Vec out;
    for (int i = 0; i < 3; ++i) {
        const double damper = -joint.damping * rate[i] / (1 + h * joint.damping / inertia);
        const double stop = -(rate[i] * inertia / h + damper);
        out[i] = damper + std::clamp(stop, -joint.friction, joint.friction);
    }
    return out;
}

}  // namespace

int Robot::add_free_drag(double h)
{
    int count = 0;
    for (const Joint& joint : model().joints) {
        if (joint.kind != JointKind::kFree || (joint.damping <= 0 && joint.friction <= 0)) continue;
        const dBodyID its = body(joint.link);
        const Link& link = model().links[size_t(joint.link)];
        const double moment = principal_moments(link.inertia)[0];
        if (!its || !dBodyIsEnabled(its) || !(link.mass > 0) || !(moment > 0)) continue;
        const Pose at = pose_of(its);
        const Vec origin = at * -link.centre, turn = rotate(conjugate(at.q), vec_of(dBodyGetAngularVel(its)));
        const Vec linear = rotate(conjugate(placement_.q), velocity_at(joint.link, origin));
        const Vec force = rotate(placement_.q, drag_of(joint, linear, link.mass, h));
        const Vec torque = rotate(at.q, drag_of(joint, turn, moment, h));
        add_force(its, force, torque + cross(origin - at.p, force));
        ++count;
    }
    return count;
}

}  // namespace epode::robots
