// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where bodies will be at the end of a step if nothing but gravity acts on them: what the broad phase makes
// room for and the narrow phase looks at must be the same. Null bodies are what does not move.
#pragma once

#include "collide/geom.h"
#include "dynamics/body.h"

namespace epode {

struct SpeculativeMotion {
    Real h;        // s
    Vec3 gravity;  // m/s^2

    // At the end of the step.
    Vec3 velocity(const Body* body) const;
    Pose pose(const Body* body, const Pose& now) const;  // of a geom of the body
    Aabb box(const Body* body, const Aabb& now) const;   // holds what has the box now
};

}  // namespace epode
