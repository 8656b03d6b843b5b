// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Memory: a scene of constant size is stepped without touching the allocator once it has warmed up, and all
// three steppers, collision included, step a pile of 1,000 boxes on a thread whose stack is 128 KiB. (A
// sanitizer's frames are several times larger and its minutes too: there 216 boxes on 1 MiB.)
#if !defined(__wasm__)
#include <pthread.h>
#endif

#include <atomic>
#include <cstdlib>

#include "scenes.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PHYSICS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PHYSICS_SANITIZED 1
#endif
#endif

namespace epode::physics {
namespace {

std::atomic<int> calls{0};

void* counted_alloc(dsizeint size)
{
    ++calls;
    return std::malloc(size);
}
void* counted_realloc(void* p, dsizeint, dsizeint size)
{
    ++calls;
    return std::realloc(p, size);
}
void counted_free(void* p, dsizeint)
{
    ++calls;
    std::free(p);
}

struct Counting {
    Counting()
    {
        dSetAllocHandler(&counted_alloc);
        dSetReallocHandler(&counted_realloc);
        dSetFreeHandler(&counted_free);
    }
    ~Counting()
    {
        dSetAllocHandler(nullptr);
        dSetReallocHandler(nullptr);
        dSetFreeHandler(nullptr);
    }
};

TEST(TrustMemory, a_settled_pile_is_stepped_without_any_allocation)
{
    for (Stepper stepper : kSteppers) {
        const Counting counting;
        Sim sim(stepper);
        build(sim, Scene::kPile);
        sim.steps(400, 0.01);
        EXPECT_GT(calls.load(), 0) << "the counters are in use";
        sim.steps(100, 0.01);
        calls = 0;
        for (int i = 0; i < 100; ++i) sim.step(0.01);
        EXPECT_EQ(calls.load(), 0) << name_of(stepper);
        EXPECT_GT(sim.contact_count, 30);
    }
}

TEST(TrustMemory, a_running_machine_is_stepped_without_any_allocation)
{
    for (Stepper stepper : kSteppers) {
        const Counting counting;
        Sim sim(stepper);
        build(sim, Scene::kMachine);
        for (int i = 0; i < 50; ++i) sim.advance(0.01);
        calls = 0;
        for (int i = 0; i < 100; ++i) sim.advance(0.01);
        EXPECT_EQ(calls.load(), 0) << name_of(stepper);
    }
}

#if !defined(__wasm__)  // it has no threads
// Boxes in layers, each shifted by half a box over the one below: one island.
void build_block(Sim& sim, int side, int layers)
{
    sim.gravity(0, 0, -9.81);
    sim.ground();
    for (int k = 0; k < layers; ++k)
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const double shift = k % 2 ? 0.25 : 0;
                sim.box({0.5 * i + shift, 0.5 * j + shift, 0.199 + 0.398 * k}, {0.49, 0.49, 0.4}, 1);
            }
}

struct SmallStack {
    Sim* sim;
    int steps = 0;
    int done = 0;
};

void* step_on_small_stack(void* p)
{
    auto& job = *static_cast<SmallStack*>(p);
    for (int i = 0; i < job.steps; ++i) job.done += job.sim->step(0.005);
    return nullptr;
}

TEST(TrustMemory, a_thousand_boxes_are_stepped_on_a_stack_of_128_ki_b)
{
#if defined(PHYSICS_SANITIZED)
    const std::size_t stack = 1024 * 1024;
    const int side = 6;
#else
    const std::size_t stack = 128 * 1024;
    const int side = 10;
#endif
    for (Stepper stepper : kSteppers) {
        Sim sim(stepper);
        sim.substeps = 4;
        build_block(sim, side, side);
        ASSERT_EQ(sim.bodies.size(), std::size_t(side) * side * side);
        SmallStack job{&sim, stepper == Stepper::kExact ? 2 : 5};
        pthread_attr_t attributes;
        ASSERT_EQ(pthread_attr_init(&attributes), 0);
        ASSERT_EQ(pthread_attr_setstacksize(&attributes, stack), 0);
        pthread_t thread;
        ASSERT_EQ(pthread_create(&thread, &attributes, &step_on_small_stack, &job), 0);
        pthread_join(thread, nullptr);
        pthread_attr_destroy(&attributes);
        EXPECT_EQ(job.done, job.steps) << name_of(stepper);
        EXPECT_GT(sim.contact_count, 3 * int(sim.bodies.size())) << "they are piled up";
        EXPECT_TRUE(finite_state(sim)) << name_of(stepper);
    }
}
#endif

}  // namespace
}  // namespace epode::physics
