// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pipeline of a step: contacts of the world, islands (some fall asleep), every island from forces to
// poses, continuous collision, callbacks. Islands are independent, so they are the units of parallel work:
// large ones first, one after another with all workers on each if the solver can use them; then the others
// concurrently, in parcels of about equal weight. Callbacks come last, body by body in island order on the
// caller's thread, so that a program sees the same order on any number of workers.
#include "step/step.h"

#include <algorithm>
#include <atomic>
#include <new>

#include "base/float_environment.h"
#include "base/random.h"
#include "dynamics/active.h"
#include "dynamics/island.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "joints/breaking.h"
#include "step/common/link.h"
#include "step/common/undo.h"
#include "step/finish.h"
#include "step/hybrid.h"
#include "step/hybrid_budget.h"
#include "step/island/energy_ledger.h"
#include "step/island/island_step.h"
#include "step/island/report.h"
#include "step/island/strain.h"
#include "step/stepping.h"
#include "step/validate.h"
#include "tasks/tasks.h"

namespace epode {
namespace {

constexpr int kLarge = 256;           // joints of an island that all workers solve together
constexpr int kLargeManifolds = 256;  // the same in manifolds
// Limits of weight() for islands that are solved together. More of them leave fewer SIMD lanes empty; sweeps
// over manifolds read more memory for each and read it more often, so that their limit is lower.
constexpr int kGroup = 1024, kGroupOfManifolds = 512;
constexpr int kParcel = 128;  // least weight of a parcel but the last

// The threads of a step: the library's own, or those of the threading implementation that the world has.
class Workers {
  public:
    Tasks of_islands, of_an_island;

    // False: the threading implementation refused; the world is unchanged.
    bool start(World& world, const Solver* solver)
    {
        if (solver && solver->draws) return true;  // on the caller's thread
        if (!world.threading) {
            of_islands = of_an_island = Tasks(number_for(world));
            return true;
        }
        const bool ready =
            posting_.open(world.threading_functions, world.threading, world.islands_max_threads);
        of_islands = Tasks(posting_, true);
        of_an_island = posting_.width() > 1 ? Tasks(posting_, false) : Tasks(1);
        return ready;
    }

    void stop() { posting_.close(); }

  private:
    // The number that the world requests, at most dWorldSetStepIslandsProcessingMaxThreadCount's.
    static int number_for(const World& world)
    {
        const int wanted = world.step_threads > 0 ? world.step_threads : processor_count();
        const unsigned max_threads = world.islands_max_threads;
        return max_threads == 0 ? wanted : int(std::min(unsigned(wanted), max_threads));
    }

    Posting posting_;
};

int weight(const Island& island)
{
    return int(island.joints.size() + island.bodies.size() + island.manifolds.size());
}

class WorldStep {
  public:
    // `hybrid`: each island has the solver that suits it instead of the context's.
    WorldStep(const StepContext& context, bool hybrid, StepState& state, StepMemory& memory,
              const Workers& workers)
        : context_(context),
          hybrid_(hybrid),
          state_(state),
          memory_(memory),
          workers_(workers),
          undo_(context.undo),
          continuous_(context.world, undo_, state.continuous, state.cut_short, memory_.arena(0), context.h),
          finish_(continuous_, state.world_contacts.live_space(), state.runaways, workers.of_islands)
    {}

    std::span<const Island> islands() const { return islands_; }

    // False: out of memory.
    bool prepare()
    {
        World& world = context_.world;
        Arena& arena = memory_.arena(0);
        updates_contacts_ = context_.manages_contacts && !is_settled();
        if (!find_unsupported()) return false;
        const ActiveBodies active{world.bodies.active_count(), world.bodies.count()};
        if (updates_contacts_ &&
            !state_.world_contacts.leaves_at_rest(*state_.world_contacts.live_space(), active))
            activate_all(world);
        if (!undo_.save_idleness(arena) || !undo_.wake(state_.unsupported.span(), arena) ||
            !find_contacts() || !find_islands(arena) || !undo_.save_islands(islands_, arena))
            return false;
        if (chooses() && !choose_methods(arena)) return false;
        if (updates_contacts_ && state_.events.list().wants_contacts() &&
            !state_.world_contacts.measure_approach(workers_.of_islands))
            return false;
        groups_ = arena.take<Group>(int(islands_.size()));
        parcels_ = arena.take<int>(int(islands_.size()) + 1);
        if (arena.failed() || !prepare_reports() || !memory_.provide(workers_.of_islands.workers()) ||
            !finish_.begin(undo_.bodies(), !any_continuous(), arena))
            return false;
        return context_.contacts.begin(make_groups(), int(groups_.size()));
    }

    // False: out of memory.
    bool run()
    {
        const Tasks alone(1);
        for (std::size_t i = 0; i < groups_.size(); ++i)
            if (is_large(groups_[i])) step_one(int(i), workers_.of_an_island, 0);
        workers_.of_islands.for_each(cut_parcels(), [&](int p, int worker) {
            const auto parcel = std::size_t(p);
            for (int i = parcels_[parcel]; i < parcels_[parcel + 1]; ++i)
                if (!is_large(groups_[std::size_t(i)])) step_one(i, alone, worker);
        });
        return !out_of_memory_.load();
    }

    // Continuous collision. False: out of memory.
    bool stop_at_impacts()
    {
        if (finish_.is_early()) return true;
        if (!continuous_.stop_at_impacts()) return false;
        for (int i = 0; i < state_.reports.size(); ++i)
            report_stopped(context_.world, islands_[std::size_t(i)], continuous_, state_.reports[i]);
        for (int i = 0; i < state_.ledgers.size(); ++i) {
            const Island& island = islands_[std::size_t(i)];
            const auto stopped = [&](const Body* body) { return continuous_.stopped(*body); };
            if (std::any_of(island.bodies.begin(), island.bodies.end(), stopped))
                add_stop(context_.world, island, state_.ledgers[i]);
        }
        return true;
    }

    void remember_choices() const
    {
        for (std::size_t i = 0; i < methods_.size(); ++i) remember_choice(islands_[i], methods_[i], hybrid_);
    }

    // Takes sleeping bodies out of the active ones, so that later steps skip them.
    void deactivate_sleeping() const
    {
        const auto& bodies = context_.world.bodies;
        const ActiveBodies left{bodies.active_count() - int(asleep_.size()), bodies.count()};
        if (context_.manages_contacts &&
            !state_.world_contacts.leaves_at_rest(*state_.world_contacts.live_space(), left))
            return;
        for (Body* body : asleep_) deactivate(*body);
        if (updates_contacts_) state_.world_contacts.lay_to_rest();
    }

    void accept_contacts() const
    {
        if (updates_contacts_) return state_.world_contacts.accept(context_.h, workers_.of_islands);
        if (context_.manages_contacts) state_.world_contacts.accept_settled(context_.h);
    }

    // Before sleeping bodies' pairs are laid to rest.
    void list_events() const
    {
        state_.events.begin_step(context_.world, updates_contacts_ ? &state_.world_contacts : nullptr);
    }

    void finish() { finish_.rest(state_.underway.unfinished); }

    // Restores the state before the step, with the count of steps: it seeds random orders.
    void take_back()
    {
        context_.contacts.take_back();
        undo_.restore();
        finish_.take_back();
        if (continuous_.marked())
            for (Body* body : undo_.bodies()) body_stepped(*body);
        --context_.world.step_count;
    }

  private:
    // All bodies sleep, and their contacts are up to date.
    bool is_settled() const
    {
        return context_.world.bodies.active_count() == 0 &&
               state_.world_contacts.is_settled(*state_.world_contacts.live_space());
    }

    bool find_unsupported()
    {
        state_.unsupported.clear();
        ContactWorld& contacts = state_.world_contacts;
        return !updates_contacts_ ||
               contacts.find_unsupported(context_.world, *contacts.live_space(), state_.unsupported);
    }

    bool find_contacts()
    {
        ContactWorld& contacts = state_.world_contacts;
        return !updates_contacts_ ||
               contacts.update(context_.world, *contacts.live_space(), context_.h, workers_.of_islands);
    }

    // Activates inactive bodies that an active one touches or holds by a joint; then finds the islands again.
    bool find_islands(Arena& arena)
    {
        World& world = context_.world;
        std::span<ManifoldEdge> manifolds;
        Islands found;
        do {
            if (updates_contacts_ && !state_.world_contacts.touching(workers_.of_islands, arena, manifolds))
                return false;
            if (!epode::find_islands(world, context_.h, manifolds, arena, found)) return false;
            if (world.reached.empty()) break;
        } while (activate_reached());
        EPODE_ASSERT(!world.reached.empty() || !fault_of(world, found, arena));
        islands_ = found.all, asleep_ = found.asleep;
        return world.reached.empty();
    }

    bool activate_reached()
    {
        World& world = context_.world;
        if (!updates_contacts_) return epode::activate_reached(world, [](Body&) { return true; });
        ContactWorld& contacts = state_.world_contacts;
        return epode::activate_reached(
                   world, [&](Body& body) { return contacts.bring_pairs(body, world.reached); }) &&
               contacts.list_brought(world);
    }

    // Islands have solvers of their own in hybrid steps, and in substeps where joints come apart.
    bool chooses() const { return hybrid_ || &context_.solver == &kTgs; }

    bool choose_methods(Arena& arena)
    {
        methods_ = arena.take<IslandMethod>(int(islands_.size()));
        if (arena.failed()) return false;
        if (hybrid_) return choose_hybrid_methods(context_.world, islands_, context_.h, arena, methods_);
        for (std::size_t i = 0; i < methods_.size(); ++i)
            methods_[i] = {&relieved(context_.solver, islands_[i])};
        return true;
    }

    const Solver& solver_of(std::size_t island) const
    {
        return methods_.empty() ? context_.solver : *methods_[island].solver;
    }

    // Consecutive islands that one solver solves together.
    struct Group {
        const Solver* solver;
        int first, count;
        int joints, weight;
        int first_contact;
    };

    // Has it nothing to solve? Substeps within an exact step know one island.
    bool is_free(std::size_t i) const
    {
        const Island& island = islands_[i];
        return island.joints.empty() && island.manifolds.empty() && context_.world.exact_substeps <= 1;
    }

    // Can the solver take several islands at once? It must support parts (SystemPart), and manifolds must not
    // become rows, because those are appended after the rows of all joints.
    bool makes_groups(const Solver& solver) const
    {
        return solver.contact_manifolds || (solver.joint_manifolds && !context_.manages_contacts);
    }

    // Can island i join the group of island i - 1? In substeps an island without joints is solved in another
    // way than one with joints, and kNetwork factorises the joints of one island at a time.
    bool may_join(std::size_t i) const
    {
        // All workers sweep over a large island together; each of the others has one worker.
        if (has_many_manifolds(i) || has_many_manifolds(i - 1)) return false;
        if (islands_[i].settles() != islands_[i - 1].settles()) return false;
        const Solver& solver = solver_of(i);
        if (solver.substeps && substep_factor(islands_[i]) != substep_factor(islands_[i - 1])) return false;
        const bool joints = !islands_[i].joints.empty(), before = !islands_[i - 1].joints.empty();
        if (&solver != &solver_of(i - 1)) return false;
        if (!makes_groups(solver)) return is_free(i) && is_free(i - 1);
        return !solver.contact_manifolds || (joints == before && !(joints && &solver == &kNetwork));
    }

    // Joins consecutive small islands to groups where may_join() allows it. Returns the number of joints.
    int make_groups()
    {
        int count = 0, contacts = 0;
        for (std::size_t i = 0; i < islands_.size(); ++i) {
            const int joints = int(islands_[i].joints.size()), w = weight(islands_[i]);
            const Solver& solver = solver_of(i);
            const int max_weight = solver.contact_manifolds ? kGroupOfManifolds : kGroup;
            const bool joins =
                count > 0 && may_join(i) && groups_[std::size_t(count - 1)].weight + w <= max_weight;
            if (!joins) groups_[std::size_t(count++)] = {&solver, int(i), 0, 0, 0, contacts};
            Group& group = groups_[std::size_t(count - 1)];
            ++group.count, group.joints += joints, group.weight += w;
            contacts += joints;
        }
        groups_ = groups_.first(std::size_t(count));
        return contacts;
    }

    bool has_many_manifolds(std::size_t island) const
    {
        return solver_of(island).contact_manifolds &&
               int(islands_[island].manifolds.size()) >= kLargeManifolds;
    }

    bool is_large(const Group& group) const
    {
        if (workers_.of_an_island.workers() <= 1) return false;
        return (group.solver->inner_tasks && group.joints >= kLarge) ||
               has_many_manifolds(std::size_t(group.first));
    }

    bool prepare_reports()
    {
        state_.reports.clear(), state_.ledgers.clear();
        const int count = int(islands_.size());
        return (!context_.world.report_wanted || state_.reports.resize(count)) &&
               (!state_.ledger_wanted || state_.ledgers.resize(count));
    }

    // Parcel p is the groups from parcels_[p] to parcels_[p + 1].
    int cut_parcels()
    {
        int count = 0, load = kParcel;
        for (std::size_t i = 0; i < groups_.size(); ++i) {
            if (is_large(groups_[i])) continue;
            if (load >= kParcel) parcels_[std::size_t(count++)] = int(i), load = 0;
            load += groups_[i].weight;
        }
        parcels_[std::size_t(count)] = int(groups_.size());
        return count;
    }

    void step_one(int i, const Tasks& tasks, int worker)
    {
        if (out_of_memory_.load(std::memory_order_relaxed)) return;
        const Group& group = groups_[std::size_t(i)];
        const auto first = std::size_t(group.first), count = std::size_t(group.count);
        IslandRecords records;
        if (context_.world.report_wanted) records.reports = state_.reports.span().subspan(first, count);
        if (state_.ledger_wanted) records.ledgers = state_.ledgers.span().subspan(first, count);
        const int draw = makes_groups(*group.solver) ? i : group.first;
        if (!step_islands(context_for(group), islands_.subspan(first, count),
                          {i, draw, group.first_contact, group.first}, tasks, memory_.arena(worker), records))
            return out_of_memory_.store(true);
        const Island done = joined(islands_.subspan(first, count));
        finish_.at_once(done.bodies, tasks);
    }

    StepContext context_for(const Group& group) const
    {
        const StepContext& c = context_;
        const int iterations = hybrid_ ? hybrid_iterations(c.world, *group.solver) : c.iterations;
        return {.world = c.world,
                .solver = *group.solver,
                .h = c.h,
                .iterations = iterations,
                .contacts = c.contacts,
                .symbolic_cache = c.symbolic_cache,
                .undo = c.undo,
                .runaways = c.runaways,
                .manages_contacts = c.manages_contacts,
                .methods = methods_};
    }

    const StepContext& context_;
    const bool hybrid_;
    StepState& state_;
    StepMemory& memory_;
    const Workers& workers_;
    std::span<Island> islands_;
    bool updates_contacts_ = false;
    std::span<Body*> asleep_;          // active bodies that have fallen asleep
    std::span<IslandMethod> methods_;  // by island; empty: all have the context's solver
    std::span<Group> groups_;
    std::span<int> parcels_;
    StepUndo& undo_;
    Continuous continuous_;
    Finish finish_;
    std::atomic<bool> out_of_memory_{false};
};

}  // namespace

StepState* step_state(World& world)
{
    if (!world.step_state) {
        void* memory = allocate(sizeof(StepState));
        if (!memory) return nullptr;
        world.step_state = new (memory) StepState;
        world.free_step_state = [](StepState* s) {
            s->~StepState();
            release(s, sizeof(StepState));
        };
    }
    return world.step_state;
}

namespace {

// What dWorldQuickStep means in this world.
const Solver* solver_in(const World& world, const Solver* solver)
{
    return solver == &kQuick && world.acts_as_ode() ? &kShuffled : solver;
}

// The step, when the working memory has been reserved for it; `solver` null: hybrid.
bool step_in(World& world, StepState& state, StepMemory& memory, const Solver* solver, Real h, int iterations)
{
    Workers workers;
    if (!workers.start(world, solver)) return false;
    StepUnderway& underway = state.underway;
    ++world.step_count, underway.counted = true;
    const std::uint32_t random = ProcessRandom::state();
    const StepContext context{.world = world,
                              .solver = solver ? *solver : kDirect,
                              .h = h,
                              .iterations = iterations,
                              .contacts = state.contacts,
                              .symbolic_cache = state.symbolic_cache,
                              .undo = *underway.undo,
                              .runaways = state.runaways,
                              .manages_contacts = state.world_contacts.live_space() != nullptr,
                              .methods = {}};
    WorldStep step(context, !solver, state, memory, workers);
    bool made = step.prepare();
    underway.ran = made;
    made = made && step.run() && step.stop_at_impacts();
    underway.made = made;
    if (made) {
        state.contacts.end(h);
        step.accept_contacts();
        break_joints(world, h);
        step.remember_choices();
        if (state.events.list().wants_any()) step.list_events();
        step.deactivate_sleeping();
        step.finish();
        clear_sleeping_forces(world);
        if (state.events.list().wants_any())
            state.events.end_step(world, state.world_contacts.live_space(), state.cut_short);
        if (world.report_wanted) world.report = sum_of(state.reports.span());
    } else {
        step.take_back();
        state.runaways.take_back(), state.cut_short.take_back();
        if (context.solver.draws) ProcessRandom::set_state(random);
        forget_loads(world);
    }
    workers.stop();
    world.report_made = made && world.report_wanted;
    state.ledger_made = made && state.ledger_wanted;
    return made;
}

bool step_with(World& world, const Solver* solver, Real h, int iterations, StepMemory* lent)
{
    const FloatEnvironment floats;
    const Stepping mark(world);
    // A program can write through the pointers that getters return: what was broken before, no step has to mend.
    [[maybe_unused]] const bool was_whole = kAsserts && !fault_of(world);
    StepState* state = step_state(world);
    StepMemory* memory = lent ? lent : working_memory(world);
    if (!state || !memory || !memory->begin()) return false;
    StepUnderway& underway = state->underway;
    underway.begin(world, *memory, h);
    for (StepObserver* o : state->observers())
        if (o && o->begin) o->begin(*o, world, h);
    const bool done = step_in(world, *state, *memory, solver_in(world, solver), h, iterations);
    underway.memory = nullptr;
    memory->end();
    for (StepObserver* o : state->observers())
        if (o && o->end) o->end(*o, world, h, done);
    EPODE_ASSERT_NO_FAULT(was_whole ? fault_of(world) : nullptr);
    return done;
}

}  // namespace

StepMemory* working_memory(World& world)
{
    if (!world.memory) world.memory = StepMemory::create();
    return world.memory;
}

void free_working_memory(World& world)
{
    if (world.memory) world.memory->free_blocks();
    if (world.step_state) world.step_state->symbolic_cache.clear();
}

bool step_world(World& world, const Solver& solver, Real h, int iterations, StepMemory* lent)
{
    return step_with(world, &solver, h, iterations, lent);
}

bool step_world_hybrid(World& world, Real h, StepMemory* lent)
{
    return step_with(world, nullptr, h, 0, lent);
}

void report_unusual(World& world)
{
    if (world.step_state) world.step_state->cut_short.report(world);
    // Its handler may have destroyed the world.
    if (world.step_state) world.step_state->runaways.report(world);
}

std::span<const dIslandStepReport> island_reports(const World& world)
{
    if (!world.report_made || !world.step_state) return {};
    return world.step_state->reports.span();
}

}  // namespace epode
