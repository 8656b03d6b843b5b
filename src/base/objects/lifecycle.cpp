// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A table of fixed size: the number of owners of process-wide state is known when the library is written, and
// registering must not fail for lack of memory. Hooks run outside the lock, so a hook may register another
// one.
#include "base/objects/lifecycle.h"

#include <mutex>

#include "base/objects/pool.h"

namespace epode {
namespace {

constexpr int kCapacity = 32;

struct HookTable {
    SpinLock lock;
    int count = 0;
    void (*hooks[kCapacity])() = {};
};

HookTable g_table;

void (*hook_at(int i))()
{
    std::lock_guard guard(g_table.lock);
    return g_table.hooks[i];
}

int hook_count()
{
    std::lock_guard guard(g_table.lock);
    return g_table.count;
}

}  // namespace

bool on_last_close(void (*hook)()) noexcept
{
    std::lock_guard guard(g_table.lock);
    for (int i = 0; i < g_table.count; ++i)
        if (g_table.hooks[i] == hook) return true;
    if (g_table.count == kCapacity || !hook) return false;
    g_table.hooks[g_table.count++] = hook;
    return true;
}

void run_close_hooks() noexcept
{
    for (int i = hook_count(); i-- > 0;) hook_at(i)();
}

}  // namespace epode
