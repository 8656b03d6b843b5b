// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How islands are stepped in a hybrid step. A requested stepper comes first: the most exact one that the bodies
// of an island request, else the world's. Otherwise a model of cost decides from the island's structure and
// from what its bodies remember of their last steps, never from a clock, so that the same calls give the same
// bits everywhere. Times are in microseconds of one core, fitted to the figures in docs/solvers.md:
//
//   one factorisation of the exact solver   0.15 N + 0.06 L^1.5 + 0.1 R
//   exact                                   the counted work of the last step, or a guess: 2 or 8 times that
//   substeps                                n/4 (0.3 N + 0.3 points of contact + 0.9 joints), without collision
//   what exact joints add to them           n/4 (1.7 joints)
//
// with N bodies that can move, R rows, and L loops of the graph of bodies, which cause fill-in. What is wanted
// here must fit the budget of the step, too (hybrid_budget.h).
//
// Exact is wrong for a load that hangs on joints if the step is too long: where a body of mass m and radius
// of gyration r carries the whole load M g, and M g h^2 > m r, the directions of the forces change within the
// step, and an exact solution for its beginning lets the load thrash about (docs/solvers.md, tension).
// Substeps follow the change. An island that was exact stays exact up to twice the limit, so that islands
// near it do not change at every step; one whose solution was given up takes substeps for 30 steps.
//
// Joints that have never been in a step remember no forces (step/island/problem/joint_memory.h). Substeps would find them by
// ringing, with up to twice what the joints will carry; so an island begins with an exact step if it can.
#pragma once

#include "step/steppers/stepper.h"

namespace epode {

struct HybridChoice {
    const Stepper* stepper = nullptr;  // if it is not stepped exactly
    bool wants_exact = false;
    bool was_exact = false, begins = false;
    bool sweeps_do = false;    // substeps would be good enough
    double max_work = 0;       // microseconds that an exact solution may take
    bool in_tree = false;      // in joint coordinates or not at all
    double substeps_work = 0;  // the same of the island's substeps
    double network_work = 0;   // what exact joints add to it
};
HybridChoice choose(const World& world, const Island& island, Real h);

// The stepper, but what it has for strained islands if a step of the last kStrainedSteps has strained this one, or it
// settles (dynamics/sleep/settle.h).
const Stepper& stepper_for_strain(const Stepper& stepper, const Island& island);

// Whether the step has strained the island, for stepper_for_strain().
void remember_strain(const Island& island, const IslandMethod& method);

}  // namespace epode
