// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A stepper takes an island from the poses where a step begins to those where it ends: one straight script over the
// toolbox in step/island and the velocity problems in solve. Each is one file here and one line in steppers.inc
// (scripts/new-stepper writes both).
#pragma once

#include <span>

#include "step/common/island_method.h"
#include "step/island/island_run.h"

namespace epode {

// Which consecutive small islands may be stepped together, as parts of one system (rows/row_system.h)?
enum class Sharing {
    kFree,   // those with nothing to solve
    kAll,    // all
    kAlike,  // those without joints; and those with joints that take as many substeps (island/strain.h)
    kWithoutJoints,  // those without joints
};

struct Stepper {
    const char* name = "";
    // Steps the islands of a run. Null: choose() gives every island another stepper.
    Outcome (*step)(IslandRun& run) = nullptr;

    // For the schedule (step/schedule.h).
    Sharing (*sharing)(bool manages_contacts) = nullptr;  // null: kFree
    int max_weight = 1024;                                // of islands that are stepped together
    bool (*is_large)(const Island& island) = nullptr;     // is there work for all workers? Null: never
    bool draws = false;  // from ProcessRandom: islands are stepped in order, on one thread

    // Is its number of iterations one of substeps, for which the program has to ask?
    bool has_substeps = false;
    // May its solution diverge, so that it is worth a second one?
    bool iterates = false;
    // What takes its place in worlds that act as ODE 0.16. Null: nothing.
    const Stepper* as_ode = nullptr;
    // What steps islands whose joints it does not hold together (island/strain.h). Null: nothing.
    const Stepper* for_strained = nullptr;
    // How each island is stepped, if not by this stepper. False: out of memory.
    bool (*choose)(const StepContext& context, std::span<const Island> islands, Arena& arena,
                   std::span<IslandMethod> methods) = nullptr;
    // After the step, with choose(): stores what came of an island's method in its bodies and joints.
    void (*remember)(const Island& island, const IslandMethod& method) = nullptr;
};

#define STEPPER(name, number) extern const Stepper k##name;
#include "step/steppers/steppers.inc"
#undef STEPPER

// Of a value of dStepper; null: there is none.
const Stepper* stepper_numbered(int number);
inline bool is_stepper(int number) { return stepper_numbered(number) != nullptr; }

// The number of iterations, or of substeps, of an island with this stepper in a hybrid step of the world.
int hybrid_iterations(const World& world, const Stepper& stepper);

}  // namespace epode
