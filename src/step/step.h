// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One step of a world, the only place that sees all parts.
#pragma once

#include <array>
#include <optional>

#include "base/array.h"
#include "contacts/contact_world.h"
#include "dynamics/world.h"
#include "solve/exact/factor/symbolic_cache.h"
#include "step/common/contact_cache.h"
#include "step/common/continuous.h"
#include "step/common/cut_short.h"
#include "step/common/runaway.h"
#include "step/common/undo.h"
#include "step/finish.h"
#include "step/world_events.h"

namespace epode {

struct Stepper;

// Looks at steps from above, and changes nothing that they compute.
struct StepObserver {
    void (*begin)(StepObserver&, World&, Real h) = nullptr;           // null: is not told
    void (*end)(StepObserver&, World&, Real h, bool made) = nullptr;  // likewise; false: it has been undone
    void (*destroy)(StepObserver&) = nullptr;
};

// A step in progress. It is needed when a function of the program leaves the step.
struct StepUnderway {
    void begin(World& world, StepMemory& works_in, Real size)
    {
        undo.emplace(world);
        memory = &works_in, h = size;
        counted = ran = made = false;
        unfinished = {};
    }
    std::optional<StepUndo> undo;
    StepMemory* memory = nullptr;  // null: no step is in progress
    Real h = 0;
    bool counted = false, ran = false, made = false;
    Unfinished unfinished;
};

// What a world keeps from one step to the next.
struct StepState {
    StepState() = default;
    StepState(const StepState&) = delete;
    StepState& operator=(const StepState&) = delete;
    ~StepState()
    {
        for (StepObserver* observer : observers())
            if (observer) observer->destroy(*observer);
    }

    StepUnderway underway;
    ContactCache contacts;
    SymbolicCache symbolic_cache;
    ContinuousLists continuous;
    ContactWorld world_contacts;  // world-managed contacts
    Array<Body*> unsupported;     // bodies that the present step has woken
    WorldEvents events;
    Runaways runaways;
    CutShort cut_short;
    Array<dIslandStepReport> reports;  // of the last step's islands, when they were wanted
    Array<dEnergyLedger> ledgers;      // likewise
    bool ledger_wanted = false, ledger_made = false;
    StepObserver* watch = nullptr;    // diagnose/watch.h; null: the world is not diagnosed
    StepObserver* archive = nullptr;  // of states, state/world_archive.h; null: none yet
    std::array<StepObserver*, 2> observers() const { return {watch, archive}; }
};

// Is the world busy, or another world that shares its working memory?
inline bool in_step(const World& world) { return is_busy(world) || (world.memory && world.memory->in_use()); }
// Why the world must not be stepped now; null: it may.
const char* fault_of_step(World& world);

// The world's working memory, created if it has none; null when memory is exhausted.
StepMemory* working_memory(World& world);

// Frees what the world's next step can rebuild.
void free_working_memory(World& world);

// False: memory is exhausted, or another step uses the working memory; the world is then unchanged except for
// the feedback of joints and the report.
// `lent`: memory to work in instead of the world's own.
bool step_world(World& world, const Stepper& stepper, Real h, int iterations, StepMemory* lent = nullptr);

inline constexpr int kMaxSubsteps = 10000;

// The world's StepState, created if it has none; null when memory is exhausted.
StepState* step_state(World& world);

// To be called after steps, when nothing of them is left on the stack (common/runaway.h, common/cut_short.h).
void report_unusual(World& world);

// Of the last step; empty when no report was made.
std::span<const dIslandStepReport> island_reports(const World& world);

}  // namespace epode

// In namespace epode.
#define EPODE_MAY_STEP(world) \
    if (const char* const epode_fault = fault_of_step(world)) { EPODE_USER_SAY(false, epode_fault, 0); }
