// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// While a height function of the program runs, pair functions below it on the stack read geoms and heights
// that it could name. On that thread none are given up until it has come back. A count per thread and not a
// mark on the objects (GeomHold, collide/geom.h): a pair function knows shapes, not the geoms they belong to,
// and nothing is counted where no such function is called.
#pragma once

namespace epode {

class InHeightFunction {
  public:
    InHeightFunction() : mine_(depth) { ++mine_; }
    ~InHeightFunction() { --mine_; }
    InHeightFunction(const InHeightFunction&) = delete;
    InHeightFunction& operator=(const InHeightFunction&) = delete;

    static bool now() { return depth > 0; }

  private:
    // constinit, so that no thread asks whether it is made. Rejected: the initial-exec model, which saves a
    // call but lives in the loader's few spare bytes; a process that opens libraries late runs out of them
    // (tests/abi/late_dlopen.c).
    static constinit thread_local int depth;

    int& mine_;  // looked up once
};

}  // namespace epode

// Refuses a call that would give up what is in use.
#define EPODE_HEIGHT_FUNCTION_TEXT "Invalid operation inside a height function"
#define EPODE_OUTSIDE_HEIGHT_FUNCTION(...) \
    EPODE_USER_SAY(!::epode::InHeightFunction::now(), EPODE_HEIGHT_FUNCTION_TEXT __VA_OPT__(, ) __VA_ARGS__)
