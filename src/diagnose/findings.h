// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What has been found so far: one entry for each kind and object, with its worst figure. Of fixed size, so
// that a step allocates nothing; once full, the worst of each kind has been named long ago.
#pragma once

#include "base/config.h"
#include "ode/diagnosis.h"

namespace epode {

// What a cause has seen in a step; fields as in dDiagnosis.
struct Finding {
    dDiagnosisKind kind;
    dSeverity severity;
    dBodyID body = nullptr, other = nullptr;
    dJointID joint = nullptr;
    dGeomID geom = nullptr;
    double figure = 0, threshold = 0;
    int call = 0;
};

class Findings {
  public:
    void begin_step() { ++step_; }
    int step() const { return step_; }
    // Of the step at hand. What is seen again keeps its worst figure and severity.
    void add(const Finding& seen);
    int count() const { return count_; }
    // The most severe first; then energy after its causes, what was seen first, kinds in their order.
    int ranked(dDiagnosis* out, int capacity) const;

  private:
    int place_for(const dDiagnosis& one) const;

    static constexpr int kCapacity = 64;  // of more, the first in rank are kept
    dDiagnosis all_[kCapacity];
    int seen_[kCapacity];  // in which step last
    int count_ = 0, step_ = 0;
};

}  // namespace epode
