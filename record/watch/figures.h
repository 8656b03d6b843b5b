// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step's record says of a world as a whole, for those who know the world by its public functions
// alone.
#pragma once

#include <ode/ode.h>

#include "record/watch/recorder.h"

namespace epode::record {

// Kinetic 1/2 m v.v + 1/2 w.I w, potential -m g.x of bodies that feel gravity, worst joint gap; kinematic
// bodies have no energy. time, dt and ms are left alone.
void measure(dWorldID world, const std::vector<dBodyID>& bodies, const std::vector<dJointID>& joints,
             StepFigures& figures);

}  // namespace epode::record
