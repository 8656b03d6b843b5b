// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "characters/walk.h"

#include <limits>

#include "characters/mover.h"

namespace epode {
namespace {

Vec3 level(const Character& c, Vec3 v) { return v - dot(v, c.up) * c.up; }

Vec3 approached(Vec3 from, Vec3 to, Real limit)
{
    const Vec3 change = to - from;
    const Real size = length(change);
    return size > limit ? from + (limit / size) * change : to;
}

// The velocity sideways. Down what is too steep to stand on it slides: it steers across alone.
Vec3 steered_from(const Character& c, Vec3 sideways, Vec3 wanted, Real h)
{
    const Vec3 steered = approached(sideways, wanted + c.inherited, c.settings.air_acceleration * h);
    Vec3 down = level(c, c.ground_normal);
    if (!normalize(down)) return steered;
    return steered + dot(sideways - steered, down) * down;
}

[[nodiscard]] bool fly(Geom& geom, Vec3 wanted, Real h)
{
    Character& c = *geom.character;
    const Real g = c.settings.gravity;
    const Vec3 before = c.momentum, sideways = level(c, before);
    const Vec3 steered = steered_from(c, sideways, wanted, h);
    const Vec3 rise = before - sideways, after = steered + rise - g * h * c.up;
    Mover mover(geom, steered + rise - Real(0.5) * g * h * c.up, h);
    if (!mover.run()) return false;
    c.momentum = mover.unhindered(after);
    return true;
}

// Before its first move it finds out what it stands on, in no time: without a push and without weight.
[[nodiscard]] bool find_ground(Geom& geom)
{
    Character& c = *geom.character;
    if (c.state != 0) return true;
    const bool launched = c.launched;
    const Vec3 velocity = c.velocity;
    Mover mover(geom, {}, std::numeric_limits<Real>::min());
    const bool done = mover.run();
    c.launched = launched, c.velocity = velocity;
    return done;
}

}  // namespace

bool move(Geom& geom, Vec3 velocity, Real h)
{
    if (!find_ground(geom)) return false;
    Mover mover(geom, velocity, h);
    if (!mover.run()) return false;
    geom.character->momentum = geom.character->velocity;
    return true;
}

bool walk(Geom& geom, Vec3 velocity, Real jump_speed, Real h)
{
    if (!find_ground(geom)) return false;
    Character& c = *geom.character;
    const Vec3 wanted = level(c, velocity);
    const Character before = c;
    const bool stands = c.state == dCharacterOnGround && !c.launched;
    bool done = false;
    if (stands && !(jump_speed > 0)) {
        Mover mover(geom, wanted, h);
        done = mover.run();
    } else {
        if (stands) {
            c.momentum = wanted + c.ground_velocity + jump_speed * c.up;
            c.inherited = level(c, c.ground_velocity);
            c.state = dCharacterInAir;
            c.ground_normal = {};
        } else if (c.state == dCharacterOnSteep) {
            c.state = dCharacterInAir;  // it slides, and is not carried
        }
        done = fly(geom, wanted, h);
    }
    if (!done) return c = before, false;
    if (c.state != dCharacterOnGround) {
        if (!stands || jump_speed > 0) return true;
        c.momentum = wanted + before.ground_velocity;  // it has walked over an edge
        c.inherited = level(c, before.ground_velocity);
    }
    return true;
}

}  // namespace epode
