// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Histories without memory: each allocation of each function fails once. And with memory: a warm step takes
// none.
#include <cstdlib>

#include "scene.h"

namespace epode::states {
namespace {

int g_left = -1;  // allocations until one fails; below 0: none does
int g_taken = 0;

void* alloc(dsizeint size) { return ++g_taken, g_left >= 0 && g_left-- == 0 ? nullptr : std::malloc(size); }
void* grow(void* block, dsizeint, dsizeint size)
{
    return ++g_taken, g_left >= 0 && g_left-- == 0 ? nullptr : std::realloc(block, size);
}
void give(void* block, dsizeint) { std::free(block); }

class Hooks {
  public:
    Hooks() { dSetAllocHandler(&alloc), dSetReallocHandler(&grow), dSetFreeHandler(&give); }
    ~Hooks() { dSetAllocHandler(nullptr), dSetReallocHandler(nullptr), dSetFreeHandler(nullptr); }
    Hooks(const Hooks&) = delete;
    Hooks& operator=(const Hooks&) = delete;
};

// How often `call` fails until it has all the memory that it wants.
template <typename Call>
int failures(Call&& call)
{
    for (int failed = 0;; ++failed) {
        g_left = failed;
        const bool done = call() == 1;
        const bool starved = g_left < 0;
        g_left = -1;
        EXPECT_TRUE(done || starved) << Messages::last();
        if (done || !starved) return failed;
    }
}

TEST(HistoryMemory, each_allocation_may_fail)
{
    const Hooks hooks;
    const Messages messages;
    Scene scene({.piles = 2});
    scene.steps(5);
    EXPECT_GT(failures([&] {
                  const int done = dWorldSetHistory(scene.world, 6);
                  EXPECT_EQ(dWorldGetHistory(scene.world), done ? 6 : 0);
                  return done;
              }),
              3);
    scene.steps(6);
    const Bytes past = scene.save();
    scene.steps(3);
    // Structure has changed: the roll-back has all to do.
    const dBodyID body = scene.bodies[3];
    const dGeomID geom = dBodyGetFirstGeom(body);
    dBodyDestroy(body), dGeomDestroy(geom), dBodyCreate(scene.world);
    scene.step();
    const Bytes before = scene.save();
    EXPECT_GT(failures([&] {
                  const int done = dWorldRollBack(scene.world, 4);
                  if (!done) { EXPECT_EQ(difference(scene.save(), before), "") << Messages::last(); }
                  return done;
              }),
              3);
    EXPECT_EQ(difference(scene.save(), past), "");
    EXPECT_EQ(dGeomGetBody(geom), body);
}

TEST(HistoryMemory, a_step_without_memory_for_its_frame_begins_a_new_history)
{
    const Hooks hooks;
    const Messages messages;
    Scene scene({.world_contacts = false, .joints = false, .piles = 1}),
        twin({.world_contacts = false, .joints = false, .piles = 1});
    for (Scene* s : {&scene, &twin}) s->steps(30);
    ASSERT_EQ(dWorldSetHistory(scene.world, 40), 1);
    int lost = 0;
    for (int i = 0; i < 60; ++i) {
        if (i % 3 == 0) g_left = 0;
        const int before = Messages::count(), had = dWorldGetHistoryFrames(scene.world);
        if (dWorldStep(scene.world, dReal(0.01)) == 1) {
            ASSERT_EQ(dWorldStep(twin.world, dReal(0.01)), 1);
            const bool emptied = dWorldGetHistoryFrames(scene.world) < had;
            lost += emptied;
            EXPECT_TRUE(!emptied || Messages::count() > before);
            EXPECT_TRUE(Messages::count() == before || dWorldGetHistoryFrames(scene.world) == 0);
        }
        g_left = -1;
        ASSERT_EQ(difference(scene.save(), twin.save()), "");
    }
    EXPECT_GT(lost, 0);
    EXPECT_GT(dWorldGetHistoryFrames(scene.world), 0);
    EXPECT_EQ(dWorldRollBack(scene.world, 1), 1);
}

TEST(HistoryMemory, a_warm_step_takes_none)
{
    const Hooks hooks;
    Scene scene({.stepper = Stepper::kSubsteps});
    dWorldSetHistory(scene.world, 10);
    scene.steps(600);
    g_taken = 0;
    scene.steps(20);
    EXPECT_EQ(g_taken, 0);
}

}  // namespace
}  // namespace epode::states
