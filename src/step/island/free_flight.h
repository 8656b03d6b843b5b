// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Free bodies in steppers with substeps. Substeps lose properties of free motion, which are restored here:
//
//  - The program's forces often depend on the pose (springs, the gravity of planets). Held constant over n
//    substeps they move a body by (n + 1)/(2n) h^2 a instead of h^2 a, and the scheme is not symplectic any
//    more: orbits gain energy. Here they act as one kick at the beginning, as in semi-implicit Euler; for bodies that
//    something holds step/island/prompt_forces does. The world's gravity is uniform and is still divided over the substeps.
//  - A free body turns exactly over the whole step (dynamics/exact_spin.h), but for behaviour 0.16 without dWorldSetExactRotation.
//  - Substeps of islands with manifolds only take the gyroscopic torque of the beginning for the whole step.
//
// The substeps have moved a free body too, in the lanes of its group, and that motion
// is replaced; only bodies that a program pushes or that turn exactly pay for it.
#pragma once

#include "dynamics/world.h"

namespace epode {

// A body in a fluid gets its weight as one kick with the fluid's force, and a vehicle with those of its suspensions, which balance it: divided
// over the substeps, the one would let it fall while the others lift it at once.
inline Vec3 weight_field(const World& world, const Body& body)
{
    return body.gravity && !body.fluid.wet && !body.vehicle ? world.gravity : Vec3{};
}

// The program's force: the accumulator without the weight. Exactly zero if there is none.
inline Vec3 force_on(const World& world, const Body& body)
{
    return load(body.facc) - body.mass.mass * weight_field(world, body);
}

inline bool tumbles(const Body& body)
{
    return body.gyroscopic && !isotropic(body.inertia) && !(body.angular_velocity() == Vec3{});
}

// Must this unconstrained body's motion by substeps be replaced?
inline bool flies_by_itself(const World& world, const Body& body, bool manages_contacts)
{
    if (body.kinematic()) return false;
    return world.exact_rotation || ((manages_contacts || !world.acts_as_ode()) && tumbles(body)) ||
           !(load(body.tacc) == Vec3{}) || !(force_on(world, body) == Vec3{});
}

// Integrates pose and velocities from the beginning of the step to its end.
void fly(const World& world, Body& body, Real h, int substeps);

}  // namespace epode
