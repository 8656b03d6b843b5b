// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Moved callbacks, which the library calls in the middle of a step. One that only reads (a program that keeps
// the places of its bodies) changes nothing that a step computes, so the run can be made again without it.
// One that changes something does it at a moment that no recorded call has, so what it does is reported as beyond
// recordings (change(), real.h). Hence the library calls us, and we call the program's function, knowing that
// we do. The alternative, to refuse all programs with such callbacks, was there before.
#include <ode/ode.h>

#include <map>
#include <mutex>

#include "record/preload/real.h"

namespace {

using Callback = void (*)(dBodyID);

thread_local bool inside = false;

// Library functions may be called at the end of the process, when a map of ours is gone: it never goes.
struct Callbacks {
    std::mutex lock;
    std::map<dBodyID, Callback> of;
};
Callbacks& callbacks()
{
    static Callbacks& all = *new Callbacks;
    return all;
}

void moved(dBodyID body)
{
    Callback callback = nullptr;
    {
        const std::lock_guard guard(callbacks().lock);
        const auto found = callbacks().of.find(body);
        if (found != callbacks().of.end()) callback = found->second;
    }
    if (!callback) return;
    const bool before = inside;
    inside = true;
    callback(body);
    inside = before;
}

}  // namespace

namespace epode::record {

bool in_callback() { return inside; }

}  // namespace epode::record

extern "C" void dBodySetMovedCallback(dBodyID body, Callback callback)
{
    EPODE_REAL_VOID(dBodySetMovedCallback);
    if (!epode::record::observer()) return real(body, callback);
    {
        const std::lock_guard guard(callbacks().lock);
        callbacks().of[body] = callback;
    }
    real(body, callback ? &moved : nullptr);
}
