// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contact joints of one pair of bodies as a manifold: numbers instead of rows. What the points share is
// stored once: the directions, the target of friction and its bounds. Per point, with u = v1 + w1 x r1 - v2 -
// w2 x r2 and impulses p (over the step, as in rows/row_system.h)
//
//   w_0 = n.u + C p_0 - c,    w_k = t_k.u + C_k p_k - c_k,  |p_k| <= mu_k p_0 + fixed_k,   k = 1, 2
//
// Rows carry Jacobians and forms that contacts do not need; writing and reading them took more time in a step
// of a thousand boxes than its sweeps.
#pragma once

#include <span>

#include "math/vec.h"
#include "rows/contact_manifold.h"

namespace epode {

struct JointManifold {
    Vec3 n, t1, t2;    // n points to body 1; tangents are zero where there is no friction
    Vec3 offset;       // r2 = r1 + offset: x1 - x2; without a second body zero
    Real c[2], C[2];   // of the tangents
    Real mu[2];        // coefficients of friction
    Real fixed[2];     // constant bound of the impulse
    int body1, body2;  // below zero: the world, see RowBlock
    int first, count;  // of the points
    bool cone;         // friction is bounded by the ellipse of its limits, not by their box
    bool slips;        // C of the tangents is the program's
};

struct JointManifoldPoint {
    Vec3 r1;     // from the centre of body 1, world frame
    Real c, C;   // of the normal: target velocity, compliance of the impulse
    Real error;  // penetration beyond the layer, for reports
    Real p[3];   // impulses along n, t1, t2: warm start in, answer out
};

// Where manifolds are written: capacity for as many of each as there are points.
struct JointManifoldList {
    std::span<JointManifold> manifolds;
    std::span<JointManifoldPoint> points;
};

}  // namespace epode
