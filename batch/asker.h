// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Points of one pair of shapes of one copy, from the library's own pair functions: geoms of a thread's own, in no space, put where the
// copy's shapes are. What it answers depends on the two poses alone.
#pragma once

#include <ode/ode.h>

#include "batch/model/asked_pairs.h"

namespace epode::batch {

class PairAsker {
  public:
    explicit PairAsker(const AskedPairs& pairs);
    ~PairAsker();
    PairAsker(const PairAsker&) = delete;
    PairAsker& operator=(const PairAsker&) = delete;

    Asker asker();
    int ask(int pair, const AskedPose& a, const AskedPose& b, double reach, double layer, int most,
            AskedPoint* out) const;

  private:
    const AskedPairs& pairs_;
    std::vector<dGeomID> geoms_;
};

}  // namespace epode::batch
