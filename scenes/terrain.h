// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Terrain for scenes: a height field, heights along z, around the origin.
#pragma once

#include <functional>

#include "scenes/scene.h"

namespace epode::scenes {

// A square of that side with samples + 1 heights along each side.
dGeomID add_terrain(Scene& scene, double side, int samples,
                    const std::function<double(double, double)>& height);

}  // namespace epode::scenes
