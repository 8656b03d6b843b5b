// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which solver an island gets in a hybrid step. What somebody has asked for comes first: of its bodies'
// wishes the most exact, else the world's. Otherwise a model of cost decides from the island's structure and
// from what its bodies remember of their last steps, never from a clock, so that the same calls give the same
// bits anywhere. Times are in microseconds of one core, fitted to the figures in docs/solvers.md:
//
//   one factorisation of the exact solver   0.15 N + 0.06 L^1.5 + 0.1 R
//   exact                                   (factorisations of the last step, or a guess) times that
//
// Exact is not right for what hangs on joints that the step is too long for: where a body of mass m and
// radius of gyration r carries the load of all, M g, and M g h^2 > m r, the directions of the forces change
// within the step, and solving for them exactly at its beginning lets the load thrash about (docs/solvers.md,
// tension). Small steps follow it. N are bodies that move, R rows and L loops of the graph of bodies, which
// is what fills a factor in. Whoever was exact stays so up to twice the limit, so that islands near it do not
// change at every step.
#pragma once

#include "dynamics/island.h"
#include "ode/steppers.h"
#include "solve/solver.h"

namespace epode {

inline bool is_stepper(int number) { return number >= dStepperHybrid && number <= dStepperQuick; }

// One of dStepper to its solver; null: the hybrid one.
const Solver* solver_named(int stepper);

// How many iterations, or small steps, an island with this solver makes in a hybrid step of the world.
int hybrid_iterations(const World& world, const Solver& solver);

const Solver& choose_solver(const World& world, const Island& island, Real h);

// After a step: what the island's bodies remember. `factorisations` of the exact solver.
void remember_choice(const Island& island, const Solver& solver, int factorisations);

}  // namespace epode
