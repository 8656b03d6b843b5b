// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See touching.h. The maps are asked and never walked, but to forget: no result depends on their order.
#include "scenes/touching.h"

#include <algorithm>
#include <cmath>

#include "scenes/vectors.h"

namespace epode::scenes {

void Touching::remember(const Scene& scene)
{
    for (dBodyID body : scene.bodies()) {
        const dReal *pos = dBodyGetPosition(body), *linear = dBodyGetLinearVel(body),
                    *angular = dBodyGetAngularVel(body);
        Motion& motion = motions_[body];
        for (int k = 0; k < 3; ++k) {
            motion.pos[k] = double(pos[k]);
            motion.linear[k] = double(linear[k]);
            motion.angular[k] = double(angular[k]);
        }
    }
}

void Touching::velocity_at(dGeomID geom, const double* pos, double* velocity) const
{
    const auto found = motions_.find(dGeomGetBody(geom));
    if (found == motions_.end()) return;
    const Motion& motion = found->second;
    const Vec v = vec(motion.linear) + cross(vec(motion.angular), vec(pos) - vec(motion.pos));
    velocity[0] = v.x, velocity[1] = v.y, velocity[2] = v.z;
}

void Touching::judge(const ContactRecord& contact)
{
    if (!(contact.depth >= 0)) return;  // not yet together
    double first[3] = {0, 0, 0}, second[3] = {0, 0, 0};
    velocity_at(contact.geom1, contact.pos, first);
    velocity_at(contact.geom2, contact.pos, second);
    const Vec against = vec(first) - vec(second);
    const Pair pair{std::min(contact.geom1, contact.geom2), std::max(contact.geom1, contact.geom2)};
    Touch& touch = touches_[pair];
    if (touch.last < step_ - 1 || touch.last == 0) touch = {step_, step_, 0};
    touch.last = step_;
    if (touch.since == step_) touch.speed = std::max(touch.speed, -dot(against, vec(contact.normal)));
    if (step_ - touch.since + 1 >= kRestSteps && length(against) < kRestSpeed) {
        at_rest = std::max(at_rest, contact.depth);
    } else if (contact.depth > at_impact.depth) {
        at_impact = {contact.depth, step_, touch.speed};
    }
}

void Touching::observe(const Scene& scene)
{
    ++step_;
    for (const ContactRecord& contact : scene.contacts()) judge(contact);
    std::erase_if(touches_, [&](const auto& entry) { return entry.second.last < step_; });
    remember(scene);
}

}  // namespace epode::scenes
