// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A step: islands (active_islands), a stepper for each (steppers), groups and parcels of them (schedule), every island from forces
// to poses on any worker (step_islands), continuous collision, and what is left to do when all have moved. Callbacks come last,
// body by body in island order on the caller's thread, so that a program sees the same order on any number of workers.
#include "step/step.h"

#include <algorithm>
#include <atomic>

#include "base/float_environment.h"
#include "base/random.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "joints/breaking.h"
#include "step/active_islands.h"
#include "step/common/link.h"
#include "step/fluids.h"
#include "step/island/report.h"
#include "step/schedule.h"
#include "step/step_islands.h"
#include "step/steppers/stepper.h"
#include "step/stepping.h"
#include "step/validate.h"

namespace epode {
namespace {

class WorldStep {
  public:
    WorldStep(const StepContext& context, StepState& state, StepMemory& memory, const Workers& workers)
        : context_(context),
          world_(context.world),
          state_(state),
          memory_(memory),
          workers_(workers),
          islands_(world_, state, context.h, workers.of_islands),
          continuous_(world_, context.undo, state.continuous, state.cut_short, memory.arena(0), context.h),
          finish_(continuous_, state.world_contacts.live_space(), state.runaways, workers.of_islands)
    {}

    // The step itself. False: out of memory, and take_back() must follow.
    bool make()
    {
        const bool scheduled = begin() && schedule();
        state_.underway.ran = scheduled;
        return scheduled && run() && stop_at_impacts();
    }

    // What is left to do when all bodies have moved.
    void accept()
    {
        state_.contacts.end(context_.h);
        islands_.accept_contacts();
        break_joints(world_, context_.h);
        if (context_.stepper.remember)
            for (std::size_t i = 0; i < context_.methods.size(); ++i)
                context_.stepper.remember(islands_.all()[i], context_.methods[i]);
        if (state_.events.list().wants_any()) islands_.list_events();
        islands_.deactivate_sleeping();
        finish_.rest(state_.underway.unfinished);
        clear_sleeping_forces(world_);
        advance_fluids(world_, context_.h);
        if (state_.events.list().wants_any())
            state_.events.end_step(world_, state_.world_contacts.live_space(), state_.cut_short);
        if (world_.report_wanted) world_.report = sum_of(state_.reports.span());
    }

    // Restores the state before the step, with the count of steps: it seeds random orders.
    void take_back()
    {
        context_.contacts.take_back();
        context_.undo.restore();
        finish_.take_back();
        if (continuous_.marked())
            for (Body* body : context_.undo.bodies()) body_stepped(*body);
        --world_.step_count;
        state_.runaways.take_back(), state_.cut_short.take_back();
        forget_loads(world_);
    }

  private:
    bool begin()
    {
        if (!islands_.find(context_.undo, memory_.arena(0)) || !choose()) return false;
        const int count = int(islands_.all().size());
        state_.reports.clear(), state_.ledgers.clear();
        return (!world_.report_wanted || state_.reports.resize(count)) &&
               (!state_.ledger_wanted || state_.ledgers.resize(count)) && measure_approach();
    }

    // Where the stepper has others for some of the islands.
    bool choose()
    {
        if (!context_.stepper.choose) return true;
        Arena& arena = memory_.arena(0);
        context_.methods = arena.take<IslandMethod>(int(islands_.all().size()));
        return !arena.failed() && context_.stepper.choose(context_, islands_.all(), arena, context_.methods);
    }

    bool measure_approach()
    {
        return !islands_.updates_contacts() || !state_.events.list().wants_contacts() ||
               state_.world_contacts.measure_approach(workers_.of_islands);
    }

    bool schedule()
    {
        Arena& arena = memory_.arena(0);
        return schedule_.make(context_, islands_.all(), arena) &&
               memory_.provide(workers_.of_islands.workers()) &&
               finish_.begin(context_.undo.bodies(), !any_continuous(), arena) &&
               context_.contacts.begin(schedule_.joints(), int(schedule_.groups().size())) &&
               apply_fluids(world_, context_.h, workers_.of_islands, context_.undo, arena);
    }

    bool run()
    {
        std::atomic<bool> out_of_memory{false};
        schedule_.run(workers_, [&](int i, const Tasks& tasks, int worker) {
            if (out_of_memory.load(std::memory_order_relaxed)) return;
            if (!step_group(i, tasks, memory_.arena(worker))) out_of_memory.store(true);
        });
        return !out_of_memory.load();
    }

    bool step_group(int i, const Tasks& tasks, Arena& arena)
    {
        const IslandGroup& group = schedule_.groups()[std::size_t(i)];
        const auto part_of = [&](auto all) {
            return all.empty() ? all : all.subspan(std::size_t(group.first), std::size_t(group.count));
        };
        const StepContext context = with_stepper(context_, *group.stepper, group.iterations);
        const IslandPlace place{i, group.draw, group.first_contact, group.first};
        const auto islands = part_of(islands_.all());
        const IslandRecords records{part_of(state_.reports.span()), part_of(state_.ledgers.span())};
        if (!step_islands(context, islands, place, tasks, arena, records)) return false;
        finish_.at_once(joined(islands).bodies, tasks);
        return true;
    }

    bool stop_at_impacts()
    {
        if (finish_.is_early()) return true;
        if (!continuous_.stop_at_impacts()) return false;
        const std::span<const Island> islands = islands_.all();
        for (int i = 0; i < state_.reports.size(); ++i)
            report_stopped(world_, islands[std::size_t(i)], continuous_, state_.reports[i]);
        for (int i = 0; i < state_.ledgers.size(); ++i) {
            const Island& island = islands[std::size_t(i)];
            const auto stopped = [&](const Body* body) { return continuous_.stopped(*body); };
            if (std::any_of(island.bodies.begin(), island.bodies.end(), stopped))
                add_stop(world_, island, state_.ledgers[i]);
        }
        return true;
    }

    StepContext context_;
    World& world_;
    StepState& state_;
    StepMemory& memory_;
    const Workers& workers_;
    ActiveIslands islands_;
    Schedule schedule_;
    Continuous continuous_;
    Finish finish_;
};

// The step, when the working memory has been reserved for it.
bool step_in(World& world, StepState& state, StepMemory& memory, const Stepper& stepper, Real h,
             int iterations)
{
    Workers workers;
    if (!workers.start(world, stepper.draws)) return false;
    StepUnderway& underway = state.underway;
    ++world.step_count, underway.counted = true;
    const std::uint32_t random = ProcessRandom::state();
    const StepContext context{.world = world,
                              .stepper = stepper,
                              .h = h,
                              .iterations = iterations,
                              .contacts = state.contacts,
                              .symbolic_cache = state.symbolic_cache,
                              .undo = *underway.undo,
                              .runaways = state.runaways,
                              .manages_contacts = state.world_contacts.live_space() != nullptr,
                              .methods = {}};
    WorldStep step(context, state, memory, workers);
    const bool made = underway.made = step.make();
    made ? step.accept() : step.take_back();
    if (!made && stepper.draws) ProcessRandom::set_state(random);
    workers.stop();
    world.report_made = made && world.report_wanted;
    state.ledger_made = made && state.ledger_wanted;
    return made;
}

void notify_begin(const StepState& state, World& world, Real h)
{
    for (StepObserver* o : state.observers())
        if (o && o->begin) o->begin(*o, world, h);
}

void notify_end(const StepState& state, World& world, Real h, bool made)
{
    for (StepObserver* o : state.observers())
        if (o && o->end) o->end(*o, world, h, made);
}

}  // namespace

bool step_world(World& world, const Stepper& stepper, Real h, int iterations, StepMemory* lent)
{
    const FloatEnvironment floats;
    const Stepping mark(world);
    // A program can write through the pointers that getters return. What it broke is not the step's fault.
    [[maybe_unused]] const bool was_whole = kAsserts && !fault_of(world);
    StepState* state = step_state(world);
    StepMemory* memory = lent ? lent : working_memory(world);
    if (!state || !memory || !memory->begin()) return false;
    const Stepper& own = world.acts_as_ode() && stepper.as_ode ? *stepper.as_ode : stepper;
    state->underway.begin(world, *memory, h);
    notify_begin(*state, world, h);
    const bool made = step_in(world, *state, *memory, own, h, iterations);
    state->underway.memory = nullptr;
    memory->end();
    notify_end(*state, world, h, made);
    EPODE_ASSERT_NO_FAULT(was_whole ? fault_of(world) : nullptr);
    return made;
}

}  // namespace epode
