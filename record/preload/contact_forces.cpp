// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See contact_forces.h. A feedback has the force on the first body of the joint; where one body is attached,
// on that one, whichever geom it belongs to.
#include "record/preload/contact_forces.h"

namespace epode::record {

namespace {

// The force on what has the contact's first geom.
void read_force(dJointID joint, dGeomID first, const dJointFeedback& feedback, double* force)
{
    const dBodyID a = dJointGetBody(joint, 0), b = dJointGetBody(joint, 1);
    const dBodyID body = first ? dGeomGetBody(first) : nullptr;
    const bool only_one = !a || !b;
    const dReal* on = !only_one && body && body == b ? feedback.f2 : feedback.f1;
    const double sign = only_one && first && !body ? -1 : 1;
    for (int k = 0; k < 3; ++k) force[k] = sign * double(on[k]);
}

}  // namespace

void ContactForces::add(dJointID joint, dJointGroupID group, const dContactGeom& geom)
{
    ContactSeen& seen = seen_.emplace_back();
    seen = {{geom.g1, geom.g2}, {}, {}, double(geom.depth), {}};
    for (int k = 0; k < 3; ++k) seen.pos[k] = double(geom.pos[k]), seen.normal[k] = double(geom.normal[k]);
    made_.push_back({joint, group});
}

void ContactForces::forget(dJointID joint)
{
    for (Made& made : made_) {
        if (made.joint == joint) made.joint = nullptr;
    }
}

void ContactForces::forget(dJointGroupID group)
{
    for (Made& made : made_) {
        if (made.group == group) made.joint = nullptr;
    }
}

void ContactForces::ask()
{
    feedback_.assign(made_.size(), {});
    for (size_t i = 0; i < made_.size(); ++i) {
        Made& made = made_[i];
        made.ours = made.joint && !dJointGetFeedback(made.joint);
        if (made.ours) dJointSetFeedback(made.joint, &feedback_[i]);
    }
}

std::vector<ContactSeen> ContactForces::take()
{
    for (size_t i = 0; i < made_.size() && i < feedback_.size(); ++i) {
        const Made& made = made_[i];
        if (!made.joint) continue;
        if (const dJointFeedback* feedback = dJointGetFeedback(made.joint))
            read_force(made.joint, seen_[i].geom[0], *feedback, seen_[i].force);
        if (made.ours) dJointSetFeedback(made.joint, nullptr);
    }
    std::vector<ContactSeen> seen;
    seen.swap(seen_);
    made_.clear();
    return seen;
}

}  // namespace epode::record
