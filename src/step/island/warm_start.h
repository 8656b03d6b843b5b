// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The impulses that a solution starts from are those of the last step; its own are kept for the next. Joints remember theirs
// (problem/joint_memory.h), contact joints are found again in the contact cache, world-managed contacts keep theirs in their
// manifolds.
#pragma once

#include "step/island/blows.h"
#include "step/island/island_run.h"

namespace epode {

struct WarmStart {
    Real share = 1;                 // of the last step's impulses, if the world asks for warm starting
    int substeps = 0;               // in which joints find their impulses; 0: none
    int solutions = 1;              // of which the step is made, each from the impulses of its part
    bool has_manifold_rows = true;  // world-managed contacts are rows
};

void load_warm_start(IslandRun& run, const WarmStart& how);
// For sweeps, which end before they have converged: a share of it where all of it makes energy (fitting_start.h). Contacts alone
// have arms that are too short for that.
void load_fitting_start(IslandRun& run, const WarmStart& how);
// `blows`: contacts whose impulses do not count.
void keep_impulses(IslandRun& run, const WarmStart& how, const Blows& blows = {});

}  // namespace epode
