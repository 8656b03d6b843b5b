// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How the state of a group of copies lies in memory: rows of as many numbers as it has lanes, counted here;
// `before` and `before_v` have the positions and velocities in which the last step began, accelerations what it gave. Angular velocities of floating bases are in
// the world's axes there; whoever reads them in the link's turns them.
#pragma once

#include "batch/model/model_view.h"

namespace epode::batch {

struct GroupLayout {
    int q, v, control, applied, forces, before, before_v, bad, residual, sweeps, activations, accelerations,
        rows;

    template <typename Model>
    EPODE_ALWAYS explicit GroupLayout(const Model& model)
        : q(0),
          v(q + model.positions),
          control(v + model.velocities),
          applied(control + model.controls),
          forces(applied + model.velocities),
          before(forces + model.impulses()),
          before_v(before + model.positions),
          bad(before_v + model.velocities),
          residual(bad + 1),
          sweeps(residual + 1),
          activations(sweeps + 1),
          accelerations(activations + model.filters),
          rows(accelerations + model.accelerations)
    {}
};

}  // namespace epode::batch
