// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dInitODE and dCloseODE: a counter. Everything in the library works without initialisation (worlds and
// geoms are often made before it); what the last close does is run the hooks of base/objects/lifecycle.h, which
// forget user geom classes and give memory of the program's own handlers back. No thread has data of its own
// to allocate, so the thread functions only keep ODE's rules of when they may be called.
#include "ode/odeinit.h"

#include <atomic>

#include "base/check.h"
#include "base/objects/lifecycle.h"

using namespace epode;

namespace {

std::atomic<int> g_initialized{0};

// Counts down; the count that was reached, or -1 if there was nothing to close.
int count_down()
{
    int count = g_initialized.load();
    while (count > 0)
        if (g_initialized.compare_exchange_weak(count, count - 1)) return count - 1;
    return -1;
}

}  // namespace

extern "C" int dInitODE2(unsigned int)
{
    g_initialized.fetch_add(1);
    return 1;
}

extern "C" void dInitODE(void) { dInitODE2(0); }

extern "C" void dCloseODE(void)
{
    const int left = count_down();
    EPODE_USER_SAY(left >= 0, "dCloseODE must not be called without dInitODE2 or if dInitODE2 fails");
    if (left == 0) run_close_hooks();
}

extern "C" int dAllocateODEDataForThread(unsigned int)
{
    EPODE_USER_SAY(g_initialized.load() > 0, "Call dInitODE2 first", 0);
    return 1;
}

extern "C" void dCleanupODEAllDataForThread(void)
{
    EPODE_USER_SAY(g_initialized.load() > 0,
                   "Call dInitODE2 first or delay dCloseODE until all threads exit");
}
