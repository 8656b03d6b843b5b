// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// While a height function of the program runs, pair functions below it on the stack read geoms and heights
// that it could name. On that thread none are given up until it has come back, or has left them by longjmp or an
// exception (base/call_guard.h). A mark of the thread and not of the objects (GeomHold, collide/geom.h): a pair
// function knows shapes, not the geoms they belong to, and nothing is counted where no such function is called.
#pragma once

namespace epode {

class InHeightFunction {
  public:
    InHeightFunction() : mine_(calls), outer_(mine_.innermost), self_(this)
    {
        mine_.innermost = this;
        if (!outer_) mine_.outermost = this;
    }
    ~InHeightFunction() { mine_.innermost = outer_; }
    InHeightFunction(const InHeightFunction&) = delete;
    InHeightFunction& operator=(const InHeightFunction&) = delete;

    static bool now() { return calls.innermost && any_runs(); }

  private:
    struct Calls {
        const InHeightFunction *innermost, *outermost;
    };
    [[gnu::cold]] static bool any_runs();
    static bool runs(const InHeightFunction& call);

    // constinit, so that no thread asks whether it is made. Rejected: the initial-exec model, which saves a
    // call but lives in the loader's few spare bytes; a process that opens libraries late runs out of them
    // (tests/abi/late_dlopen.c).
    static constinit thread_local Calls calls;

    Calls& mine_;  // looked up once
    const InHeightFunction* const outer_;
    const InHeightFunction* const volatile self_;  // is overwritten when the stack is used again
};

}  // namespace epode

// Refuses a call that would give up what is in use.
#define EPODE_HEIGHT_FUNCTION_TEXT "Invalid operation inside a height function"
#define EPODE_OUTSIDE_HEIGHT_FUNCTION(...) \
    EPODE_USER_SAY(!::epode::InHeightFunction::now(), EPODE_HEIGHT_FUNCTION_TEXT __VA_OPT__(, ) __VA_ARGS__)
