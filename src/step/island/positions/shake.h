// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints that are closed where the step ends, by the impulses of the step (SHAKE, Ryckaert, Ciccotti & Berendsen, J. Comp.
// Phys. 23, 1977).
//
// An exact step solves J v = c at the poses x of its beginning and moves the bodies by h v: a joint opens by about (w h)^2/2 of
// its lever, and the next step, which solves at the new poses, takes that share of the energy. Here the impulses p of the joints
// become those with which nothing opens,
//
//   v = v* + M^-1 J(x)^T p,    e(x moved by v for h) = e(x) - h J v   for what holds a joint
//
// The map from x, v to the next ones is symplectic then, as semi-implicit Euler is without joints, and energy does not drift.
// Where the step ends, the velocities are those that the joints allow there (RATTLE, Andersen, J. Comp. Phys. 52, 1983): the next step
// would take what they have too much, and until then it is kinetic energy that is none, and its impulse is missing in the feedback.
// A spin under exact rotation is that of the middle of the step (dynamics/exact_spin.cpp); joints see it with half of what it lacks.
// Errors that are there when the step begins are left to ERP and to the projection: closed at once, they would throw the bodies.
// Newton's method with the matrix of the beginning, e' being what an error has more than it should:
//
//   J dv + C dp = e'/h for what holds a joint, 0 for all else that acts;   dv = M^-1 J^T dp;   v += dv, p += dp
//
// Rows on a bound keep their impulses: stops that do not act, motors at their limits, friction that slides. Every step makes at
// least one iteration, whatever the error: a correction now and then would take energy that nothing gives back. Where an iteration
// does not halve the error, or joints open by more than kLongestTurn, the step is too long for the motion and the solution stays. So does it where
// bodies would be thrown: near a dead centre levers would have to fly to close. Closing makes (w h)^2/4 of the kinetic energy, a hundredth
// at kLongestTurn, before J(x') takes it again; ten times that is a throw.
#pragma once

#include "solve/exact/factor/symbolic_cache.h"
#include "step/island/problem/assemble.h"
#include "tasks/tasks.h"

namespace epode {

// Advances the poses of the island by h with the velocities that its bodies have.
void advance_poses(const World& world, const IslandWork& work, Real h);

// The same for an island that has been solved and written back, closing its joints; velocities and impulses change. True:
// they have. Out of memory: joints stay as they are.
bool advance_closing(const World& world, IslandWork& work, const Tasks& tasks, SymbolicCache& symbolic_cache,
                     Arena& arena);

}  // namespace epode
