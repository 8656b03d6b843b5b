// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "scenes/characters.h"

#include "record/watch/lookup.h"

namespace epode::scenes {

#define EPODE_FOUND(name) reinterpret_cast<decltype(&(name))>(record::library_function(#name))

dGeomID add_character(Scene& scene, int shape, Vec feet)
{
    const auto init = EPODE_FOUND(dCharacterSettingsInit);
    const auto create = EPODE_FOUND(dCharacterCreate);
    const auto place = EPODE_FOUND(dCharacterSetPosition);
    if (!init || !create || !place) return nullptr;
    dCharacterSettings settings;
    init(&settings, sizeof settings);
    settings.shape = shape;
    const dGeomID character = create(scene.space(), &settings);
    place(character, dReal(feet.x), dReal(feet.y), dReal(feet.z));
    scene.add_geom(character);
    return character;
}

void walk(dGeomID character, Vec velocity, double jump_speed, double dt)
{
    static const auto step = EPODE_FOUND(dCharacterWalk);
    const dVector3 wanted = {dReal(velocity.x), dReal(velocity.y), dReal(velocity.z)};
    if (step) step(character, wanted, dReal(jump_speed), dReal(dt));
}

Vec feet_of(dGeomID character)
{
    static const auto get = EPODE_FOUND(dCharacterGetPosition);
    dVector3 feet = {0, 0, 0};
    if (get) get(character, feet);
    return {double(feet[0]), double(feet[1]), double(feet[2])};
}

bool is_character(dGeomID geom)
{
    static const auto asked = EPODE_FOUND(dGeomIsCharacter);
    return asked && asked(geom);
}

}  // namespace epode::scenes
