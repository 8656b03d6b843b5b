// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Threads may refuse at once, so numbers are drawn from a counter and slots are atomics. A slot that is
// overwritten while it is read tells of two refusals at once; both have been.
#include "base/refusals.h"

#include <atomic>

namespace epode {
namespace {

struct Slot {
    std::atomic<int> call{0};
    std::atomic<const void*> world{nullptr};
    std::atomic<dBodyID> body{nullptr};
    std::atomic<dJointID> joint{nullptr};
};

constexpr int kMaxCalls = 1024;  // more than there are C functions

std::atomic<int> g_watchers{0};
std::atomic<std::uint64_t> g_count{0};
Slot g_slots[kRefusalsKept];
std::atomic<const char*> g_names[kMaxCalls];
thread_local Refusal t_concerned;

// Of a string that lives as long as the library. 0: the table is full.
int number_of_call(const char* function)
{
    for (int i = 0; i < kMaxCalls; ++i) {
        const char* present = nullptr;
        if (g_names[i].compare_exchange_strong(present, function) || present == function) return i + 1;
    }
    return 0;
}

}  // namespace

void watch_refusals(bool on) { g_watchers.fetch_add(on ? 1 : -1); }

void concern(const Refusal& objects) { t_concerned = objects; }

void remember_refusal(const char* function)
{
    const Refusal concerned = t_concerned;
    t_concerned = {};
    if (g_watchers.load(std::memory_order_relaxed) == 0) return;
    Slot& slot = g_slots[g_count.load() % kRefusalsKept];
    slot.call = number_of_call(function), slot.world = concerned.world;
    slot.body = concerned.body, slot.joint = concerned.joint;
    g_count.fetch_add(1);
}

std::uint64_t refusal_count() { return g_count.load(); }

Refusal refusal(std::uint64_t number)
{
    const Slot& slot = g_slots[number % kRefusalsKept];
    return {slot.call, slot.world, slot.body, slot.joint};
}

const char* name_of_call(int call)
{
    return call > 0 && call <= kMaxCalls ? g_names[call - 1].load() : nullptr;
}

}  // namespace epode
