// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The quality of a state, by the public API only, so that any library is judged by the same ruler.
//   penetration   the deepest contact of the last collision pass, m; touching.h parts rest from impact
//   joint error   the distance that a joint lets its two anchors part, m; along a slider's axis and a
//   suspension's travel they may energy        kinetic, 1/2 m v.v + 1/2 w.I w, and potential, -m g.x; springs
//   (soft constraints) are not counted momentum      linear sum m v; angular about the common centre of mass,
//   which uniform gravity does not change
// Angles between joint axes are not part of joint error: metres and radians have no common maximum.
#pragma once

#include "scenes/scene.h"
#include "scenes/touching.h"

namespace epode::scenes {

struct Quality {
    double penetration = 0;
    double joint_error = 0;
    double kinetic = 0, potential = 0;
    double mass = 0;
    double momentum[3] = {0, 0, 0};
    double spin[3] = {0, 0, 0};                 // angular momentum about the centre of mass
    double momentum_scale = 0, spin_scale = 0;  // sums of the magnitudes of the parts
    double max_speed = 0;
    int not_finite = 0;  // bodies with a number that is NaN or infinite

    double energy() const { return kinetic + potential; }
};

Quality measure(const Scene& scene);

double penetration(const Scene& scene);
double joint_error(const JointRecord& record);
double worst_joint_error(const Scene& scene);
int bodies_not_finite(const Scene& scene);

// One run, watched step by step: worst values, drifts, time spent.
class RunRecord {
  public:
    explicit RunRecord(const Scene& scene);
    // After each step. Asks the library for its report too, if it has one.
    Quality observe(const Scene& scene);

    int steps = 0;
    std::vector<StepTimes> times;
    double contacts_sum = 0;
    size_t contacts_max = 0;
    double penetration = 0, joint_error = 0, max_speed = 0;
    int not_finite = 0;
    bool has_residual = false;
    double residual = 0, last_residual = 0;
    int fallbacks = 0, contained_islands = 0, rows_max = 0;
    Quality first, last;
    double energy_scale = 0;      // the most energy seen to move: kinetic, or potential away from the start
    double energy_peak_rise = 0;  // the highest energy above that of the start
    double momentum_drift = 0;    // worst |p - p0 - m g t|
    double spin_drift = 0;        // worst |L - L0|
    double momentum_scale = 0, spin_scale = 0;
    Touching touching;

    double contacts_mean() const { return steps ? contacts_sum / steps : 0; }
};

// The value below which the share `part` (0..1) of the values lies. 0 for none.
double quantile(std::vector<double> values, double part);

}  // namespace epode::scenes
