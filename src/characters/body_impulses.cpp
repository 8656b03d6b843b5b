// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a character does to bodies. Against a body that is in its way, or that comes at it, it has the impulse
//   J = min(v / (d . K d), what is left of F h)    along d = -n
// with v the speed at which the two approach, K what a unit impulse gives to the point (dynamics/impulse.h)
// and F the greatest force, for all bodies of one move together. On what it stands on it weighs m g h.
#include <algorithm>

#include "characters/mover.h"
#include "dynamics/impulse.h"
#include "step/common/link.h"

namespace epode {
namespace {

Body* body_under(dGeomID ground)
{
    Geom* const geom = from_handle<Geom>(ground);
    Body* const body = geom ? body_of(*geom) : nullptr;
    return body && !body->kinematic() ? body : nullptr;
}

bool gives_way(const Body& body) { return body.auto_disable && (body.fluid.wet || body.lasting); }

}  // namespace

Body* Mover::body_behind(const Touch& touch) const
{
    Body* const body = body_of(*around_[touch.obstacle].geom);
    return body && !body->kinematic() ? body : nullptr;
}

// What floats less deep without it.
void Mover::unload(dGeomID ground)
{
    Body* const body = body_under(ground);
    if (body && body->disabled && gives_way(*body)) wake(*body);
}

void Mover::push(const Touch& touch)
{
    Body* const body = body_behind(touch);
    if (!body || !(force_left_ > 0)) return;
    const Vec3 d = -touch.normal, arm = touch.pos - body->position();
    const Real approach = dot(velocity_ - body->point_velocity(touch.pos), d);
    const Real yields = yielding(*body, arm, d);
    if (!(approach > 0) || !(yields > 0)) return;
    const Real impulse = std::min(approach / yields, force_left_);
    force_left_ -= impulse;
    wake(*body);
    add_impulse(*body, impulse * d, arm);
}

// What sleeps under it has borne it when it fell asleep. It wakes where it would give way: what floats or has joints, when the
// weight has come or moved.
void Mover::weigh(bool elsewhere)
{
    Body* const body = body_under(character_.ground);
    if (!body) return;
    if (body->disabled && elsewhere && gives_way(*body)) wake(*body);
    if (body->disabled) return;
    const Vec3 impulse = -(settings_.mass * settings_.gravity * h_) * up_;
    add_impulse(*body, impulse, character_.ground_pos - body->position());
}

}  // namespace epode
