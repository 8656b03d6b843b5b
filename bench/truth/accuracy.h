// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How right the answers are, in tests that have a truth: the four of SimBenchmark that need no robot, a
// capsule held between two pads, a chain with a heavy end. bench/accuracy runs them on two libraries and sets
// the published figures next to them.
#pragma once

#include <string>

#include "scenes/scene.h"

namespace epode::bench {

struct AccuracyOptions {
    std::string test;
    scenes::Stepper stepper = scenes::Stepper::kExact;
    double dt = 1e-3;
    std::string variant;  // what is special about this run; each test has its own
    double size = 0;      // each test's own parameter; 0: its default
    std::string trace;    // whip: a file for the gap after every step; empty: none
};

struct AccuracyResult {
    bool available = true;  // false: the library at hand has no such thing
    bool ok = false;        // the run was made and its state is finite
    double error = 0;       // in the test's own measure
    double seconds = 0;     // of wall time in collide, step and empty
    std::string details;    // more "key value" pairs
};

// Kang and Hwangbo, SimBenchmark (2018); errors are means over the steps.
//   rolling      (m/s)^2  box and one ball against the closed form; variant: y, xy, xy-fdir
//   bouncing     J^2      total energy
//   666          m^2      sum of the squares of all penetrations
//   elastic-666  J^2      total energy
AccuracyResult run_rolling(const AccuracyOptions& options);
AccuracyResult run_bouncing(const AccuracyOptions& options);
AccuracyResult run_666(const AccuracyOptions& options);
AccuracyResult run_elastic_666(const AccuracyOptions& options);
// m/s of slip of a held capsule; size: the normal load in newton.
AccuracyResult run_grasp(const AccuracyOptions& options);
// Links of gap of a chain with a heavy end; size: the end's mass over a link's. variant: plain, projected,
// nudged (plain from a start that is 1e-12 m/s different: what chaos alone makes of rounding).
AccuracyResult run_whip(const AccuracyOptions& options);

// 0 fine, 1 a run that failed, 2 wrong usage, 3 the library has no such thing.
int bench_accuracy(const AccuracyOptions& options);

}  // namespace epode::bench
