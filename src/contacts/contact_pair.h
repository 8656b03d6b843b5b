// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the world remembers of two geoms from step to step: where they were when they were last collided, and
// the patch that came of it, its points fixed in both. Between surfaces (meshes, height fields) and others a
// pair has several parts, one record each, for patches of different normals; part 0 speaks for the pair.
#pragma once

#include "collide/geom.h"
#include "dynamics/body.h"
#include "rows/patch.h"

namespace epode {

inline constexpr int kSurfaceParts = 3;

struct ContactAnchor {
    Float3 a1, a2;  // one place when they were collided, in the frames of the two geoms
    float gap;      // then
};

struct ContactPair {
    Geom *g1, *g2;     // g1 has a body; live during a step only
    dGeomID id1, id2;  // the same for later
    std::uint64_t serial1, serial2;
    Body *body1, *body2;  // body2 may be null
    int part, parts;
    int old;        // part 0's record of the step before, -1: none
    bool wanted;    // the filter, and joints between the bodies
    bool touched;   // in the step before
    Vec3 origin;    // of body1 at the step's beginning
    float layer;    // depth that was allowed then
    Float3 offset;  // of g2 in g1's frame when they were collided
    Float3 turn[3];
    Float3 normal;  // in g1's frame
    ContactAnchor anchors[kPatchPoints];
    Patch patch;
};

}  // namespace epode
