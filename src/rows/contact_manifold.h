// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A contact manifold of two bodies that the world manages, as solvers see it: up to four points with one normal
// n. Floats suffice, since all of it is relative to the bodies: arms of a metre are known to 60 nm wherever
// in the world they are. What is solved for comes back in it and starts the next step.
//
//   u = v1 + w1 x r1 - v2 - w2 x r2,   gap' = n . u,   push >= 0,   |friction| <= mu push
//
// Friction is bounded in the plane as a whole (a cone), the same in every direction; so is the couple against
// rolling and spinning, |roll| <= rolling * sum of push, in all three.
#pragma once

#include "math/float3.h"

namespace epode {

inline constexpr int kManifoldPoints = 4;

// Here as below, neighbours are read four numbers at a time (solve/substeps/manifold_gather.inc).
struct ManifoldPoint {
    Float3 r1;        // from the centre of body 1, world frame, at the beginning of the step
    float gap;        // distance along n beyond the layer; below zero: deeper than allowed
    Float3 r2;        // from the centre of body 2
    float push;       // impulse along n over the whole step: of the last one in, of this one out
    Float3 friction;  // the same in the plane, as a vector of the world
};

struct ContactManifold {
    int body1, body2;  // in the island; -1: the world, only for body2
    int count;         // points; 0: does not touch
    Float3 normal;     // unit, into body1
    float mu;
    Float3 drift;        // wanted u in the plane: surfaces that move
    float bounce;        // rebound: so many times an approach
    float bounce_speed;  // of at least that, m/s
    float rolling;       // m
    float softness;      // of each point, depth per force, m/N; 0: hard
    float damping_time;  // of what is soft: damper over spring, s
    Float3 roll;         // angular impulse on body1 over the whole step, in and out as `push`
    ManifoldPoint points[kManifoldPoints];

    bool special() const { return rolling > 0 || softness > 0; }
};

}  // namespace epode
