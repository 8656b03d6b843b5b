// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "heap.h"

#include <atomic>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

namespace epode::memory {
namespace {

std::atomic<long> g_held{0}, g_asked{0}, g_fail_at{-1};
std::atomic<bool> g_for_good{false}, g_failed{false};
std::atomic<int> g_messages{0};

void* take(dsizeint size)
{
    const long number = g_asked++;
    const long bad = g_fail_at;
    if (bad >= 0 && (number == bad || (g_for_good && number > bad))) {
        g_failed = true;
        return nullptr;
    }
    void* p = std::malloc(size);
    if (p) ++g_held;
    return p;
}

void* change(void* p, dsizeint, dsizeint size) { return std::realloc(p, size); }

void give(void* p, dsizeint)
{
    if (p) --g_held;
    std::free(p);
}

void receive(int, const char*, va_list) { ++g_messages; }
void ignore(int, const char*, va_list) {}

}  // namespace

long Heap::held() { return g_held; }
long Heap::asked() { return g_asked; }
bool Heap::failed() { return g_failed; }
void Heap::count() { fail_at(-1, false); }
void Heap::fail_at(long number, bool for_good)
{
    g_asked = 0;
    g_failed = false;
    g_for_good = for_good;
    g_fail_at = number;
}

Library::Library()
{
    dSetAllocHandler(take);
    dSetReallocHandler(change);
    dSetFreeHandler(give);
    dSetDebugHandler(receive);
    dSetMessageHandler(ignore);
    Heap::count();
    dInitODE2(0);
}

Library::~Library()
{
    dCloseODE();
    EXPECT_EQ(Heap::held(), 0) << "blocks leak";
    dSetAllocHandler(nullptr);
    dSetReallocHandler(nullptr);
    dSetFreeHandler(nullptr);
    dSetDebugHandler(nullptr);
    dSetMessageHandler(nullptr);
}

int messages() { return g_messages; }

int step(dWorldID world, Stepper stepper, dReal h)
{
    switch (stepper) {
        case Stepper::kExact:
            return dWorldStep(world, h);
        case Stepper::kQuick:
            return dWorldQuickStep(world, h);
        default:
            return dWorldStepFast1(world, h, 4);
    }
}

void set_up(dWorldID world, const Setting& setting)
{
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    dWorldSetStepThreads(world, setting.threads);
    if (!setting.options) return;
    dWorldSetExactSubsteps(world, 2);
    dWorldSetStepProjection(world, 2);
    dWorldSetExactRotation(world, 1);
    dWorldSetStepReportMode(world, 1);
    dWorldSetEnergyLedgerMode(world, 1);
}

std::string name_of(const testing::TestParamInfo<Setting>& info)
{
    const char* stepper[] = {"exact", "quick", "fast"};
    return std::string(stepper[int(info.param.stepper)]) + "_" + std::to_string(info.param.threads) +
           "_threads" + (info.param.options ? "_with_options" : "");
}

std::uint64_t hash_of(const std::vector<dBodyID>& bodies)
{
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&](const dReal* v, int count) {
        unsigned char bytes[12 * sizeof(dReal)];
        std::memcpy(bytes, v, std::size_t(count) * sizeof(dReal));
        for (std::size_t i = 0; i < std::size_t(count) * sizeof(dReal); ++i)
            hash = (hash ^ bytes[i]) * 1099511628211u;
    };
    for (dBodyID b : bodies) {
        add(dBodyGetPosition(b), 3), add(dBodyGetQuaternion(b), 4), add(dBodyGetRotation(b), 12);
        add(dBodyGetLinearVel(b), 3), add(dBodyGetAngularVel(b), 3);
        add(dBodyGetForce(b), 3), add(dBodyGetTorque(b), 3);
    }
    return hash;
}

bool finite(dBodyID body)
{
    for (const dReal* v : {dBodyGetPosition(body), dBodyGetLinearVel(body), dBodyGetAngularVel(body)})
        for (int i = 0; i < 3; ++i)
            if (!std::isfinite(v[i])) return false;
    return true;
}

}  // namespace epode::memory
