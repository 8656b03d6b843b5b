// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The program's forces in steps that are divided. They often depend on the pose: springs, controllers, the gravity of
// planets. Held constant over n substeps such a force moves a body by (n + 1)/(2n) h^2 a where semi-implicit Euler has h^2 a, and
// an oscillator of frequency w gains the share (n - 1)/(4n) (w h)^2 of its amplitude in every step. As one kick at the
// beginning it would load contacts and joints n times as much in the first substep and not at all in the others: what lies would hop.
// So the force is divided into what moves bodies and what constraints bear,
//
//   f = M a + r,   r = -J^T q,   M a = f + J^T q,   J a = 0 where a constraint holds, a kick h a, r over the substeps.
//
// What holds: rows of joints within their bounds, contacts that carried load in the last step, and their friction unless it slides; what
// touches without a load holds against approach only. What gives way, springs, motors at their limits and sliding friction, bears up to what it
// did in the last step. q is found by Gauss-Seidel from the impulses of the last step, in the share that
// fits best (a pile whose weight is the program's force is solved at once); what is left of J a after that is borne in
// the first substep, like a kick.
#pragma once

#include "step/island/free_flight.h"
#include "step/island/problem/assemble.h"

namespace epode {

// What remains of the program's force on a body, and of its torque, for every substep.
struct BorneForce {
    Vec3 force, torque;
};

inline Vec3 force_left(const World& world, const Body& body, const BorneForce& borne)
{
    return body.kinematic() ? load(body.facc) : body.mass.mass * weight_field(world, body) + borne.force;
}

// Gives `work`'s solver bodies the kick h a, and returns the forces that are left of all bodies; none if the program applies
// none, nothing is known of the last step, or memory is exhausted. `warm_share`: of the last step's impulses, that the rows have.
std::span<const BorneForce> kick_by_prompt_forces(const World& world, IslandWork& work, Real h,
                                                  Real warm_share, Arena& arena);

}  // namespace epode
