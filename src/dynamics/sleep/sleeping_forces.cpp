// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/sleep/sleeping_forces.h"

namespace epode {

void note_forces(Body& body)
{
    ForcedLink& link = body.forced;
    if (!body.disabled || link.from) return;
    Body*& first = body.world->first_forced;
    link = {first, &first};
    if (first) first->forced.from = &link.next;
    first = &body;
}

void forget_forces(Body& body)
{
    ForcedLink& link = body.forced;
    if (!link.from) return;
    *link.from = link.next;
    if (link.next) link.next->forced.from = link.from;
    link = {};
}

void clear_sleeping_forces(World& world)
{
    while (Body* body = world.first_forced) {
        forget_forces(*body);
        if (!body->disabled || world.acts_as_ode()) continue;
        store(body->facc, {}), store(body->tacc, {});
    }
}

}  // namespace epode
