// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Chooses the solver of an island in a hybrid step. A requested stepper comes first: the most exact one that
// its bodies request, else the world's. Otherwise a model of cost decides from the island's structure and
// from what its bodies remember of their last steps, never from a clock, so that the same calls give the same
// bits everywhere. Times are in microseconds of one core, fitted to the figures in docs/solvers.md:
//
//   one factorisation of the exact solver   0.15 N + 0.06 L^1.5 + 0.1 R
//   exact                                   (factorisations of the last step, or a guess) times that
//
// with N bodies that can move, R rows, and L loops of the graph of bodies, which cause fill-in.
//
// Exact is wrong for a load that hangs on joints if the step is too long: where a body of mass m and radius
// of gyration r carries the whole load M g, and M g h^2 > m r, the directions of the forces change within the
// step, and an exact solution for its beginning lets the load thrash about (docs/solvers.md, tension).
// Substeps follow the change. An island that was exact stays exact up to twice the limit, so that islands
// near it do not change at every step.
#pragma once

#include "dynamics/island.h"
#include "ode/steppers.h"
#include "solve/solver.h"

namespace epode {

inline bool is_stepper(int number) { return number >= dStepperHybrid && number <= dStepperQuick; }

// The solver of a value of dStepper; null: hybrid.
const Solver* solver_named(int stepper);

// The number of iterations, or of substeps, of an island with this solver in a hybrid step of the world.
int hybrid_iterations(const World& world, const Solver& solver);

const Solver& choose_solver(const World& world, const Island& island, Real h);

// The solver, but exact joints in place of the sweeps of substeps that a step of the last kStrainedSteps has
// strained (step/island/strain.h), and in islands that settle (dynamics/settle.h).
const Solver& relieved(const Solver& solver, const Island& island);

// What an island's step tells the next ones.
struct StepMemo {
    int factorisations;  // of the exact solver
    bool strained;
    bool hybrid;  // the step was a hybrid one
};

// After a step: stores the choice and its memo in the island's bodies.
void remember_choice(const Island& island, const Solver& solver, const StepMemo& memo);

}  // namespace epode
