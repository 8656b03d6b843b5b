// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/active.h"

namespace epode {
namespace {

// f(joint, the body behind it or null).
template <typename F>
void for_each_joint(const Body& body, F&& f)
{
    for (JointNode* n = body.joints; n; n = n->next) f(*n->joint, n->joint->node[n == n->joint->node].body);
}

}  // namespace

void activate(Body& body)
{
    World& world = *body.world;
    if (is_active(body)) return;
    world.bodies.activate(body);
    for_each_joint(body, [&](Joint& joint, Body*) { world.joints.activate(joint); });
}

void activate_all(World& world)
{
    if (world.bodies.active_count() == world.bodies.count()) return;
    for (Body& body : world.bodies) activate(body);
}

void deactivate(Body& body)
{
    body.world->bodies.deactivate(body);
    body.patches = nullptr;
}

bool activate_reached(World& world)
{
    bool room = true;
    while (!world.reached.empty()) {
        Body& body = *world.reached.back();
        world.reached.pop();
        if (is_active(body)) continue;
        activate(body);
        for_each_joint(body, [&](Joint& joint, Body* other) {
            if (other && !is_active(*other) && acting(joint)) room = world.reached.push(other) && room;
        });
    }
    return room;
}

}  // namespace epode
