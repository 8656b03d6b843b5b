// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the world remembers of two geoms from step to step. A pair fills one cache line: most pairs are only
// near, and large worlds have more of them than the cache holds. Pairs that touch also have manifolds: those
// of the last collision, with their points fixed in both geoms; between surfaces (meshes, height fields) and
// other geoms up to three, of different normals. A solid and a mesh also keep which part of the mesh is near
// (bvh/near_leaves.h).
#pragma once

#include "base/config.h"
#include "collide/geom.h"
#include "dynamics/body.h"
#include "rows/contact_manifold.h"

namespace epode {

inline constexpr int kSurfaceManifolds = 3;
inline constexpr Real kAnchorCell = 1024;  // of the lattice of frame_of_anchors(), m

// One place for each point of a manifold when the two were collided, in the frames of both geoms; side by
// side. What is missing repeats the last.
struct ContactAnchors {
    float a1[3][kManifoldPoints], a2[3][kManifoldPoints];
    float separation[kManifoldPoints];  // then

    Float3 first(int i) const { return {a1[0][i], a1[1][i], a1[2][i]}; }
    Float3 second(int i) const { return {a2[0][i], a2[1][i], a2[2][i]}; }
};

// What the last collision has found of a manifold.
struct ManifoldFinding {
    std::uint32_t changes;  // of both geoms' shapes, then
    Float3 offset;          // of g2 in g1's frame, then
    Float3 turn[3];
    Float3 normal;  // in g1's frame
    ContactAnchors anchors;
};

struct CachedManifold {
    Vec3 origin;  // of body1 at the step's beginning
    float layer;  // depth that was allowed then
    ManifoldFinding found;
    ContactManifold manifold;  // has points
};

inline constexpr int kTakenOver = -2;

struct ContactPair {
    dGeomID id1, id2;  // id1's geom has a body
    std::uint64_t serial1, serial2;
    Body *body1, *body2;  // live during a step only; body2 may be null
    int old = -1;         // place in the list of the step before, -1: none, kTakenOver: by the next one
    int first = 0;        // place of its manifolds
    union {
        std::uint32_t separating_axis = 0;  // of solids: a direction that has separated them, packed
                                            // (contacts/ahead/pair_separation.h)
        int leaves;                         // of a solid and a mesh: place of what they keep of it
    };
    std::uint8_t count = 0;  // of them
    std::uint8_t max_manifolds = 1;
    bool wanted : 1 = true;    // by the filter
    bool asked : 1 = false;    // functions of the program report its contacts
    bool touched : 1 = false;  // in the step before
    bool on_mesh : 1 = false;  // a solid and a mesh
    bool tied : 1 = false;     // by a joint that is no contact
    bool shown : 1 = false;    // to the program's function of manifolds, in this step
};
static_assert(sizeof(ContactPair) <= kCacheLine);

}  // namespace epode
