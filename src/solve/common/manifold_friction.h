// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which joint manifolds can have one friction for all their points (contact_friction.inc), and that friction
// as three rows, for code that judges it.
#pragma once

#include "rows/joint_manifold.h"
#include "rows/row_system.h"

namespace epode {

// Rows along t1 and t2 at the centre of pressure, and about n times the mean radius, bounded by |p| <= limit.
struct ManifoldFriction {
    Jacobian rows[3];
    Real p[3], c[3];
    Real C, limit;
    int body1, body2;
};

// Coulomb's disc needs a limit mu times the normal impulse, one mu and one softness for both directions, and
// directions that are a frame with the normal.
inline bool allows_manifold_friction(const JointManifold& m)
{
    constexpr Real kSkew2 = Real(1e-6);
    return m.mu[0] == m.mu[1] && m.mu[0] < kInf && m.fixed[0] == 0 && m.fixed[1] == 0 && m.C[0] == m.C[1] &&
           length2(cross(m.t1, m.t2) - m.n) < kSkew2 && std::fabs(length2(m.t1) - 1) < kSkew2;
}

// Below this share of a manifold's size a mean radius may be rounding.
inline constexpr Real kMinRadius = Real(1e-3);

}  // namespace epode
