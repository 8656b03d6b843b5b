// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The bodies and joints that a step visits. A body is active from the moment it wakes until the end of the
// step in which it falls asleep; a joint, until a step finds that none of its bodies is active. Inactive
// bodies and joints cost a step nothing: a step reaches them only through active ones, and then activates
// them.
#pragma once

#include "dynamics/world.h"

namespace epode {

inline bool is_active(const Body& body) { return body.world->bodies.is_active(body); }

void activate(Body& body);  // and its joints
void deactivate(Body& body);

void activate_all(World& world);

// f(joint, the body behind it or null).
template <typename F>
void for_each_joint(const Body& body, F&& f)
{
    for (JointNode* n = body.joints; n; n = n->next) f(*n->joint, n->joint->node[n == n->joint->node].body);
}

// Makes active the bodies in world.reached, which it empties, and all that acting joints connect with them.
// visit(body) for each of them may add others to world.reached. Both return false when memory is exhausted.
template <typename Visit>
[[nodiscard]] bool activate_reached(World& world, Visit&& visit)
{
    bool has_memory = true;
    while (has_memory && !world.reached.empty()) {
        Body& body = *world.reached.back();
        world.reached.pop();
        if (is_active(body)) continue;
        activate(body);
        for_each_joint(body, [&](Joint& joint, Body* other) {
            if (other && !is_active(*other) && acting(joint))
                has_memory = world.reached.push(other) && has_memory;
        });
        has_memory = visit(body) && has_memory;
    }
    return has_memory;
}

}  // namespace epode
