// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Characters (ode/character.h) for scenes, whose functions are sought at run time: a library without them has none.
#pragma once

#include <ode/ext.h>

#include "scenes/scene.h"
#include "scenes/vectors.h"

namespace epode::scenes {

// A character of a shape (dCapsuleClass, dCylinderClass or dBoxClass) with its feet at a place; null where there are none.
dGeomID add_character(Scene& scene, int shape, Vec feet);
// One step of a walk, before the step of the world.
void walk(dGeomID character, Vec velocity, double jump_speed, double dt);
Vec feet_of(dGeomID character);
// Contacts are not for characters: a scene that makes them itself leaves them out.
bool is_character(dGeomID geom);

}  // namespace epode::scenes
