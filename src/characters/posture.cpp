// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "characters/posture.h"

#include "characters/surroundings.h"
#include "collide/space.h"

namespace epode {
namespace {

// Of what it may be closer to than the skin and still stand up, as a part of the skin.
constexpr Real kPinched = Real(0.5);

void put_height(Geom& geom, Real height, Vec3 foot)
{
    set_shape_height(geom, height);
    store(geom.own_position, foot + (half_height(geom) + geom.character->settings.skin) * geom.character->up);
    geom.box_stale = true;
}

bool stands_free(Geom& geom)
{
    Surroundings around(geom, {});
    if (!geom.space) return true;
    const Real skin = geom.character->settings.skin;
    const Vec3 reach = {skin, skin, skin};
    const Aabb box = box_of(geom);
    if (!around.collect(*geom.space, {box.lo - reach, box.hi + reach})) return false;
    for (int i = 0; i < around.count(); ++i)
        if (around.touch(i, load(geom.own_position), 0).distance < -kPinched * skin) return false;
    return true;
}

}  // namespace

Vec3 foot_of(const Geom& geom)
{
    const Character& c = *geom.character;
    return load(geom.position) - (half_height(geom) + c.settings.skin) * c.up;
}

void put_foot(Geom& geom, Vec3 foot)
{
    const Character& c = *geom.character;
    store(geom.own_position, foot + (half_height(geom) + c.settings.skin) * c.up);
    mark_moved(geom);
}

void forget_ground(Character& character)
{
    character.ground = nullptr, character.ground_side = -1;
    character.ground_pos = character.ground_normal = character.ground_velocity = character.carried = {};
    character.ground_pose = {};
    character.state = 0;
}

bool change_height(Geom& geom, Real height)
{
    const Real before = 2 * half_height(geom);
    const Vec3 foot = foot_of(geom), centre = load(geom.own_position);
    put_height(geom, height, foot);
    if (height > before && !stands_free(geom)) {
        put_height(geom, before, foot);
        store(geom.own_position, centre);
        return false;
    }
    geom.character->settings.height = height;
    mark_changed(geom);
    mark_moved(geom);
    return true;
}

}  // namespace epode
