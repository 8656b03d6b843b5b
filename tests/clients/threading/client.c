// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A program with threads of its own, written for ODE and run on ours and on Debian's library (run.sh): its
// implementation drives the steps of a world and the cooperative functions, and it uses the library's
// implementations directly. Every line that it prints is a judgement; a failed one ends with "WRONG" and makes
// the program return 1. `client bits` asks in addition that threads change no bit, which Debian's library does
// not promise.
#include <math.h>
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "own_threads.h"

static int g_wrong = 0;

static void judge(const char* what, int good)
{
    printf("%s: %s\n", what, good ? "ok" : "WRONG");
    g_wrong |= !good;
}

/* ---- a world of many islands: pendulums of 1 to 6 links, and one chain of 60 */

#define BODIES 411

struct scene {
    dWorldID world;
    dBodyID bodies[BODIES];
    int count;
};

static void add_chain(struct scene* s, dReal x, dReal y, int links)
{
    dBodyID before = NULL;
    for (int i = 0; i < links; ++i) {
        dBodyID b = dBodyCreate(s->world);
        dMass m;
        dMassSetBoxTotal(&m, 1 + (dReal)0.1 * (i % 5), (dReal)0.5, (dReal)0.2, (dReal)0.2);
        dBodySetMass(b, &m);
        dBodySetPosition(b, x + (dReal)0.5 * i + (dReal)0.25, y, 0);
        dBodySetAngularVel(b, (dReal)0.3 * (i % 3), (dReal)0.1 * i, 0);
        dJointID j = dJointCreateHinge(s->world, NULL);
        dJointAttach(j, b, before);
        dJointSetHingeAnchor(j, x + (dReal)0.5 * i, y, 0);
        dJointSetHingeAxis(j, 0, 1, i % 2 ? (dReal)0.5 : 0);
        s->bodies[s->count++] = b;
        before = b;
    }
}

static void build(struct scene* s)
{
    s->world = dWorldCreate();
    s->count = 0;
    dWorldSetGravity(s->world, 0, 0, (dReal)-9.81);
    for (int i = 0; i < 101; ++i) add_chain(s, 0, (dReal)(3 * i), 1 + i % 6);
    add_chain(s, 0, -5, 60);
}

typedef int step_function(dWorldID, dReal);

/* Runs the scene, writes positions and velocities of all bodies. */
static void run(const dThreadingFunctionsInfo* functions, dThreadingImplementationID impl,
                unsigned max_threads, step_function* step, int steps, double* out)
{
    static struct scene s;
    build(&s);
    dWorldSetStepIslandsProcessingMaxThreadCount(s.world, max_threads);
    if (dWorldGetStepIslandsProcessingMaxThreadCount(s.world) != max_threads)
        judge("thread limit is read back", 0);
    if (impl) dWorldSetStepThreadingImplementation(s.world, functions, impl);
    for (int i = 0; i < steps; ++i)
        if (step(s.world, (dReal)0.005) != 1) judge("a step was made", 0);
    if (impl) dWorldSetStepThreadingImplementation(s.world, NULL, NULL);
    for (int i = 0; i < s.count; ++i)
        for (int k = 0; k < 3; ++k) {
            *out++ = (double)dBodyGetPosition(s.bodies[i])[k];
            *out++ = (double)dBodyGetAngularVel(s.bodies[i])[k];
        }
    dWorldDestroy(s.world);
}

#define NUMBERS (6 * BODIES)

static double worst(const double* a, const double* b)
{
    double largest = 0;
    for (int i = 0; i < NUMBERS; ++i) {
        const double off = fabs(a[i] - b[i]) / (1 + fabs(a[i]));
        if (!(off <= largest)) largest = off; /* NaN too */
    }
    return largest;
}

/* QuickStep of the original draws random orders from all threads: there only the size is judged. */
static void compare(const char* what, const double* got, const double* alone, int bits, int quick)
{
    if (bits)
        judge(what, memcmp(got, alone, sizeof(double) * NUMBERS) == 0);
    else
        judge(what, worst(got, alone) < (quick ? 1 : 1e-9));
}

static void judge_counts(const char* what, const struct own_counts* c, unsigned steps, unsigned widest)
{
    printf("-- %s\n", what);
    judge("every step was prepared", c->prepared >= steps);
    judge("every step was posted and waited for", c->posted >= steps && c->waited >= steps);
    judge("all calls were finished", c->posted == c->finished);
    judge("only the program's threads ran calls", c->on_waiters == 0);
    judge("no more threads than allowed", c->widest >= 1 && c->widest <= widest);
    judge("every mutex was unlocked", c->locked == c->unlocked);
    judge("every wait and mutex group was freed",
          c->waits_made == c->waits_freed && c->groups_made == c->groups_freed);
}

static void own_implementation(step_function* step, const char* name, int bits)
{
    static double alone[NUMBERS], got[NUMBERS];
    const int steps = 40, quick = step == dWorldQuickStep;
    printf("== %s\n", name);
    run(NULL, NULL, 0, step, steps, alone);
    judge("the scene moves and stays finite", worst(alone, alone) == 0 && fabs(alone[4]) > 1e-3);
    dThreadingImplementationID impl = own_start(3);
    run(own_functions(), impl, 0, step, steps, got);
    compare("three threads compute what one does", got, alone, bits, quick);
    struct own_counts counts = own_count(impl);
    judge_counts("three threads", &counts, (unsigned)steps, 3);
    judge("no call was left", own_stop(impl) == 0);
    impl = own_start(1);
    run(own_functions(), impl, 1, step, steps, got);
    compare("so does a single one of the program's", got, alone, bits, quick);
    counts = own_count(impl);
    judge_counts("one thread", &counts, (unsigned)steps, 1);
    judge("no call was left", own_stop(impl) == 0);
}

static void built_in_implementations(step_function* step, const char* name, int bits)
{
    static double alone[NUMBERS], got[NUMBERS];
    const int steps = 40, quick = step == dWorldQuickStep;
    printf("== built-in, %s\n", name);
    run(NULL, NULL, 0, step, steps, alone);
    dThreadingImplementationID impl = dThreadingAllocateSelfThreadedImplementation();
    run(dThreadingImplementationGetFunctions(impl), impl, 0, step, steps, got);
    compare("self-threaded", got, alone, bits, quick);
    dThreadingFreeImplementation(impl);
    impl = dThreadingAllocateMultiThreadedImplementation();
    for (unsigned round = 1; round <= 3; ++round) {
        dThreadingThreadPoolID pool = dThreadingAllocateThreadPool(round, 0, dAllocateFlagBasicData, NULL);
        dThreadingThreadPoolServeMultiThreadedImplementation(pool, impl);
        const dThreadingFunctionsInfo* f = dThreadingImplementationGetFunctions(impl);
        judge("threads serve", f->retrieve_thread_count(impl) == round);
        run(f, impl, 0, step, steps, got);
        compare("multi-threaded", got, alone, bits, quick);
        dThreadingImplementationShutdownProcessing(impl);
        dThreadingThreadPoolWaitIdleState(pool);
        judge("no threads serve after the shutdown", f->retrieve_thread_count(impl) == 0);
        dThreadingImplementationCleanupForRestart(impl);
        dThreadingFreeThreadPool(pool);
    }
    dThreadingFreeImplementation(impl);
}

/* ---- cooperative functions */

#define ROWS 250
#define SKIP 252

static void cooperative(dThreadingImplementationID impl, const dThreadingFunctionsInfo* f, const char* name)
{
    static dReal A[ROWS * SKIP], L[ROWS * SKIP], K[ROWS * SKIP], d[ROWS], e[ROWS], x[ROWS], y[ROWS], b[ROWS];
    printf("== cooperative, %s\n", name);
    unsigned seed = 1;
    for (int i = 0; i < ROWS; ++i) {
        for (int j = 0; j <= i; ++j) {
            seed = seed * 1664525u + 1013904223u;
            A[i * SKIP + j] = A[j * SKIP + i] = i == j ? ROWS : (dReal)(seed >> 8) / (1 << 24) - (dReal)0.5;
        }
        b[i] = (dReal)(i % 7) - 3;
    }
    dCooperativeID coop = dCooperativeCreate(f, impl);
    dResourceRequirementsID r = dResourceRequirementsCreate(coop), s = dResourceRequirementsCreate(coop);
    dEstimateCooperativelyFactorLDLTResourceRequirements(r, 3, ROWS);
    dEstimateCooperativelySolveLDLTResourceRequirements(s, 3, ROWS);
    dEstimateCooperativelySolveL1StraightResourceRequirements(s, 3, ROWS);
    dEstimateCooperativelySolveL1TransposedResourceRequirements(s, 3, ROWS);
    dEstimateCooperativelyScaleVectorResourceRequirements(s, 3, ROWS);
    dResourceRequirementsMergeIn(r, s);
    dResourceRequirementsID t = dResourceRequirementsClone(r);
    dResourceContainerID c = dResourceContainerAcquire(t);
    judge("a container was acquired", c != NULL);

    memcpy(L, A, sizeof A);
    memcpy(K, A, sizeof A);
    memcpy(x, b, sizeof b);
    memcpy(y, b, sizeof b);
    dFactorLDLT(K, e, ROWS, SKIP);
    dCooperativelyFactorLDLT(c, 3, L, d, ROWS, SKIP);
    double off = 0, residual = 0;
    for (int i = 0; i < ROWS; ++i)
        for (int j = 0; j < i; ++j) off = fmax(off, fabs((double)(L[i * SKIP + j] - K[i * SKIP + j])));
    for (int i = 0; i < ROWS; ++i) off = fmax(off, fabs((double)(d[i] / e[i] - 1)));
    judge("factors are those of dFactorLDLT", off < 1e-13);
    dCooperativelySolveLDLT(c, 2, L, d, x, ROWS, SKIP);
    for (int i = 0; i < ROWS; ++i) {
        double sum = 0;
        for (int j = 0; j < ROWS; ++j) sum += (double)A[i * SKIP + j] * (double)x[j];
        residual = fmax(residual, fabs(sum - (double)b[i]));
    }
    judge("the solution solves", residual < 1e-12);
    dCooperativelySolveL1Straight(c, 3, L, y, ROWS, SKIP);
    dCooperativelyScaleVector(c, 3, y, d, ROWS);
    dCooperativelySolveL1Transposed(c, 3, L, y, ROWS, SKIP);
    off = 0;
    for (int i = 0; i < ROWS; ++i) off = fmax(off, fabs((double)(x[i] - y[i])));
    judge("its parts one by one agree", off < 1e-13);

    dResourceContainerDestroy(c);
    dResourceRequirementsDestroy(t);
    dResourceRequirementsDestroy(s);
    dResourceRequirementsDestroy(r);
    dCooperativeDestroy(coop);
}

/* ---- the library's own implementation, used directly */

static int g_sum;

static int add(void* context, dcallindex_t index, dCallReleaseeID self)
{
    (void)self;
    __atomic_add_fetch(&g_sum, (int)index, __ATOMIC_RELAXED);
    return context == NULL;
}

static int check_sum(void* context, dcallindex_t index, dCallReleaseeID self)
{
    (void)self;
    *(int*)context = __atomic_load_n(&g_sum, __ATOMIC_RELAXED) == (int)index;
    return 1;
}

static void direct(dThreadingImplementationID impl, const char* name)
{
    printf("== direct, %s\n", name);
    const dThreadingFunctionsInfo* f = dThreadingImplementationGetFunctions(impl);
    judge("the table has its size", f->struct_size == sizeof *f);
    judge("calls are prepared", f->preallocate_resources_for_calls(impl, 20) == 1);
    dCallWaitID wait = f->alloc_call_wait(impl);
    for (int faults = 0; faults < 2; ++faults) {
        int fault = 7, own = 7, whole = 0, status = 0;
        dCallReleaseeID all = NULL;
        g_sum = 0;
        f->reset_call_wait(impl, wait);
        f->post_call(impl, &fault, &all, 11, NULL, wait, check_sum, &whole, 55, "sum");
        for (int i = 0; i < 10; ++i) f->post_call(impl, NULL, NULL, 0, all, NULL, add, NULL, i + 1, "add");
        f->post_call(impl, &own, NULL, 0, all, NULL, add, faults ? &own : NULL, 0, "perhaps fail");
        f->wait_call(impl, &status, wait, NULL, "wait");
        judge("the dependent call came last", whole);
        judge("the wait succeeded", status == 1);
        judge("faults arrive", fault == faults && own == faults);
    }
    f->free_call_wait(impl, wait);
    const char* names[] = {"a", "b", "c"};
    dMutexGroupID group = f->alloc_mutex_group(impl, 3, names);
    f->lock_group_mutex(impl, group, 2);
    f->lock_group_mutex(impl, group, 0);
    f->unlock_group_mutex(impl, group, 2);
    f->unlock_group_mutex(impl, group, 0);
    f->free_mutex_group(impl, group);
}

int main(int argc, char** argv)
{
    const int bits = argc > 1 && strcmp(argv[1], "bits") == 0;
    setvbuf(stdout, NULL, _IOLBF, 0);
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    own_implementation(dWorldStep, "dWorldStep", bits);
    own_implementation(dWorldQuickStep, "dWorldQuickStep", bits);
    built_in_implementations(dWorldStep, "dWorldStep", bits);
    built_in_implementations(dWorldQuickStep, "dWorldQuickStep", bits);

    dThreadingImplementationID impl = own_start(3);
    cooperative(impl, own_functions(), "own threads");
    judge("no call was left", own_stop(impl) == 0);
    cooperative(NULL, NULL, "no threads");
    dThreadingImplementationID self = dThreadingAllocateSelfThreadedImplementation();
    direct(self, "self-threaded");
    dThreadingFreeImplementation(self);
    impl = dThreadingAllocateMultiThreadedImplementation();
    dThreadingThreadPoolID pool = dThreadingAllocateThreadPool(2, 0, dAllocateFlagBasicData, NULL);
    dThreadingThreadPoolServeMultiThreadedImplementation(pool, impl);
    direct(impl, "multi-threaded");
    cooperative(impl, dThreadingImplementationGetFunctions(impl), "multi-threaded");
    dThreadingImplementationShutdownProcessing(impl);
    dThreadingFreeThreadPool(pool);
    dThreadingFreeImplementation(impl);
    dCloseODE();
    return g_wrong;
}
