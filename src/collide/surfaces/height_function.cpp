// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "collide/surfaces/height_function.h"

#include "base/call_guard.h"

namespace epode {

constinit thread_local InHeightFunction::Calls InHeightFunction::calls = {};

[[gnu::noinline, gnu::no_sanitize_address]] bool InHeightFunction::runs(const InHeightFunction& call)
{
    return !CallGuard::is_left(&call) && call.self_ == &call;
}

// Those between the two are forgotten with the innermost.
bool InHeightFunction::any_runs()
{
    if (runs(*calls.innermost)) return true;
    calls.innermost = runs(*calls.outermost) ? calls.outermost : nullptr;
    return calls.innermost;
}

}  // namespace epode
