// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/active.h"

namespace epode {

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
    body.manifolds = nullptr;
}

}  // namespace epode
