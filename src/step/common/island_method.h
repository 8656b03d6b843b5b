// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How an island is to be stepped, and what came of it.
#pragma once

#include "math/vec.h"

namespace epode {

struct Stepper;

struct IslandMethod {
    const Stepper* stepper;
    int iterations = 0;
    // Of an exact solution that must not take more than `max_work` microseconds of counted work
    // (solve/common/work_meter.h): what takes its place then, and its number of substeps.
    const Stepper* fallback = nullptr;
    int fallback_iterations = 0;
    double max_work = kInf;

    double work = 0;        // of an exact solution
    bool gave_up = false;   // it would have taken more: the fallback has stepped the island
    bool strained = false;  // its joints came apart (step/island/strain.h)
    Real gap = 0;           // of its joints at the step's beginning, relative, likewise
};

}  // namespace epode
