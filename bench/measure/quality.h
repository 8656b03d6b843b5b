// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The quality of a state, from the scene's data and the state alone: the same ruler for every engine.
//   penetration   of overlapping pairs (overlap.h), meshes other than the terrain left out, m
//   joint error   how far a joint lets its anchors part, along a hinge-2's spring left out, in links
//   drift         how far bodies that should stand are from where they should be, m
//   energy        kinetic and potential above the start, over the weight: m of height
//   speed         root of the mean square over the mass, with rotation, m/s
//   lost          bodies below the scene's bottom, or with their centre under the terrain
#pragma once

#include "bench/scenes/drive.h"

namespace epode::bench {

using State = std::vector<BodyState>;  // one entry a body of the scene

struct Quality {
    double penetration_max = 0, penetration_mean = 0;
    int overlaps = 0;
    double joint_error_max = 0, joint_error_mean = 0;
    double drift_max = 0, drift_mean = 0;
    double energy = 0, speed = 0;
    int lost = 0, not_finite = 0;
};

Quality judge(const SceneData& scene, const State& state);

}  // namespace epode::bench
