// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a ray meets first: of a space, by the library; of a moment of a recording, by its triangles.
#pragma once

#include <ode/ode.h>

#include <optional>

#include "view/session/session.h"

namespace epode::view {

struct Met {
    dGeomID geom;
    Vec point;
    double distance;
};

// By dSpaceRayClosest where the library has it, else with a ray geom. Origins inside a geom see its far wall.
std::optional<Met> closest_geom(dSpaceID space, Vec origin, Vec direction);

std::optional<Hit> closest_triangle(const Stage& stage, const Moment& now, Vec origin, Vec direction);

}  // namespace epode::view
