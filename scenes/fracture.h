// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies that break (ode/fracture.h) for scenes, whose functions are sought at run time: in a library without them their parts are
// static.
#pragma once

#include <ode/ext.h>

#include <vector>

#include "scenes/scene.h"

namespace epode::scenes {

// Parts where their geoms are, which the scene has. Before each step what the last one has hit harder than strength (N s) breaks:
// parts within radius (m) come off. Returns the body; null where there is none.
dBodyID add_breakable(Scene& scene, const std::vector<dFracturePart>& parts, double strength, double radius);

}  // namespace epode::scenes
