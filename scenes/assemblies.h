// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ragdolls, ropes, bodies that break and blasts (ode/ragdoll.h, rope.h, fracture.h, impulses.h) for scenes, whose functions are sought
// at run time: a library without them has no figures and ropes, its parts are static, and nothing blows up.
#pragma once

#include <ode/ext.h>

#include <vector>

#include "scenes/scene.h"
#include "scenes/vectors.h"

namespace epode::scenes {

// Parts where their geoms are, which the scene has. Before each step what the last one has hit harder than strength (N s) breaks:
// parts within radius (m) come off. Returns the body; null where there is none.
dBodyID add_breakable(Scene& scene, const std::vector<dFracturePart>& parts, double strength, double radius);

// A human with its soles at a place; motors of so much strength hold it as it stands, 0: it is limp. Returns its bodies, the pelvis first.
std::vector<dBodyID> add_human(Scene& scene, Vec at, Turn q, double height, double mass, double strength);

// The defaults of the library; all 0 in one without ropes.
dRopeSettings rope_settings();
// Returns its links.
std::vector<dBodyID> add_rope(Scene& scene, Vec from, Vec to, const dRopeSettings& settings,
                              dBodyID last = nullptr);

// An impulse (N s) away from a place on all bodies of some categories within a radius that nothing hides, less with the distance.
void blow_up(Scene& scene, Vec at, double radius, double impulse, unsigned long categories);

}  // namespace epode::scenes
