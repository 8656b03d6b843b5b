// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Steps as calls of a threading implementation: the library's own, served by a pool or by threads of the
// program, and programs' own, good and bad. Always the bits of one thread.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <thread>

#include "scenes.h"

namespace epode::physics {
namespace {

// The library's implementation: served by `threads` of a pool, or 0: self-threaded.
struct Built {
    explicit Built(unsigned threads)
    {
        id = threads ? dThreadingAllocateMultiThreadedImplementation()
                     : dThreadingAllocateSelfThreadedImplementation();
        if (!threads) return;
        pool = dThreadingAllocateThreadPool(threads, 0, dAllocateFlagBasicData, nullptr);
        dThreadingThreadPoolServeMultiThreadedImplementation(pool, id);
    }
    Built(const Built&) = delete;
    Built& operator=(const Built&) = delete;
    ~Built()
    {
        dThreadingImplementationShutdownProcessing(id);
        dThreadingFreeThreadPool(pool);
        dThreadingFreeImplementation(id);
    }
    const dThreadingFunctionsInfo* functions() const { return dThreadingImplementationGetFunctions(id); }
    void serve(dWorldID world) const { dWorldSetStepThreadingImplementation(world, functions(), id); }

    dThreadingImplementationID id = nullptr;
    dThreadingThreadPoolID pool = nullptr;
};

std::uint64_t run(Scene scene, Stepper stepper, const Built* built, unsigned max_threads = 0)
{
    Sim sim(stepper);
    if (built) built->serve(sim.world);
    dWorldSetStepIslandsProcessingMaxThreadCount(sim.world, max_threads);
    build(sim, scene, 2);
    sim.steps(steps_of(scene) / 5, 0.01);
    return hash_state(sim);
}

constexpr unsigned kThreads[] = {0, 1, 2, 4};  // 0: self-threaded

TEST(Threads, implementations_of_the_library_give_the_bits_of_one_thread)
{
    for (Scene scene : kScenes)
        for (Stepper stepper : kSteppers) {
            const std::uint64_t alone = run(scene, stepper, nullptr);
            for (unsigned threads : kThreads) {
                const Built built(threads);
                EXPECT_EQ(run(scene, stepper, &built), alone)
                    << name_of(scene) << ' ' << name_of(stepper) << ' ' << threads;
            }
        }
}

// Columns of boxes far from each other: an island each.
void build_columns(Sim& sim, int count)
{
    sim.gravity(0, 0, -9.81);
    sim.ground();
    Random random(4);
    for (int i = 0; i < count; ++i) {
        velocity(sim.box({3.0 * i, 0, 0.5}, {1, 1, 1}, 1 + i % 7), random.point(1), random.point(1));
        if (i % 3 == 0) sim.box({3.0 * i, 0, 1.5}, {1, 1, 1}, 1);
    }
}

// A tree of balls on joints: one island, large enough to be factored by subtrees.
void build_tree(Sim& sim, int links)
{
    sim.gravity(0, 0, -9.81);
    for (int i = 0; i < links; ++i) {
        const V3 at{double(i % 50), double(i / 50), 0.01 * (i % 7)};
        const dBodyID b = sim.body(at, 1, 0.2);
        dJointID j = dJointCreateBall(sim.world, nullptr);
        dJointAttach(j, b,
                     i % 50 ? sim.bodies[std::size_t(i - 1)]
                     : i    ? sim.bodies[std::size_t(i - 50)]
                            : nullptr);
        dJointSetBallAnchor(j, real(at.x), real(at.y), 0);
    }
}

template <typename Build>
std::uint64_t run_built(Stepper stepper, const Built* built, Build build, int steps)
{
    Sim sim(stepper);
    if (built) built->serve(sim.world);
    build(sim);
    sim.steps(steps, 0.01);
    EXPECT_TRUE(finite_state(sim));
    return hash_state(sim);
}

TEST(Threads, many_islands_as_calls_give_the_bits_of_one_thread)
{
    const auto columns = [](Sim& sim) { build_columns(sim, 200); };
    for (Stepper stepper : kSteppers) {
        const std::uint64_t alone = run_built(stepper, nullptr, columns, 6);
        for (unsigned threads : kThreads) {
            const Built built(threads);
            EXPECT_EQ(run_built(stepper, &built, columns, 6), alone) << name_of(stepper) << ' ' << threads;
        }
    }
}

TEST(Threads, parts_of_a_large_island_as_calls_give_the_bits_of_one_thread)
{
    const auto tree = [](Sim& sim) { build_tree(sim, 5000); };
    const std::uint64_t alone = run_built(Stepper::kExact, nullptr, tree, 2);
    for (unsigned threads : {1u, 2u, 4u}) {
        const Built built(threads);
        EXPECT_EQ(run_built(Stepper::kExact, &built, tree, 2), alone) << threads;
    }
}

// ---- implementations of a program. The first passes everything on to the library's and keeps count.

struct Watch {
    Built built;
    std::atomic<int> posted{0}, waits{0}, prepared{0}, made{0}, freed{0}, inside{0}, widest{0}, on_caller{0};
    std::thread::id caller = std::this_thread::get_id();
    bool prepares = true, has_waits = true;
    explicit Watch(unsigned threads) : built(threads) {}
};
Watch* g_watch = nullptr;

struct Watched {
    dThreadedCallFunction* function;
    void* context;
};

int watched(void* context, dcallindex_t index, dCallReleaseeID self)
{
    auto* call = static_cast<Watched*>(context);
    const int now = ++g_watch->inside;
    for (int seen = g_watch->widest; seen < now && !g_watch->widest.compare_exchange_weak(seen, now);) {}
    if (std::this_thread::get_id() == g_watch->caller) ++g_watch->on_caller;
    const int result = call->function(call->context, index, self);
    --g_watch->inside;
    delete call;
    return result;
}

dThreadingFunctionsInfo watching_table()
{
    dThreadingFunctionsInfo f = *g_watch->built.functions();
    f.alloc_call_wait = [](dThreadingImplementationID id) {
        ++g_watch->made;
        return g_watch->has_waits ? g_watch->built.functions()->alloc_call_wait(id) : nullptr;
    };
    f.free_call_wait = [](dThreadingImplementationID id, dCallWaitID wait) {
        ++g_watch->freed;
        g_watch->built.functions()->free_call_wait(id, wait);
    };
    f.post_call = [](dThreadingImplementationID id, int* fault, dCallReleaseeID* name,
                     ddependencycount_t count, dCallReleaseeID dependent, dCallWaitID wait,
                     dThreadedCallFunction* function, void* context, dcallindex_t index, const char* text) {
        ++g_watch->posted;
        EXPECT_NE(text, nullptr);
        g_watch->built.functions()->post_call(id, fault, name, count, dependent, wait, watched,
                                              new Watched{function, context}, index, text);
    };
    f.wait_call = [](dThreadingImplementationID id, int* status, dCallWaitID wait,
                     const dThreadedWaitTime* limit, const char* text) {
        ++g_watch->waits;
        g_watch->built.functions()->wait_call(id, status, wait, limit, text);
    };
    f.preallocate_resources_for_calls = [](dThreadingImplementationID id, ddependencycount_t calls) {
        ++g_watch->prepared;
        return g_watch->prepares ? g_watch->built.functions()->preallocate_resources_for_calls(id, calls) : 0;
    };
    return f;
}

TEST(Threads, a_step_goes_through_the_functions_that_the_program_gave)
{
    Watch watch(3);
    g_watch = &watch;
    Sim sim(Stepper::kExact);
    {
        const dThreadingFunctionsInfo table = watching_table();
        dWorldSetStepThreadingImplementation(sim.world, &table, watch.built.id);
    }  // the table was copied
    dWorldSetStepThreads(sim.world, 2);
    build_columns(sim, 200);
    sim.steps(4, 0.01);
    EXPECT_EQ(watch.prepared, 4);
    EXPECT_EQ(watch.made, 4);
    EXPECT_EQ(watch.freed, 4);
    EXPECT_EQ(watch.waits, 4);
    EXPECT_EQ(watch.posted, 4 * 4);  // three parts and the one that waits for them
    EXPECT_LE(watch.widest, 3);
    EXPECT_EQ(watch.on_caller, 0);

    dWorldSetStepIslandsProcessingMaxThreadCount(sim.world, 2);
    watch.posted = watch.widest = 0;
    sim.steps(4, 0.01);
    EXPECT_EQ(watch.posted, 4 * 3);
    EXPECT_LE(watch.widest, 2);
    dWorldSetStepIslandsProcessingMaxThreadCount(sim.world, 1);
    watch.posted = 0;
    sim.steps(4, 0.01);
    EXPECT_EQ(watch.posted, 4);

    dWorldSetStepThreadingImplementation(sim.world, nullptr, nullptr);
    watch.posted = 0;
    sim.step(0.01);
    EXPECT_EQ(watch.posted, 0);
    EXPECT_EQ(dWorldGetStepThreads(sim.world), 2);  // in force again
}

TEST(Threads, a_large_island_is_shared_out_in_many_jobs)
{
    Watch watch(2);
    g_watch = &watch;
    const dThreadingFunctionsInfo table = watching_table();
    Sim sim(Stepper::kExact);
    build_tree(sim, 5000);
    dWorldSetStepThreadingImplementation(sim.world, &table, watch.built.id);
    EXPECT_EQ(sim.advance(0.01), 1);
    EXPECT_GE(watch.waits, 3);
    EXPECT_EQ(watch.posted, 3 * watch.waits);
    EXPECT_EQ(watch.on_caller, 0);
    dWorldSetStepThreadingImplementation(sim.world, nullptr, nullptr);
}

TEST(Threads, a_step_that_cannot_be_prepared_changes_nothing)
{
    Watch watch(2);
    g_watch = &watch;
    Sim sim(Stepper::kQuick);
    build_columns(sim, 20);
    const dThreadingFunctionsInfo table = watching_table();
    dWorldSetStepThreadingImplementation(sim.world, &table, watch.built.id);
    sim.steps(3, 0.01);
    const std::uint64_t before = hash_state(sim);
    watch.prepares = false;
    EXPECT_EQ(sim.advance(0.01), 0);
    watch.prepares = true;
    watch.has_waits = false;
    EXPECT_EQ(sim.advance(0.01), 0);
    EXPECT_EQ(hash_state(sim), before);
    watch.has_waits = true;
    EXPECT_EQ(sim.advance(0.01), 1);
    EXPECT_NE(hash_state(sim), before);
    EXPECT_EQ(watch.made, watch.freed + 1);
}

// An implementation that does not wait; what it does with calls differs. Its handle is never looked into.
struct Careless {
    enum Manner { kLoses, kLate, kAtOnce, kSilent } manner;
    std::vector<Watched> kept;
};
Careless* g_careless = nullptr;

void careless_post(dThreadingImplementationID, int* fault, dCallReleaseeID* name, ddependencycount_t count,
                   dCallReleaseeID, dCallWaitID, dThreadedCallFunction* function, void* context,
                   dcallindex_t index, const char*)
{
    if (fault) *fault = 1;
    if (name)
        *name = g_careless->manner == Careless::kSilent ? nullptr : reinterpret_cast<dCallReleaseeID>(1);
    if (count > 0) return;
    if (g_careless->manner == Careless::kLate) g_careless->kept.push_back({function, context});
    if (g_careless->manner == Careless::kAtOnce || g_careless->manner == Careless::kSilent)
        function(context, index, nullptr);
}

TEST(Threads, an_implementation_that_loses_delays_or_hurries_calls_cannot_spoil_a_step)
{
    const auto columns = [](Sim& sim) { build_columns(sim, 200); };
    const std::uint64_t alone = run_built(Stepper::kQuick, nullptr, columns, 5);
    for (const Careless::Manner manner :
         {Careless::kLoses, Careless::kLate, Careless::kAtOnce, Careless::kSilent}) {
        Careless careless{manner, {}};
        g_careless = &careless;
        dThreadingFunctionsInfo f = *Built(0).functions();
        f.alloc_call_wait = [](dThreadingImplementationID) { return reinterpret_cast<dCallWaitID>(1); };
        f.free_call_wait = f.reset_call_wait = [](dThreadingImplementationID, dCallWaitID) {};
        f.post_call = careless_post;
        f.wait_call = [](dThreadingImplementationID, int* status, dCallWaitID, const dThreadedWaitTime*,
                         const char*) {
            if (status) *status = 0;
        };
        f.retrieve_thread_count = [](dThreadingImplementationID) { return 3u; };
        f.preallocate_resources_for_calls = [](dThreadingImplementationID, ddependencycount_t) { return 1; };
        Sim sim(Stepper::kQuick);
        columns(sim);
        dWorldSetStepThreadingImplementation(sim.world, &f, reinterpret_cast<dThreadingImplementationID>(1));
        sim.steps(5, 0.01);
        EXPECT_EQ(hash_state(sim), alone) << int(manner);
        for (const Watched& late : careless.kept) EXPECT_EQ(late.function(late.context, 0, nullptr), 1);
    }
}

// ---- lives

TEST(Threads, a_world_outlives_its_implementation)
{
    Messages messages;
    Sim sim;
    build_columns(sim, 3);
    {
        const Built built(2);
        built.serve(sim.world);
        EXPECT_EQ(sim.step(0.01), 1);
    }
    EXPECT_EQ(messages.count(), 0);
    const std::uint64_t before = hash_state(sim);
    EXPECT_EQ(sim.advance(0.01), 0);
    EXPECT_EQ(hash_state(sim), before);
    EXPECT_GT(messages.count(), 0);
    dWorldSetStepThreadingImplementation(sim.world, nullptr, nullptr);
    EXPECT_EQ(sim.advance(0.01), 1);
}

TEST(Threads, an_implementation_may_be_shut_down_and_served_again_between_steps)
{
    const std::uint64_t alone = run_built(
        Stepper::kExact, nullptr, [](Sim& s) { build_columns(s, 150); }, 40);
    const dThreadingImplementationID id = dThreadingAllocateMultiThreadedImplementation();
    Sim sim;
    build_columns(sim, 150);
    dWorldSetStepThreadingImplementation(sim.world, dThreadingImplementationGetFunctions(id), id);
    for (int i = 0; i < 10; ++i) {
        sim.steps(2, 0.01);  // nobody serves
        const dThreadingThreadPoolID pool = dThreadingAllocateThreadPool(1 + unsigned(i) % 3, 0, 0, nullptr);
        dThreadingThreadPoolServeMultiThreadedImplementation(pool, id);
        sim.steps(1, 0.01);
        dThreadingImplementationShutdownProcessing(id);
        sim.steps(1, 0.01);  // threads on their way out
        dThreadingFreeThreadPool(pool);
        dThreadingImplementationCleanupForRestart(id);
    }
    EXPECT_EQ(hash_state(sim), alone);
    dWorldSetStepThreadingImplementation(sim.world, nullptr, nullptr);
    dThreadingFreeImplementation(id);
}

TEST(Threads, worlds_share_an_implementation)
{
    const Built built(2);
    const std::uint64_t alone = run_built(
        Stepper::kQuick, nullptr, [](Sim& s) { build_columns(s, 150); }, 8);
    std::uint64_t hashes[3] = {};
    std::vector<std::thread> threads;
    for (std::uint64_t& hash : hashes)
        threads.emplace_back([&] {
            hash = run_built(
                Stepper::kQuick, &built, [](Sim& s) { build_columns(s, 150); }, 8);
        });
    for (std::thread& t : threads) t.join();
    for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, alone);
}

struct StepCall {
    const Built* built;
    std::uint64_t hash;
};

int step_in_a_call(void* context, dcallindex_t, dCallReleaseeID)
{
    auto& call = *static_cast<StepCall*>(context);
    call.hash = run_built(
        Stepper::kQuick, call.built, [](Sim& s) { build_columns(s, 150); }, 4);
    return 1;
}

TEST(Threads, a_world_may_be_stepped_inside_a_call_of_its_own_implementation)
{
    const std::uint64_t alone = run_built(
        Stepper::kQuick, nullptr, [](Sim& s) { build_columns(s, 150); }, 4);
    for (unsigned threads : {0u, 1u, 2u}) {
        const Built built(threads);
        const dThreadingFunctionsInfo* f = built.functions();
        StepCall calls[3] = {{&built, 0}, {&built, 0}, {&built, 0}};
        const dCallWaitID wait = f->alloc_call_wait(built.id);
        for (StepCall& call : calls)
            f->post_call(built.id, nullptr, nullptr, 0, nullptr, wait, step_in_a_call, &call, 0, "step");
        f->wait_call(built.id, nullptr, wait, nullptr, "steps");
        for (const StepCall& call : calls) EXPECT_EQ(call.hash, alone) << threads;
        f->free_call_wait(built.id, wait);
    }
}

TEST(Threads, what_makes_no_implementation_is_refused)
{
    Messages messages;
    Sim sim;
    const Built built(0);
    dThreadingFunctionsInfo f = *built.functions();
    dWorldSetStepThreadingImplementation(nullptr, &f, built.id);
    dWorldSetStepThreadingImplementation(sim.world, &f, nullptr);
    dWorldSetStepThreadingImplementation(sim.world, nullptr, built.id);
    f.struct_size = sizeof f - 1;
    dWorldSetStepThreadingImplementation(sim.world, &f, built.id);
    f.struct_size = sizeof f;
    f.post_call = nullptr;
    dWorldSetStepThreadingImplementation(sim.world, &f, built.id);
    EXPECT_EQ(messages.count(), 5);
    // During a step.
    static dWorldID world;
    world = sim.world;
    dBodySetMovedCallback(sim.body({0, 0, 0}),
                          [](dBodyID) { dWorldSetStepThreadingImplementation(world, nullptr, nullptr); });
    built.serve(sim.world);
    EXPECT_EQ(sim.advance(0.01), 1);
    EXPECT_EQ(messages.count(), 6);
    dWorldSetStepThreadingImplementation(sim.world, nullptr, nullptr);
}

std::atomic<int> g_allocations{0};

TEST(Threads, a_warm_step_allocates_nothing)
{
    const Built built(3);
    Sim sim(Stepper::kExact);
    built.serve(sim.world);
    for (int i = 0; i < 300; ++i) sim.body({3.0 * i, 0, 0});
    for (int i = 0; i < 300; ++i) sim.advance(0.01);  // so that every thread has had its turn
    g_allocations = 0;
    dSetAllocHandler([](dsizeint size) {
        ++g_allocations;
        return std::malloc(size);
    });
    for (int i = 0; i < 20; ++i) EXPECT_EQ(sim.advance(0.01), 1);
    dSetAllocHandler(nullptr);
    EXPECT_EQ(g_allocations, 0);
}

}  // namespace
}  // namespace epode::physics
