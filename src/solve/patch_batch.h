// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Patches of the world's own contacts (rows/patch.h) as the kernels read them: eight patches side by side,
// none of which shares a dynamic body with another. 76 bytes per point and patch, 142 per patch. A point that
// a shorter patch lacks is far open and does nothing.
#pragma once

#include "rows/patch.h"
#include "simd/float_lanes.h"

namespace epode {

// Of one body, a cache line: what sweeps change, and how far it has moved since the step began.
struct alignas(64) FloatMotion {
    float speed[8];  // v and w as in Velocity, m/s and rad/s
    float way[8];    // moved and turned, m and rad
};
static_assert(sizeof(FloatMotion) == 64);

struct PatchLanes {
    FloatLaneVec3 r1, r2;
    FloatLanes gap;       // when the step began
    FloatLanes approach;  // n . u then
    FloatLanes open;      // the gap when the correcting sweep came by; what is open is left alone in relaxing
    FloatLanes p[3];      // along n, t1, t2: of one small step
    FloatLanes sum[3];    // over the small steps
    FloatLanes gain;      // of the normal row: 1 / (J M^-1 J^T)
    FloatLanes grip;      // of both friction rows: 1 / (an upper bound of their 2 x 2 block's eigenvalues)
    FloatLanes k_n1, k_n2;  // grip times their coupling with the normal row
};

// What soft and rolling patches have besides; zero in the lanes of others.
struct PatchExtra {
    FloatLanes soft, rate;          // of the spring: C p; velocity per depth
    FloatLanes keep[kPatchPoints];  // of a point: share of the gain and of p
    FloatLanes rolling;             // m
    FloatLanes roll_gain;           // 1 / (an upper bound of the eigenvalues of I1^-1 + I2^-1)
    FloatLaneVec3 roll, roll_sum;   // of one small step; over all
};

struct PatchBatch {
    int first, count;                            // of the points
    PatchExtra* extra;                           // null: no lane is soft or rolls
    int body1[kFloatLanes], body2[kFloatLanes];  // into the motions; ~i: reads i, which does not change
    FloatLanes inv_mass1, inv_mass2;
    FloatLaneSym3 inv_inertia1, inv_inertia2;
    FloatLaneVec3 n, t1, t2;
    FloatLaneVec3 drift;  // wanted u: as a vector of the world, once prepared along t1 (x) and t2 (y)
    FloatLanes mu;
    FloatLanes bounce, bounce_speed;
    FloatLanes soft, rate;  // of a contact that is too deep: share of the gain and of p; velocity per depth
    FloatLanes share;       // of the gain, of one that is open: 1 / points
    FloatLanes behind;      // of the way that body 1 goes relative to body 2, what the points do not go along
};

}  // namespace epode
