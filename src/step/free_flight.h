// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies that nothing holds, in steppers with substeps. Two things that only free motion has are lost there:
//
//  - Forces of the program often depend on the pose (springs, the gravity of planets). Held over n substeps
//    they move a body by (n + 1)/(2n) h^2 a instead of h^2 a, and the scheme is no longer symplectic: orbits
//    gain energy. Here they act as one kick at the beginning, as in semi-implicit Euler; gravity, which is
//    the same everywhere, is divided as before.
//  - dWorldSetExactRotation turns a free body exactly over the whole step (dynamics/exact_spin.h).
//
// Rejected: the kick for bodies under constraints, whose contacts would carry n times the load in the first
// substep and none after it.
#pragma once

#include "dynamics/world.h"

namespace epode {

inline Vec3 weight_field(const World& world, const Body& body)
{
    return body.gravity ? world.gravity : Vec3{};
}

// Of the program: what the accumulator holds besides weight. Exactly zero if there is nothing.
inline Vec3 force_on(const World& world, const Body& body)
{
    return load(body.facc) - body.mass.mass * weight_field(world, body);
}

// Whether the substeps' motion of this unconstrained body has to be replaced.
inline bool flies_by_itself(const World& world, const Body& body)
{
    if (body.kinematic()) return false;
    return world.exact_rotation || !(load(body.tacc) == Vec3{}) || !(force_on(world, body) == Vec3{});
}

// Moves the body, pose and velocities, from the beginning of the step to its end.
void fly(const World& world, Body& body, Real h, int substeps);

}  // namespace epode
