// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Motions that keep their energy, judged three ways: how much the energy changes, compared with exact steps with
// exact rotation and without projection at the same step size, and compared with twice the step size, where a
// method must be worse.
#pragma once

#include "measure.h"

namespace epode::trials {

// Builds the motion on the stage, runs it and returns the largest change of its energy as a share.
using EnergyError = double (*)(Stage&);

// Records the laws "energy", %, "reference", "monotone".
void record_energy(Run& run, EnergyError error, Vec gravity = {0, 0, -kGravity});

// The largest change of the energy in so many seconds, as a share of scale.
double energy_error(Stage& stage, double seconds, double scale);

// The three laws; bound: of the first, %.
std::vector<Law> energy_laws(Bound bound);

}  // namespace epode::trials
