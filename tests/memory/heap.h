// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Memory handlers that count what is held, and that fail on demand: the allocation of a given number, or all
// from it on. And the library between dInitODE and dCloseODE on such a heap; all messages are counted.
#pragma once

#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace epode::memory {

inline constexpr bool kSingle = sizeof(dReal) == 4;

struct Heap {
    static long held();    // blocks
    static long asked();   // allocations since the last call of fail_at() or count()
    static bool failed();  // has one been refused since?
    static void count();   // from zero, none fails
    static void fail_at(long number, bool for_good);
};

class Library {
  public:
    Library();
    ~Library();  // expects every block back
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

int messages();  // on the debug channel so far

enum class Stepper { kExact, kQuick, kFast };
inline constexpr Stepper kSteppers[] = {Stepper::kExact, Stepper::kQuick, Stepper::kFast};
int step(dWorldID world, Stepper stepper, dReal h);

// How a test steps.
struct Setting {
    Stepper stepper;
    int threads;
    bool options;  // small exact steps, projection, exact rotation, report
};
void set_up(dWorldID world, const Setting& setting);
std::string name_of(const testing::TestParamInfo<Setting>& info);

// Of pose, velocities and accumulators.
std::uint64_t hash_of(const std::vector<dBodyID>& bodies);
bool finite(dBodyID body);

}  // namespace epode::memory
