// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is neither motion nor shape: text dumps, memory, threads, tests of ODE's own.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "difference.h"

namespace differences {
namespace {

DIFFERENCE(D44, joints, "dWorldExportDIF names a double ball joint")
{
    const World world;
    attached(dJointCreateDBall(world.id, nullptr), world.body(), world.body(1, 0, 0));
    char* text = nullptr;
    std::size_t length = 0;
    FILE* file = open_memstream(&text, &length);
    dWorldExportDIF(world.id, file, "");
    std::fclose(file);
    return !std::strstr(text, "unknown");
}

DIFFERENCE(V1, memory, "a memory manager without functions is refused and the program goes on")
{
    const World world;
    dWorldStepMemoryFunctionsInfo functions = {};
    functions.struct_size = sizeof(functions);
    dWorldSetStepMemoryManager(world.id, &functions);
    world.body();
    world.step();
    return true;
}

DIFFERENCE(V2, tests, "dTestDataStructures comes to an end")
{
    dTestDataStructures();
    return true;
}

DIFFERENCE(T1, unserved, "calls of an implementation that no thread serves are run by who waits for them")
{
    const dThreadingImplementationID impl = dThreadingAllocateMultiThreadedImplementation();
    const dThreadingFunctionsInfo* f = dThreadingImplementationGetFunctions(impl);
    const dCallWaitID wait = f->alloc_call_wait(impl);
    int done = 0;
    const auto call = [](void* context, dcallindex_t, dCallReleaseeID) {
        return *static_cast<int*>(context) = 1;
    };
    f->post_call(impl, nullptr, nullptr, 0, nullptr, wait, call, &done, 0, "call");
    f->wait_call(impl, nullptr, wait, nullptr, "call");
    return done == 1;
}

double stack_height(unsigned threads)
{
    const World world;
    const dThreadingImplementationID impl = dThreadingAllocateMultiThreadedImplementation();
    const dThreadingThreadPoolID pool =
        dThreadingAllocateThreadPool(threads, 0, dAllocateFlagBasicData, nullptr);
    dThreadingThreadPoolServeMultiThreadedImplementation(pool, impl);
    dWorldSetStepThreadingImplementation(world.id, dThreadingImplementationGetFunctions(impl), impl);
    dWorldSetGravity(world.id, 0, 0, -10);
    dRandSetSeed(1);
    std::vector<dBodyID> bodies;
    for (int chain = 0; chain < 20; ++chain)
        for (int i = 0; i < 20; ++i) {
            bodies.push_back(world.body(i, chain, 0.1 * (i % 7)));
            const dJointID ball = attached(dJointCreateBall(world.id, nullptr), bodies.back(),
                                           i ? bodies[bodies.size() - 2] : nullptr);
            dJointSetBallAnchor(ball, i - 0.5, chain, 0);
        }
    for (int i = 0; i < 100; ++i) dWorldQuickStep(world.id, kStep);
    double height = 0;
    for (const dBodyID b : bodies) height += dBodyGetPosition(b)[2];
    dThreadingImplementationShutdownProcessing(impl);
    dThreadingFreeThreadPool(pool);
    dWorldSetStepThreadingImplementation(world.id, nullptr, nullptr);
    dThreadingFreeImplementation(impl);
    return height;
}

DIFFERENCE(T2, repeats, "dWorldQuickStep repeats itself on four threads")
{
    const double once = stack_height(4);
    for (int i = 0; i < 5; ++i)
        if (stack_height(4) != once) return false;
    return true;
}

}  // namespace
}  // namespace differences
