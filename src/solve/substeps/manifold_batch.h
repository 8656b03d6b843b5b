// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contact manifolds of world-managed contacts (rows/contact_manifold.h) as the kernels read them: sixteen
// manifolds side by side, or eight in the first half of the lanes, none of which shares a dynamic body with
// another. 80 bytes per point and lane, 144 per lane; with manifold friction 68 and 236. If a lane's manifold
// has fewer points, the missing ones have a far separation and do nothing.
#pragma once

#include "rows/contact_manifold.h"
#include "simd/lanes.h"

namespace epode {

// One body, a cache line: what sweeps change, and how far it has moved since the step began.
struct alignas(64) FloatMotion {
    float velocity[8];      // v and w as in Velocity, m/s and rad/s
    float displacement[8];  // translation and rotation, m and rad
};
static_assert(sizeof(FloatMotion) == 64);

struct ManifoldLanes {
    BroadLaneVec3 r1, r2;
    BroadLanes separation;          // at the beginning of the step
    BroadLanes initial_velocity;    // n . u at that time, for restitution
    BroadLanes p[3];                // along n, t1, t2: impulses of one substep
    BroadLanes sum[3];              // of all substeps
    BroadLanes k[kManifoldPoints];  // of the normal rows: J M^-1 J^T of this point with those up to it
    BroadLanes normal_mass;         // effective mass of the normal row: 1 / (J M^-1 J^T)
    BroadLanes friction_mass;  // of both friction rows: 1 / (a bound of the eigenvalues of their 2 x 2 block)
};

// Additional numbers of manifolds with compliance, rolling friction, a friction axis or a bounded impulse; in the lanes of
// others zero, but for max_impulse.
struct ManifoldExtra {
    BroadLanes compliance, bias_rate;    // of the spring: C; velocity per penetration
    BroadLanes rolling_friction;         // m
    BroadLanes rolling_mass;             // 1 / (a bound of the eigenvalues of I1^-1 + I2^-1)
    BroadLaneVec3 rolling, rolling_sum;  // of one substep; over all
    BroadLaneVec3 friction_axis;         // t1 before it is scaled; zero: none
    BroadLanes s1, s2;                   // lengths of its tangents (rows/contact_manifold.h)
    BroadLanes max_impulse;              // of a point's normal in a substep
};

// The separation of points that a lane lacks: so far that they never act. (Zeros would be a contact at the
// body's centre, because the normal and the masses are those of the batch.)
inline constexpr float kFarSeparation = 1e20f;

// A point of a manifold with manifold friction. Its arms matter only as a = r x n, since n . (w x r) = w . a.
struct NormalLanes {
    BroadLaneVec3 a1, a2;
    BroadLanes x, y;                                     // position along t1, t2, from the anchor
    BroadLanes separation, initial_velocity;             // as in ManifoldLanes
    BroadLanes p, sum, k[kManifoldPoints], normal_mass;  // of the normal row
};

// Manifold friction (manifold_friction.inc): a force along t1 and t2 at an anchor, which is the mean of the
// points, and a torque about n.
struct ManifoldFrictionLanes {
    BroadLaneVec3 r1, r2;  // of the anchor
    BroadLanes k_11, k_22, k_12, k_1n, k_2n,
        k_nn;                                // J M^-1 J^T of the tangents there and of the rotation about n
    BroadLanes min_radius;                   // below this radius a torque is only rounding
    BroadLanes x, y, radius, friction_mass;  // of the centre of pressure; effective mass of the three rows
    BroadLanes p[3], sum[3];                 // force, torque: of one substep; of all substeps
    NormalLanes points[kManifoldPoints];
};

struct ManifoldBatch {
    int first, count;                            // of the points
    int lanes;                                   // lanes in use: 8, or all
    ManifoldExtra* extra;                        // null: no lane has such
    ManifoldFrictionLanes* friction;             // null: each point has its own; else the points are there
    int body1[kBroadLanes], body2[kBroadLanes];  // into the motions; ~i: reads i, which does not change
    BroadLanes inv_mass1, inv_mass2;
    BroadLaneSym3 inv_inertia1, inv_inertia2;
    BroadLaneVec3 n, t1, t2;
    BroadLaneVec3
        surface_velocity;  // target u: a vector of the world; once prepared, along t1 (x) and t2 (y)
    BroadLanes mu;
    BroadLanes restitution, restitution_threshold;
    BroadLanes softness, mass_scale,
        bias_rate;      // of a penetrating point: of J M^-1 J^T; 1 / (1 + it); velocity per depth
    BroadLanes share;   // 1 / points
    BroadLanes behind;  // share of the relative translation by which the point lags behind body 1
};

}  // namespace epode
