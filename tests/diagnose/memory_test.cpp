// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Without memory the mode stays what it was and a step is made as if it were off; a warm step allocates
// nothing; texts are cut off where they do not fit.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cstdlib>
#include <cstring>

namespace {

int allocations = 0, left = -1;  // left: -1 without end

bool may_allocate()
{
    ++allocations;
    return left < 0 || left-- > 0;
}

void* counted_alloc(dsizeint size) { return may_allocate() ? std::malloc(size) : nullptr; }
void* counted_realloc(void* block, dsizeint, dsizeint size)
{
    return may_allocate() ? std::realloc(block, size) : nullptr;
}
void counted_free(void* block, dsizeint) { std::free(block); }

struct Hooks {
    Hooks()
    {
        dSetAllocHandler(counted_alloc), dSetReallocHandler(counted_realloc), dSetFreeHandler(counted_free);
        dSetMessageHandler(nothing), dSetDebugHandler(nothing);
        dInitODE2(0);
        world = dWorldCreate();
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        for (int i = 0; i < 5; ++i) dBodySetPosition(dBodyCreate(world), dReal(2 * i), 0, 0);
    }
    ~Hooks()
    {
        left = -1;
        dWorldDestroy(world);
        dCloseODE();
        dSetAllocHandler(nullptr), dSetReallocHandler(nullptr), dSetFreeHandler(nullptr);
        dSetMessageHandler(nullptr), dSetDebugHandler(nullptr);
    }
    static void nothing(int, const char*, va_list) {}
    dWorldID world;
};

TEST(DiagnosisMemory, without_memory_the_mode_stays_off)
{
    Hooks hooks;
    for (left = 0; dWorldGetDiagnosisMode(hooks.world) == 0; ++left) {
        const int available = left;
        ASSERT_LT(available, 10);
        dWorldSetDiagnosisMode(hooks.world, 1);
        left = available;
    }
    EXPECT_GT(left, 1) << "no call was without memory";
}

TEST(DiagnosisMemory, a_step_without_memory_for_notes_is_made)
{
    Hooks hooks;
    dWorldQuickStep(hooks.world, dReal(0.01));
    dWorldSetDiagnosisMode(hooks.world, 1);
    for (int available = 0; available < 8; ++available) {
        left = available;
        EXPECT_EQ(dWorldQuickStep(hooks.world, dReal(0.01)), 1);
    }
    left = -1;
    dBodySetLinearVel(dBodyCreate(hooks.world), dReal(1e7), 0, 0);
    EXPECT_EQ(dWorldQuickStep(hooks.world, dReal(0.01)), 1);
    EXPECT_EQ(dWorldDiagnose(hooks.world, nullptr, 0), 1);
}

TEST(DiagnosisMemory, a_warm_step_allocates_nothing)
{
    Hooks hooks;
    dWorldSetDiagnosisMode(hooks.world, 1);
    for (int i = 0; i < 3; ++i) dWorldQuickStep(hooks.world, dReal(0.01));
    allocations = 0;
    for (int i = 0; i < 10; ++i) dWorldQuickStep(hooks.world, dReal(0.01));
    EXPECT_EQ(allocations, 0);
}

TEST(DiagnosisMemory, texts_are_cut_and_bad_causes_refused)
{
    Hooks hooks;
    dDiagnosis cause{};
    char text[20] = "unchanged";
    for (int kind = dDiagnosisInput; kind <= dDiagnosisEnergy; ++kind) {
        cause.kind = kind;
        EXPECT_GT(dDiagnosisText(&cause, text, sizeof text), 60);
        EXPECT_EQ(std::strlen(text), sizeof text - 1);
    }
    text[0] = 'x';
    cause.kind = dDiagnosisEnergy + 1;
    EXPECT_EQ(dDiagnosisText(&cause, text, sizeof text), 0);
    cause.kind = -1;
    EXPECT_EQ(dDiagnosisText(&cause, text, sizeof text), 0);
    cause.kind = 0, cause.severity = 3;
    EXPECT_EQ(dDiagnosisText(&cause, text, sizeof text), 0);
    EXPECT_EQ(text[0], 'x');
    EXPECT_EQ(dWorldDiagnose(hooks.world, nullptr, 5), 0);
    dWorldSetDiagnosisMode(hooks.world, 2);
    EXPECT_EQ(dWorldGetDiagnosisMode(hooks.world), 0);
}

}  // namespace
