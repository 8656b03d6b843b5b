// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Manifolds of the world's own contacts (rows/contact_manifold.h) as the kernels read them: sixteen manifolds side by
// side, or eight in the first half of the lanes, none of which shares a dynamic body with another. 76 bytes
// per point and lane, 142 per lane; with one friction per manifold 56 and 218. A point that a shorter manifold
// lacks is far open and does nothing.
#pragma once

#include "rows/contact_manifold.h"
#include "simd/float_lanes.h"

namespace epode {

// Of one body, a cache line: what sweeps change, and how far it has moved since the step began.
struct alignas(64) FloatMotion {
    float velocity[8];      // v and w as in Velocity, m/s and rad/s
    float displacement[8];  // moved and turned, m and rad
};
static_assert(sizeof(FloatMotion) == 64);

struct ManifoldLanes {
    BroadLaneVec3 r1, r2;
    BroadLanes separation;        // when the step began
    BroadLanes initial_velocity;  // n . u then
    BroadLanes
        last_separation;  // the separation when the correcting sweep came by; what is open is left alone in relaxing
    BroadLanes p[3];         // along n, t1, t2: of one substep
    BroadLanes sum[3];       // over the substeps
    BroadLanes normal_mass;  // of the normal row: 1 / (J M^-1 J^T)
    BroadLanes
        friction_mass;      // of both friction rows: 1 / (an upper bound of their 2 x 2 block's eigenvalues)
    BroadLanes k_n1, k_n2;  // friction_mass times their coupling with the normal row
};

// What soft and rolling manifolds have besides; zero in the lanes of others.
struct ManifoldExtra {
    BroadLanes compliance, bias_rate;        // of the spring: C p; velocity per depth
    BroadLanes mass_scale[kManifoldPoints];  // of a point: share of the gain and of p
    BroadLanes rolling_friction;             // m
    BroadLanes rolling_mass;                 // 1 / (an upper bound of the eigenvalues of I1^-1 + I2^-1)
    BroadLaneVec3 rolling, rolling_sum;      // of one substep; over all
};

// Points that no lane has: so far open that they never act. (Zero would be a contact at the body's centre,
// since the normal and the masses are those of the batch.)
inline constexpr float kFarSeparation = 1e20f;

// A point of a manifold that has one friction for all its points. Its arms matter only as a = r x n, since
// n . (w x r) = w . a.
struct NormalLanes {
    BroadLaneVec3 a1, a2;
    BroadLanes x, y;                                           // its place along t1 and t2, from the anchor
    BroadLanes separation, initial_velocity, last_separation;  // as in ManifoldLanes
    BroadLanes p, sum, normal_mass;                            // of the normal row
};

// That friction (manifold_friction.inc): a force along t1 and t2 at an anchor, which is the mean of the points,
// and a couple about n.
struct ManifoldFrictionLanes {
    BroadLaneVec3 r1, r2;  // of the anchor
    BroadLanes k_11, k_22, k_12, k_1n, k_2n,
        k_nn;                                // J M^-1 J^T of the tangents there and of the turn about n
    BroadLanes min_radius;                   // no couple is known from rounding below
    BroadLanes x, y, radius, friction_mass;  // of the centre of push; gain of the three rows there
    BroadLanes p[3], sum[3];                 // force, couple: of one substep; over all
    NormalLanes points[kManifoldPoints];
};

struct ManifoldBatch {
    int first, count;                            // of the points
    int lanes;                                   // that are in use: 8, or all
    ManifoldExtra* extra;                        // null: no lane is soft or rolls
    ManifoldFrictionLanes* friction;             // null: each point has its own; else the points are there
    int body1[kBroadLanes], body2[kBroadLanes];  // into the motions; ~i: reads i, which does not change
    BroadLanes inv_mass1, inv_mass2;
    BroadLaneSym3 inv_inertia1, inv_inertia2;
    BroadLaneVec3 n, t1, t2;
    BroadLaneVec3
        surface_velocity;  // wanted u: as a vector of the world, once prepared along t1 (x) and t2 (y)
    BroadLanes mu;
    BroadLanes restitution, restitution_threshold;
    BroadLanes mass_scale,
        bias_rate;      // of a contact that is too deep: share of the gain and of p; velocity per depth
    BroadLanes share;   // of the gain, of one that is open: 1 / points
    BroadLanes behind;  // of the way that body 1 goes relative to body 2, what the points do not go along
};

}  // namespace epode
